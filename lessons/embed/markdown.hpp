#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// An equation as Markdown gave it.
struct Equation {
    std::string latex;
    bool display = false;
    /// How the lesson writes it, "$...$" or "$$...$$": its key among the equations of a source.
    [[nodiscard]] std::string key() const;
};

/// Every equation of a Markdown text, in order.
[[nodiscard]] std::vector<Equation> find_equations(std::string_view markdown);

/// Markdown to HTML; equations become the MathML of the table. Throws lod::Error (input refused)
/// for an equation that the table does not know.
[[nodiscard]] std::string markdown_to_html(std::string_view markdown,
                                           const std::map<std::string, std::string>& equations);

/// & < > " written so that HTML shows them.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace lessons
