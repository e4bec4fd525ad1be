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

/// One `{{kind: name}}` of a text. Tags of kind steps and video have no name.
struct Tag {
    std::string kind;  ///< listing, figure, number, steps or video
    std::string name;
    std::size_t begin = 0;  ///< of "{{" in the text
    std::size_t end = 0;    ///< one past "}}"
};

/// Every tag of a text, in order. Throws lod::Error (input refused) with `where` and the line for a
/// tag that is not closed or of an unknown kind.
[[nodiscard]] std::vector<Tag> find_tags(std::string_view markdown, const std::string& where);

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

/// The 1-based line of an offset.
[[nodiscard]] int line_of(std::string_view text, std::size_t offset);

}  // namespace lessons
