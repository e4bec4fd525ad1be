#include "lodlab/lod2d/source/css/css_selectors.hpp"

#include <algorithm>

#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

bool is_of_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || (c & 0x80) != 0;
}

/// Where the string that begins at `i` ends, or i itself.
std::size_t past_string(std::string_view text, std::size_t i) {
    if (text[i] != '"' && text[i] != '\'') return i;
    return std::min(text.find(text[i], i + 1), text.size() - 1);
}

}  // namespace

void SvgSelectors::declare(std::string_view prelude) {
    constexpr std::string_view svg = "http://www.w3.org/2000/svg";
    std::size_t end = 0;
    while (end < prelude.size() && is_of_name(prelude[end])) ++end;
    const bool names = end < prelude.size() && prelude[end] != '(';
    const std::string_view prefix = names ? prelude.substr(0, end) : std::string_view();
    const bool of_svg = prelude.find(svg) != std::string_view::npos;
    if (prefix.empty())
        of_another_ = !of_svg;
    else
        is_of_svg_[std::string(prefix)] = of_svg;
}

std::optional<std::string> SvgSelectors::followed(std::string_view selector) {
    check_pseudo_classes(selector);
    if (of_another_) {
        notes_.doubt("its style sheet is for another namespace than SVG, and left out");
        return std::nullopt;
    }
    std::string result;
    for (std::size_t i = 0; i < selector.size(); ++i) {
        const std::size_t end = past_string(selector, i);
        if (end != i || selector[i] != '|' || selector.substr(i + 1).starts_with('=')) {
            result += selector.substr(i, end - i + 1);
            i = end;
            continue;
        }
        std::size_t from = result.size();
        while (from > 0 && (is_of_name(result[from - 1]) || result[from - 1] == '*')) --from;
        const std::string prefix = result.substr(from);
        if (from > 0 && result[from - 1] == '[') {
            notes_.doubt("its style sheet selects by " + prefix + "|, which is not followed here");
            return std::nullopt;
        }
        const auto declared = is_of_svg_.find(prefix);
        const bool takes_svg = prefix == "*" || (declared != is_of_svg_.end() && declared->second);
        if (!takes_svg) {  // of a list, others may take something
            if (selector.find(',') != std::string_view::npos)
                notes_.doubt("its style sheet selects by " + prefix +
                             "|, which is not followed here");
            return std::nullopt;
        }
        result.erase(from);
    }
    return result;
}

void SvgSelectors::check_pseudo_classes(std::string_view selector) {
    static constexpr std::string_view known[] = {"root",
                                                 "first-child",
                                                 "last-child",
                                                 "only-child",
                                                 "first-of-type",
                                                 "last-of-type",
                                                 "only-of-type",
                                                 "nth-child",
                                                 "nth-of-type",
                                                 "nth-last-child",
                                                 "nth-last-of-type",
                                                 "not",
                                                 "empty",
                                                 "link",
                                                 "hover",
                                                 "active",
                                                 "focus",
                                                 "visited",
                                                 "target",
                                                 "lang"};
    for (std::size_t i = 0; i < selector.size(); ++i) {
        i = past_string(selector, i);
        if (selector[i] != ':') continue;
        const std::size_t end =
            std::min(selector.find_first_of(" ,.#:[>+~()", i + 1), selector.size());
        const std::string name = lower(selector.substr(i + 1, end - i - 1));
        if (std::ranges::find(known, name) == std::end(known))
            notes_.doubt("its style sheet selects by :" + name + ", which is not followed here");
    }
}

bool SvgSelectors::may_take_viewports(std::string_view selector, const SvgFrame& frame) {
    while (!selector.empty()) {
        const std::size_t comma = std::min(selector.find(','), selector.size());
        const std::string_view one = trimmed(selector.substr(0, comma));
        selector.remove_prefix(std::min(comma + 1, selector.size()));
        const std::size_t last = one.find_last_of(" \t\r\n>+~");
        std::string_view type = one.substr(last == std::string_view::npos ? 0 : last + 1);
        type = type.substr(0, std::min(type.find_first_of(".#[:"), type.size()));
        const bool any = type.empty() || type == "*";
        if (frame.has_uses && (any || type == "use")) return true;
        if (frame.has_viewports && (any || type == "svg" || type == "symbol")) return true;
    }
    return false;
}

}  // namespace lod2d
