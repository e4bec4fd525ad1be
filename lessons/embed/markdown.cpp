#include "lessons/embed/markdown.hpp"

#include <md4c-html.h>

#include <functional>
#include <utility>

#include "lodlab/core/base/error.hpp"

namespace lessons {
namespace {

void append(const MD_CHAR* text, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(text, size);
}

std::string raw_html(std::string_view markdown) {
    std::string html;
    const unsigned flags = MD_FLAG_LATEXMATHSPANS | MD_FLAG_TABLES | MD_FLAG_STRIKETHROUGH;
    if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html, flags, 0) !=
        0)
        throw lod::Error(lod::ErrorKind::input_refused, "the Markdown of a lesson cannot be read");
    return html;
}

/// The empty cell at the corner of a table heads nothing: it is a plain one.
std::string with_plain_corners(std::string html) {
    constexpr std::string_view empty = "<th></th>";
    constexpr std::string_view plain = "<td></td>";
    for (std::size_t at = html.find(empty); at != std::string::npos; at = html.find(empty, at))
        html.replace(at, empty.size(), plain);
    return html;
}

std::string unescaped(std::string text) {
    constexpr std::pair<std::string_view, std::string_view> names[] = {
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
    for (const auto& [name, character] : names)
        for (std::size_t at = text.find(name); at != std::string::npos;
             at = text.find(name, at + character.size()))
            text.replace(at, name.size(), character);
    return text;
}

/// Walks over the <x-equation> elements that md4c writes; `replace` gives what stands in their
/// place.
std::string replace_equations(const std::string& html,
                              const std::function<std::string(const Equation&)>& replace) {
    constexpr std::string_view opening = "<x-equation";
    constexpr std::string_view closing = "</x-equation>";
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = html.find(opening); at != std::string::npos;
         at = html.find(opening, done)) {
        const std::size_t inside = html.find('>', at) + 1;
        const std::size_t end = html.find(closing, inside);
        const bool display = html.substr(at, inside - at).find("display") != std::string::npos;
        result += html.substr(done, at - done);
        result += replace({unescaped(html.substr(inside, end - inside)), display});
        done = end + closing.size();
    }
    return result + html.substr(done);
}

}  // namespace

std::string Equation::key() const {
    const std::string fence = display ? "$$" : "$";
    return fence + latex + fence;
}

std::vector<Equation> find_equations(std::string_view markdown) {
    std::vector<Equation> equations;
    replace_equations(raw_html(markdown), [&](const Equation& equation) {
        equations.push_back(equation);
        return std::string();
    });
    return equations;
}

std::string markdown_to_html(std::string_view markdown,
                             const std::map<std::string, std::string>& equations) {
    return replace_equations(with_plain_corners(raw_html(markdown)), [&](const Equation& equation) {
        const auto found = equations.find(equation.key());
        if (found == equations.end())
            throw lod::Error(lod::ErrorKind::input_refused,
                             "equation " + equation.key() +
                                 " was not converted when lodlab was built; build it again");
        return found->second;
    });
}

std::string escaped_html(std::string_view text) {
    std::string html;
    for (char c : text) {
        if (c == '&')
            html += "&amp;";
        else if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

}  // namespace lessons
