#include "lessons/engine/filler.hpp"

#include "lessons/embed/source.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/error.hpp"

namespace lessons {

std::string Filler::fill(const std::string& text, int lines_before) {
    std::string filled;
    std::size_t done = 0;
    for (const Tag& tag : find_tags(text, where(), lines_before)) {
        const int line = lines_before + line_of(text, tag.begin);
        filled += text.substr(done, tag.begin - done);
        done = tag.end;
        if (tag.kind == "number")
            filled += number(tag.name, tag.format, line);
        else if (tag.kind == "lesson")
            filled += lesson(tag.name, line);
        else
            filled += text.substr(tag.begin, tag.end - tag.begin);
        if (tag.kind == "listing")
            (void)find_given(lesson_.listings, tag.kind, tag.name, where(), line);
        if (tag.kind == "figure") use_figure(tag.name, line);
        if (tag.kind == "live") use_live(line);
        if (tag.kind == "video" && lesson_.animation.shots.empty())
            refuse_line(where(), line, "the lesson's code gives no video");
    }
    return filled + text.substr(done);
}

std::string Filler::lesson(const std::string& name, int line) const {
    std::string names;
    for (const Entry& entry : list()) {
        if (entry.slug == name) return "lesson " + std::to_string(entry.number);
        names += (names.empty() ? "" : ", ") + entry.slug;
    }
    refuse_line(where(), line, "no lesson '" + name + "'; there are: " + names);
}

const Number& Filler::use_number(const std::string& name, int line) {
    const Number& number = find_given(lesson_.numbers, "number", name, where(), line);
    used_.insert("number " + name);
    return number;
}

std::string Filler::number(const std::string& name, const std::string& format, int line) {
    const Number& number = use_number(name, line);
    if (format.empty()) return number.text;
    if (!number.is_counted)
        refuse_line(where(), line, "'" + name + "' is words, which take no format");
    return in_format(number, read_format(format));
}

void Filler::use_figure(const std::string& name, int line) {
    (void)find_given(lesson_.figures, "figure", name, where(), line);
    used_.insert("figure " + name);
}

const Picks& Filler::use_picks(const std::string& name, int line) {
    const Picks& picks = find_given(lesson_.picks, "picks", name, where(), line);
    used_.insert("picks " + name);
    return picks;
}

void Filler::use_live(int line) {
    if (!lesson_.live) refuse_line(where(), line, "the lesson's code gives no scene to play with");
    used_.insert("live part");
}

void Filler::check_all_used() const {
    for (const auto& [what, place] : lesson_.given)
        if (!used_.count(what))
            throw lod::Error(lod::ErrorKind::input_refused, place + ": no text of " + where() +
                                                                " uses the " + what +
                                                                "; use it there or take it away");
}

}  // namespace lessons
