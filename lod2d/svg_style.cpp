#include "lodlab/lod2d/svg_style.hpp"

#include <algorithm>
#include <pugixml.hpp>

#include "lodlab/lod2d/svg_text.hpp"

namespace lod2d {
namespace {

constexpr std::string_view spaces = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

std::string without_comments(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t comment = text.find("/*", at);
        result += text.substr(at, comment - at);
        if (comment == std::string_view::npos) break;
        const std::size_t end = text.find("*/", comment + 2);
        if (end == std::string_view::npos) break;
        at = end + 2;
    }
    return result;
}

bool is_positive(const std::string& opacity) {
    try {
        return parse_svg_length(opacity, 1) > 0;
    } catch (const SvgTextError&) {
        return true;
    }
}

}  // namespace

std::string_view local_name(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void SvgStyleSheet::read_declarations(std::string_view text, Declarations& declarations) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view declaration = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        std::string_view value = trimmed(declaration.substr(colon + 1));
        value = trimmed(value.substr(0, value.find("!important")));
        declarations.insert_or_assign(std::string(trimmed(declaration.substr(0, colon))),
                                      std::string(value));
    }
}

void SvgStyleSheet::read(std::string_view source) {
    const std::string clean = without_comments(source);
    std::string_view text = clean;
    while (true) {
        const std::size_t open = text.find('{');
        const std::size_t close = text.find('}', open);
        if (close == std::string_view::npos) return;
        std::string_view selectors = text.substr(0, open);
        const std::string_view body = text.substr(open + 1, close - open - 1);
        text.remove_prefix(close + 1);
        while (true) {
            const std::size_t comma = selectors.find(',');
            const std::string_view selector = trimmed(selectors.substr(0, comma));
            if (!selector.empty() && selector.find_first_of(" >+~:[@") == std::string_view::npos)
                read_declarations(body, rules_[std::string(selector)]);
            if (comma == std::string_view::npos) break;
            selectors.remove_prefix(comma + 1);
        }
    }
}

/// The strongest of: style, #id, .class, element, *, attribute.
std::string SvgStyleSheet::value_of(const pugi::xml_node& element, std::string_view property,
                                    const Declarations& own) const {
    if (const auto found = own.find(property); found != own.end()) return found->second;
    if (!rules_.empty()) {
        const auto ruled = [&](const std::string& selector) -> const std::string* {
            const auto rule = rules_.find(selector);
            if (rule == rules_.end()) return nullptr;
            const auto found = rule->second.find(property);
            return found == rule->second.end() ? nullptr : &found->second;
        };
        if (const auto* value = ruled(std::string("#").append(element.attribute("id").value())))
            return *value;
        const std::string tag(local_name(element.name()));
        std::string_view classes = element.attribute("class").value();
        const std::string* by_class = nullptr;
        while (!classes.empty()) {
            const std::size_t end = std::min(classes.find_first_of(spaces), classes.size());
            const std::string one = std::string(".").append(classes.substr(0, end));
            if (const auto* value = ruled(one)) by_class = value;
            if (const auto* value = ruled(tag + one)) by_class = value;
            classes.remove_prefix(std::min(end + 1, classes.size()));
        }
        if (by_class) return *by_class;
        if (const auto* value = ruled(tag)) return *value;
        if (const auto* value = ruled("*")) return *value;
    }
    return element.attribute(std::string(property).c_str()).value();
}

SvgStyle SvgStyleSheet::style_of(const pugi::xml_node& element, const SvgStyle& parent) const {
    Declarations own;
    read_declarations(element.attribute("style").value(), own);
    const auto value = [&](std::string_view property) {
        std::string text = value_of(element, property, own);
        return text == "inherit" ? std::string() : text;
    };
    const auto none = [](const std::string& paint) {
        return paint == "none" || paint == "transparent";
    };
    SvgStyle style = parent;
    if (const auto paint = value("fill"); !paint.empty()) style.filled = !none(paint);
    if (const auto rule = value("fill-rule"); !rule.empty())
        style.rule = rule == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
    if (const auto opacity = value("fill-opacity"); !opacity.empty())
        style.fill_seen = is_positive(opacity);
    if (const auto paint = value("stroke"); !paint.empty()) style.stroked = !none(paint);
    if (const auto opacity = value("stroke-opacity"); !opacity.empty())
        style.stroke_seen = is_positive(opacity);
    if (const auto width = value("stroke-width"); !width.empty()) {
        try {
            style.stroke_width = parse_svg_length(width, 100);
        } catch (const SvgTextError&) {
        }
    }
    if (const auto seen = value("visibility"); !seen.empty()) style.visible = seen == "visible";
    if (value("display") == "none") style.drawn = false;
    if (const auto opacity = value("opacity"); !opacity.empty() && !is_positive(opacity))
        style.drawn = false;
    return style;
}

}  // namespace lod2d
