#include "lessons/embed/source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lodlab/core/base/error.hpp"

namespace lessons {
namespace {

/// The lines as one text, without the indentation that all of them share.
std::string dedented(const std::vector<std::string>& lines) {
    std::size_t shared = std::string::npos;
    for (const std::string& line : lines) shared = std::min(shared, line.find_first_not_of(' '));
    std::string text;
    for (const std::string& line : lines)
        text += (line.size() > shared ? line.substr(shared) : std::string()) + "\n";
    return text;
}

/// Whether `name` stands in the line as a whole word.
bool names(std::string_view line, std::string_view name) {
    for (std::size_t at = line.find(name); at != std::string_view::npos;
         at = line.find(name, at + 1)) {
        const bool begins = at == 0 || !is_word(line[at - 1]);
        const std::size_t after = at + name.size();
        if (begins && (after == line.size() || !is_word(line[after]))) return true;
    }
    return false;
}

/// One past the line that closes the first brace opened at or after `first`; `first` itself when a
/// semicolon comes before any brace, for that is a declaration.
std::size_t definition_end(const std::vector<std::string>& lines, std::size_t first) {
    int depth = 0;
    bool opened = false;
    for (std::size_t i = first; i < lines.size(); ++i) {
        for (char c : lines[i].substr(0, lines[i].find("//"))) {
            if (c == ';' && !opened) return first;
            if (c == '{') {
                ++depth;
                opened = true;
            }
            if (c == '}') --depth;
        }
        if (opened && depth == 0) return i + 1;
    }
    return first;
}

/// The line on which the definition of a name begins; the number of lines when there is none.
std::size_t definition_line(const std::vector<std::string>& lines, const std::string& name) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string text = trimmed(lines[i]);
        const bool indented = lines[i].starts_with(" ");  // a use, not a definition
        if (text.starts_with("//") || text.starts_with("#") || indented || !names(text, name))
            continue;
        if (definition_end(lines, i) != i) return i;
    }
    return lines.size();
}

}  // namespace

Format read_format(std::string_view text) {
    Format format;
    std::istringstream parts{std::string(text)};
    for (std::string part; std::getline(parts, part, ',');) {
        part = trimmed(part);
        const std::size_t digits = part.find_first_not_of("0123456789");
        const std::string word = digits < part.size() ? part.substr(digits) : std::string();
        if (part == "no unit")
            format.unit = false;
        else if (digits == 1 && (word == " digits" || word == " digit"))
            format.digits = part[0] - '0';
        else
            throw lod::Error(lod::ErrorKind::input_refused,
                             "unknown format '" + part + "'; use '2 digits', 'no unit' or both");
    }
    return format;
}

namespace {

constexpr std::array<std::string_view, 9> kinds{"listing", "figure", "number", "shown", "ask",
                                                "lesson",  "steps",  "video",  "live"};

/// The tag between the braces, or why it is none.
Tag read_tag(std::string_view inside, const std::string& where, int line) {
    const std::size_t colon = inside.find(':');
    Tag tag;
    tag.kind = trimmed(inside.substr(0, colon));
    if (colon != std::string_view::npos) tag.name = trimmed(inside.substr(colon + 1));
    if (std::find(kinds.begin(), kinds.end(), tag.kind) == kinds.end())
        refuse_line(where, line,
                    "unknown kind '" + tag.kind +
                        "'; use listing, figure, number, shown, ask, lesson, video or live");
    if (tag.kind == "shown") {
        const std::size_t sign = tag.name.find('=');
        if (sign == std::string::npos)
            refuse_line(where, line, "a shown number is written {{shown: WHAT IT IS = NAME}}");
        tag.told = trimmed(tag.name.substr(0, sign));
        tag.name = trimmed(tag.name.substr(sign + 1));
    }
    const std::size_t bar = tag.name.find('|');
    if (bar != std::string::npos && (tag.kind == "number" || tag.kind == "shown")) {
        tag.format = trimmed(tag.name.substr(bar + 1));
        tag.name = trimmed(tag.name.substr(0, bar));
        try {
            (void)read_format(tag.format);
        } catch (const lod::Error& unknown) {
            refuse_line(where, line, unknown.what());
        }
    }
    const bool wants_name = tag.kind != "steps" && tag.kind != "video" && tag.kind != "live";
    if (wants_name == tag.name.empty())
        refuse_line(where, line,
                    "'" + tag.kind + (wants_name ? "' needs a name" : "' takes no name"));
    return tag;
}

}  // namespace

std::vector<Tag> find_tags(std::string_view markdown, const std::string& where, int lines_before) {
    std::vector<Tag> tags;
    for (std::size_t begin = markdown.find("{{"); begin != std::string_view::npos;
         begin = markdown.find("{{", tags.back().end)) {
        const int line = lines_before + line_of(markdown, begin);
        const std::size_t close = markdown.find("}}", begin);
        if (close == std::string_view::npos)
            refuse_line(where, line, "'{{' is not closed; add '}}'");
        tags.push_back(read_tag(markdown.substr(begin + 2, close - begin - 2), where, line));
        tags.back().begin = begin;
        tags.back().end = close + 2;
    }
    return tags;
}

std::map<std::string, std::string> find_listings(std::string_view code, const std::string& where) {
    constexpr std::string_view opening = "// listing:";
    constexpr std::string_view closing = "// end of listing";
    std::map<std::string, std::string> listings;
    std::string open;
    std::vector<std::string> body;
    int number = 0;
    for (const std::string& line : lines_of(code)) {
        ++number;
        const std::string text = trimmed(line);
        if (text.starts_with(opening)) {
            if (!open.empty()) refuse_line(where, number, "listing '" + open + "' is still open");
            open = trimmed(std::string_view(text).substr(opening.size()));
            if (open.empty()) refuse_line(where, number, "a listing needs a name");
            if (listings.count(open))
                refuse_line(where, number, "listing '" + open + "' appears twice");
        } else if (text == closing) {
            if (open.empty()) refuse_line(where, number, "no listing is open here");
            listings[open] = dedented(body);
            open.clear();
            body.clear();
        } else if (!open.empty()) {
            body.push_back(line);
        }
    }
    if (!open.empty())
        refuse_line(where, number, "listing '" + open + "' is not closed; add '// end of listing'");
    return listings;
}

bool has_definition(std::string_view code, const std::string& name) {
    const std::vector<std::string> lines = lines_of(code);
    return definition_line(lines, name) < lines.size();
}

std::string find_definition(std::string_view code, const std::string& name,
                            const std::string& where) {
    const std::vector<std::string> lines = lines_of(code);
    std::size_t begin = definition_line(lines, name);
    if (begin == lines.size())
        refuse_line(where, 1, "no definition of '" + name + "' in this file");
    const std::size_t end = definition_end(lines, begin);
    const auto belongs = [&](const std::string& above) {
        return above.starts_with("//") || above.starts_with("template") || above.starts_with("[[");
    };
    while (begin > 0 && belongs(trimmed(lines[begin - 1]))) --begin;
    return dedented({lines.begin() + static_cast<std::ptrdiff_t>(begin),
                     lines.begin() + static_cast<std::ptrdiff_t>(end)});
}

std::string find_title(std::string_view markdown, const std::string& where) {
    for (const std::string& line : lines_of(markdown))
        if (line.starts_with("# ")) return trimmed(std::string_view(line).substr(2));
    refuse_line(where, 1, "no title; begin the text with a line '# ...'");
}

}  // namespace lessons
