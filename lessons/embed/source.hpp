#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// A lesson as it was written: lesson.md beside lesson.cpp, embedded when lodlab is built.
struct Source {
    std::string slug;                              ///< the folder: "01_distance_test"
    std::string markdown;                          ///< lesson.md
    std::map<std::string, std::string> listings;   ///< what follows `listing:` -> code
    std::map<std::string, std::string> equations;  ///< "$...$" or "$$...$$" -> MathML
};

/// How a text shows a number where it does not take it as the code gave it.
struct Format {
    int digits = -1;   ///< after the point; -1: as given
    bool unit = true;  ///< false: without its unit
};

/// "2 digits", "no unit", or both with a comma. Throws lod::Error (input refused) for another.
[[nodiscard]] Format read_format(std::string_view text);

/// One tag of a text:
///
///     {{listing: NAME}}            a named listing of the code, or FILE NAME for a definition
///     {{figure: NAME}}             a figure that the code gives, on a line of its own
///     {{number: NAME | FORMAT}}    a number that the code gives
///     {{shown: TOLD = NAME | FORMAT}}   the same, in the list below a step
///     {{ask: NAME}}                a question to the reader, on a line of its own in a step
///     {{lesson: NAME}}             another lesson: "lesson 3"
///     {{video}}                    the lesson's video, on a line of its own
///     {{live}}                     the scene that the reader plays with, on a line of its own
///
/// and {{steps}}, which read_script puts in the place of the steps.
struct Tag {
    std::string kind;
    std::string name;
    std::string format;
    std::string told;
    std::size_t begin = 0;  ///< of "{{" in the text
    std::size_t end = 0;    ///< one past "}}"
};

/// Every tag of a text, in order; the text begins after `lines_before` lines of the file `where`.
/// Throws lod::Error (input refused) with `where` and the line for a tag that is not closed, of an
/// unknown kind or of an unknown format.
[[nodiscard]] std::vector<Tag> find_tags(std::string_view markdown, const std::string& where,
                                         int lines_before = 0);

/// The listings of a source file: the lines between `// listing: name` and `// end of listing`,
/// indented no further than needed. Throws lod::Error (input refused) with `where` and the line for
/// a listing that is not closed, opened within another, or named twice.
[[nodiscard]] std::map<std::string, std::string> find_listings(std::string_view code,
                                                               const std::string& where);

/// The definition of a function or type in a source file: its comment, its template line, and the
/// text to the brace that closes it. Throws lod::Error (input refused) when there is none.
[[nodiscard]] std::string find_definition(std::string_view code, const std::string& name,
                                          const std::string& where);

[[nodiscard]] bool has_definition(std::string_view code, const std::string& name);

/// The text of the first "# " line. Throws lod::Error (input refused) when there is none.
[[nodiscard]] std::string find_title(std::string_view markdown, const std::string& where);

}  // namespace lessons
