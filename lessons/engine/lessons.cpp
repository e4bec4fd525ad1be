#include "lessons/engine/lessons.hpp"

#include <algorithm>

#include "lessons/engine/embedded.hpp"
#include "lodlab/core/base/error.hpp"

namespace lessons {
namespace {

Entry entry_of(const Source& source) {
    const std::size_t underscore = source.slug.find('_');
    return {std::stoi(source.slug.substr(0, underscore)), source.slug.substr(underscore + 1),
            find_title(source.markdown, source.slug + "/lesson.md")};
}

}  // namespace

std::vector<Entry> list() {
    std::vector<Entry> entries;
    for (const EmbeddedLesson& lesson : embedded_lessons())
        entries.push_back(entry_of(lesson.source));
    return entries;
}

std::optional<Entry> find_lesson(const std::string& word) {
    std::vector<Entry> holding;
    for (Entry& entry : list()) {
        if (entry.slug == word || std::to_string(entry.number) == word) return entry;
        if (!word.empty() && entry.slug.find(word) != std::string::npos)
            holding.push_back(std::move(entry));
    }
    if (holding.size() != 1) return {};
    return holding.front();
}

Lesson run(int number) {
    const auto& all = embedded_lessons();
    const auto found = std::find_if(all.begin(), all.end(), [&](const EmbeddedLesson& lesson) {
        return entry_of(lesson.source).number == number;
    });
    if (found == all.end())
        throw lod::Error(lod::ErrorKind::usage,
                         "no lesson " + std::to_string(number) + "; there are lessons " +
                             std::to_string(entry_of(all.front().source).number) + " to " +
                             std::to_string(entry_of(all.back().source).number));
    Lesson lesson;
    lesson.entry = entry_of(found->source);
    lesson.script =
        read_script(found->source.markdown, "lessons/course/" + found->source.slug + "/lesson.md");
    lesson.listings = found->source.listings;
    lesson.equations = found->source.equations;
    found->make(lesson);
    complete(lesson);
    return lesson;
}

}  // namespace lessons
