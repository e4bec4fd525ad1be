#include "lodlab/viz/document.hpp"

#include <cctype>
#include <map>

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

/// Numbers the ids that begin with a word, "surfaceN", from 1: the drawing library counts them
/// through the whole process.
std::string with_own_ids(const std::string& svg, const std::string& word) {
    std::map<std::string, int> number_of;
    std::string out;
    std::size_t from = 0;
    for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, from)) {
        std::size_t end = at + word.size();
        while (end < svg.size() && std::isdigit(static_cast<unsigned char>(svg[end]))) ++end;
        const std::string old = svg.substr(at + word.size(), end - at - word.size());
        out.append(svg, from, at + word.size() - from);
        const bool is_id = !old.empty() && at > 0 && (svg[at - 1] == '"' || svg[at - 1] == '#');
        out +=
            is_id
                ? std::to_string(
                      number_of.emplace(old, static_cast<int>(number_of.size()) + 1).first->second)
                : old;
        from = end;
    }
    return out.append(svg, from, std::string::npos);
}

}  // namespace

std::string finished_svg(const std::string& svg, const std::string& title, const std::string& alt) {
    std::string out = with_own_ids(with_own_ids(svg, "surface"), "image");
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
