#include "lodlab/live/page/controls.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/live/choices.hpp"

namespace live {
namespace {

void check_choice(const std::string& control, const std::string& word) {
    const StageChoice* choice = find_stage_choice(control);
    if (choice == nullptr)
        throw lod::Error(lod::ErrorKind::usage,
                         "the control " + control + " offers no choice '" + word + "'");
    if (std::find(choice->words.begin(), choice->words.end(), word) == choice->words.end())
        lod::refuse_choice(control, word, choice->words);
}

}  // namespace

void check_controls(std::string_view controls) {
    std::istringstream items{std::string(controls)};
    for (std::string item; std::getline(items, item, ',');) {
        std::istringstream words(item);
        std::string name;
        words >> name;
        if (std::find(control_names.begin(), control_names.end(), name) == control_names.end()) {
            std::string names;
            for (const std::string_view known : control_names)
                names += (names.empty() ? "" : ", ") + std::string(known);
            throw lod::Error(lod::ErrorKind::usage,
                             "no control '" + name + "'; there are: " + names);
        }
        for (std::string word; words >> word;) check_choice(name, word);
    }
}

}  // namespace live
