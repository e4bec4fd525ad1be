#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {

// What shapes of the plane and of space make alike of a builder's settings and of generators.

/// A builder's settings as a tree is asked for; `what` is what a builder is called in errors.
template <class Settings>
[[nodiscard]] Settings settings_of(const TreeChoice& choice, std::string_view what) {
    Settings settings;
    if (!choice.builder.empty())
        settings.builder = lod::chosen<decltype(settings.builder)>(choice.builder, what);
    if (choice.branching) settings.branching = *choice.branching;
    if (choice.depth) settings.depth = *choice.depth;
    if (choice.error) settings.least_protrusion = *choice.error;
    if (choice.most_nodes) settings.most_nodes = *choice.most_nodes;
    return settings;
}

/// The names of all builders, the default first.
template <class Settings>
[[nodiscard]] std::vector<std::string_view> builder_names() {
    const auto standard = Settings{}.builder;
    std::vector<std::string_view> names{lod::name_of(standard)};
    for (const auto builder : lod::choices<decltype(Settings::builder)>())
        if (builder != standard) names.push_back(lod::name_of(builder));
    return names;
}

template <class Generator>
[[nodiscard]] std::vector<GeneratorNote> notes_of(std::span<const Generator> generators) {
    std::vector<GeneratorNote> notes;
    for (const Generator& one : generators)
        notes.push_back({std::string(one.name), one.usage(), std::string(one.description)});
    return notes;
}

}  // namespace scenes
