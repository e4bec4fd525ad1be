#include "lodlab/lod2d/source/css/css_values.hpp"

#include <algorithm>

#include "lodlab/lod2d/source/svg/text.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

bool holds_call(const std::string& text, std::initializer_list<std::string> functions) {
    const auto called = [&](const std::string& f) { return text.find(f + "(") != text.npos; };
    return std::ranges::any_of(functions, called);
}

/// What a property is where nothing is said, for those whose keywords are put in place.
std::string_view initial_value(std::string_view property) {
    struct Initial {
        std::string_view property;
        std::string_view value;
    };
    static constexpr Initial values[] = {
        {"fill", "black"},           {"stroke", "none"},        {"fill-rule", "nonzero"},
        {"fill-opacity", "1"},       {"stroke-opacity", "1"},   {"stroke-width", "1"},
        {"stroke-linecap", "butt"},  {"visibility", "visible"}, {"stroke-dasharray", "none"},
        {"stroke-linejoin", "miter"}};
    const auto found = std::ranges::find(values, property, &Initial::property);
    return found == std::end(values) ? std::string_view() : found->value;
}

/// Moves, bends or cuts what is drawn, and is of browsers' CSS alone.
bool is_of_browsers(std::string_view property) {
    return is_one_of(property, {"transform-origin", "transform-box", "translate", "rotate", "scale",
                                "d", "all", "zoom", "clip", "content-visibility", "vector-effect",
                                "perspective"}) ||
           property.starts_with("animation") || property.starts_with("offset-") ||
           (property.starts_with("mask-") && property != "mask-type");
}

bool is_harmless(std::string_view property, const std::string& value) {
    if (property == "d") return false;  // "none" draws nothing
    if (is_one_of(value, {"none", "auto", "normal", "initial", "unset"})) return true;
    if (property == "zoom") return value == "1";
    if (property == "transform-box") return value == "view-box";
    if (property == "transform-origin") return is_svg_origin(value);
    return property.starts_with("animation-") && property != "animation-name";
}

/// Lengths in units that every library knows; `unknown` gets the unit of one that is in another.
std::string known_lengths(std::string_view text, const SvgFrame& frame, std::string& unknown) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n,"), text.size());
        const std::string_view word = text.substr(0, end);
        std::string put(word);
        try {
            SvgReader reader(word);
            const double value = reader.number();
            const std::string unit(reader.letters());
            if (unit == "q") put = decimal(value * 96 / 101.6) + "px";
            if (unit == "rem" && frame.root_font) put = decimal(value * *frame.root_font) + "px";
            const bool known = is_one_of(unit, {"", "px", "pt", "pc", "mm", "cm", "in", "em", "q"});
            if (!known && !(unit == "rem" && frame.root_font)) unknown = unit;
        } catch (const SvgTextError&) {  // a keyword
        }
        result += put;
        if (end < text.size()) result += text[end];
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

}  // namespace

bool is_svg_length(std::string_view property) {
    return is_one_of(property, {"x",
                                "y",
                                "width",
                                "height",
                                "cx",
                                "cy",
                                "r",
                                "rx",
                                "ry",
                                "x1",
                                "y1",
                                "x2",
                                "y2",
                                "refX",
                                "refY",
                                "markerWidth",
                                "markerHeight",
                                "stroke-width",
                                "stroke-dasharray",
                                "stroke-dashoffset",
                                "font-size"});
}

bool is_svg_origin(std::string_view text) {
    return text.find_first_not_of("0 px%") == std::string_view::npos ||
           is_one_of(text, {"left top", "top left"});
}

std::string followed_value(std::string_view property, std::string text, const SvgFrame& frame,
                           SvgNotes& notes) {
    const std::string named(property);
    const auto not_followed = [&](const std::string& what) {
        notes.doubt(what + ", which is not followed here; write the value itself");
    };
    if (is_of_browsers(property)) {
        if (!is_harmless(property, text))
            notes.doubt("its style sets " + named + ", which is not followed here");
        return {};
    }
    if (is_one_of(text, {"initial", "unset", "revert", "revert-layer"})) {
        const std::string_view initial = initial_value(property);
        if (initial.empty()) {
            not_followed("its style sets " + named + " to " + text);
            return {};
        }
        text = text == "initial" ? std::string(initial) : "inherit";
    }
    if (property == "font" || (property.starts_with("font") && property != "font-size"))
        return text;
    if (holds_call(text, {"calc", "min", "max", "clamp", "env", "attr"}))
        not_followed("its style computes " + named + " (" + text + ")");
    const bool cuts = property == "clip-path" || property == "mask";
    if (cuts && !text.starts_with("url(") && !is_one_of(text, {"none", "inherit"})) {
        notes.doubt("its " + named + " " + text + " is not followed here; write a <clipPath>");
        return {};
    }
    if (property == "transform" && !is_one_of(text, {"none", "inherit"})) {
        const auto followed = followed_transform(text, frame);
        if (!followed) not_followed("its style sets transform to " + text);
        return followed.value_or("");
    }
    if (is_svg_length(property)) {
        std::string unknown;
        text = known_lengths(text, frame, unknown);
        if (!unknown.empty()) {
            notes.doubt("its " + named + " " + text + " is in " + unknown +
                        ", which is not followed here; write px");
            return {};  // newer librsvg would follow some of them, by fonts that are there
        }
    }
    if ((property == "fill" || property == "stroke") &&
        holds_call(text, {"color", "color-mix", "lab", "lch", "oklab", "oklch", "hwb",
                          "device-cmyk", "light-dark", "icc-color"})) {
        if (text.find('/') != std::string::npos)
            notes.doubt("its " + named + " " + text + " is taken as seen");
        text = "black";
    }
    return text;
}

}  // namespace lod2d
