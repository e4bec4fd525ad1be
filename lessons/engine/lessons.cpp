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

[[noreturn]] void refuse(const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, why);
}

template <class Table>
std::string names_in(const Table& table) {
    std::string names;
    for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + name;
    return names.empty() ? "none" : names;
}

template <class Table>
void require(const Table& table, const Tag& tag, const std::string& where) {
    if (!table.count(tag.name))
        refuse(where + ": no " + tag.kind + " '" + tag.name +
               "'; the lesson has: " + names_in(table));
}

void require_alt(const viz::Figure& figure, const std::string& where) {
    if (figure.alt.empty()) refuse(where + " has no alt text; set Figure::alt");
}

}  // namespace

std::vector<Entry> list() {
    std::vector<Entry> entries;
    for (const EmbeddedLesson& lesson : embedded_lessons())
        entries.push_back(entry_of(lesson.source));
    return entries;
}

void check_lesson(const Lesson& lesson) {
    const std::string file = lesson.entry.slug + "/lesson.md";
    for (const Tag& tag : find_tags(lesson.markdown, file)) {
        const std::string where = file + ":" + std::to_string(line_of(lesson.markdown, tag.begin));
        if (tag.kind == "figure") require(lesson.figures, tag, where);
        if (tag.kind == "number") require(lesson.numbers, tag, where);
        if (tag.kind == "listing") require(lesson.listings, tag, where);
        if (tag.kind == "steps" && lesson.steps.empty())
            refuse(where + ": the lesson has no steps");
        if (tag.kind == "video" && lesson.animation.shots.empty())
            refuse(where + ": the lesson has no animation");
    }
    for (const auto& [name, figure] : lesson.figures)
        require_alt(figure, lesson.entry.slug + ": figure '" + name + "'");
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Step& step = lesson.steps[i];
        const std::string where = lesson.entry.slug + ": step " + std::to_string(i + 1);
        if (step.title.empty()) refuse(where + " has no title");
        if (step.text.empty()) refuse(where + " has no text");
        require_alt(step.figure, where);
    }
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
    lesson.markdown = found->source.markdown;
    lesson.listings = found->source.listings;
    lesson.equations = found->source.equations;
    found->make(lesson);
    check_lesson(lesson);
    return lesson;
}

}  // namespace lessons
