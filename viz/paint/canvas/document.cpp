#include "lodlab/viz/paint/canvas/document.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string_view>

namespace viz {
namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20 || c == '\n') out += c;
        }
    }
    return out;
}

/// The name of an id without the number at its end.
std::string_view stem_of(std::string_view id) {
    while (!id.empty() && std::isdigit(static_cast<unsigned char>(id.back()))) id.remove_suffix(1);
    return id;
}

/// Numbers every id anew, those of one stem ("surfaceN", "source-N") in the order in which they are
/// met, and what refers to it: the drawing library counts its ids through the whole process.
std::string with_own_ids(const std::string& svg) {
    constexpr std::string_view definition = " id=\"";
    std::map<std::string, std::string, std::less<>> own;
    std::map<std::string, int, std::less<>> met;
    for (std::size_t at = svg.find(definition); at != std::string::npos;
         at = svg.find(definition, at)) {
        at += definition.size();
        const std::string id = svg.substr(at, svg.find('"', at) - at);
        const std::string stem(stem_of(id));
        if (stem.size() < id.size()) own.emplace(id, stem + std::to_string(++met[stem]));
    }
    std::string out;
    std::size_t from = 0;
    for (std::size_t at = svg.find_first_of("\"#"); at != std::string::npos;
         at = svg.find_first_of("\"#", from)) {
        const std::size_t end = std::min(svg.find_first_of("\"#)", at + 1), svg.size());
        out.append(svg, from, at + 1 - from);
        const std::string_view word = std::string_view(svg).substr(at + 1, end - at - 1);
        const auto renamed = own.find(word);
        out.append(renamed == own.end() ? word : std::string_view(renamed->second));
        from = end;
    }
    return out.append(svg, from, std::string::npos);
}

}  // namespace

std::string finished_svg(const std::string& svg, const std::string& title, const std::string& alt) {
    std::string out = with_own_ids(svg);
    const std::size_t tag = out.find("<svg ");
    if (tag == std::string::npos) return out;
    const std::size_t end = out.find('>', tag);
    if (end == std::string::npos) return out;
    out.insert(end + 1,
               "\n<title>" + escaped(title) + "</title>\n<desc>" + escaped(alt) + "</desc>");
    out.insert(tag + 4, " role=\"img\"");
    return out;
}

}  // namespace viz
