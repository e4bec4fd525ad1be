#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "cli/arguments/misused.hpp"
#include "lodlab/core/base/names.hpp"
#include "lodlab/scenes/spelling.hpp"

namespace cli {

/// The choices that an option lists, parted by commas. Throws lod::Error (usage) for an unknown
/// one.
template <class Choice>
[[nodiscard]] std::vector<Choice> choices_in(const std::string& text, const char* option) {
    std::vector<Choice> choices;
    for (const std::string& part : scenes::parted(text, ',')) {
        const std::optional<Choice> found = lod::named<Choice>(part);
        const auto names = names_of(Choice{});
        if (!found)
            misused(std::string(option) + " must be of " + scenes::listed(names) + ", not " + part +
                    scenes::did_you_mean(part, names));
        if (std::find(choices.begin(), choices.end(), *found) != choices.end())
            misused(std::string(option) + " names " + part + " twice; name it once");
        choices.push_back(*found);
    }
    return choices;
}

/// The word for a choice as pictures write it: with blanks.
template <class Choice>
[[nodiscard]] std::string in_words(Choice choice) {
    std::string words(lod::name_of(choice));
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

}  // namespace cli
