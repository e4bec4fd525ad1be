#include "cli/commands/lessons/named_lesson.hpp"

#include <string_view>
#include <vector>

#include "cli/arguments/misused.hpp"
#include "lodlab/scenes/spelling.hpp"

namespace cli {

lessons::Entry named_lesson(const std::string& word) {
    if (const auto found = lessons::find_lesson(word)) return *found;
    const std::vector<lessons::Entry> all = lessons::list();
    std::vector<std::string_view> names;
    for (const lessons::Entry& entry : all) names.emplace_back(entry.slug);
    misused("no lesson " + word + scenes::did_you_mean(word, names) + "; there are 1 to " +
            std::to_string(all.size()) + ", and lodlab lesson lists them");
}

}  // namespace cli
