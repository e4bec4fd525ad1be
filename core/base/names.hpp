#pragma once

/// \file
/// From a choice (an enum) to the word for it in scenes, options and messages, and back.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "lodlab/core/base/error.hpp"

namespace lod {

/// What scenes, options and messages call a choice. Every such enum has its names beside it, in a
/// function names_of(Choice) that gives them in the order of the enum.
template <class Choice>
[[nodiscard]] constexpr std::string_view name_of(Choice choice) {
    return names_of(choice)[static_cast<std::size_t>(choice)];
}

/// The choice that has that name in names_of; nothing where none has it.
template <class Choice>
[[nodiscard]] constexpr std::optional<Choice> listed(std::string_view name) {
    const auto names = names_of(Choice{});
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<Choice>(i);
    return std::nullopt;
}

/// The same, for users: specialised where a choice had another name before.
template <class Choice>
[[nodiscard]] constexpr std::optional<Choice> named(std::string_view name) {
    return listed<Choice>(name);
}

/// Every choice, in the order of the enum.
template <class Choice>
[[nodiscard]] constexpr auto choices() {
    std::array<Choice, names_of(Choice{}).size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Choice>(i);
    return all;
}

/// The choice of that name. Throws Error (usage) where there is none, naming all that there are;
/// `what` is what a choice is called: "builder of circle trees".
template <class Choice>
[[nodiscard]] Choice chosen(std::string_view name, std::string_view what) {
    if (const std::optional<Choice> choice = named<Choice>(name)) return *choice;
    refuse_choice(what, name, names_of(Choice{}));
}

}  // namespace lod
