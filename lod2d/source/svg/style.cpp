#include "lodlab/lod2d/source/svg/style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>

#include "lodlab/lod2d/source/svg/text.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {
namespace {

std::optional<double> length_in(std::string_view text) {
    SvgReader reader(trimmed(text));
    try {
        const double value = reader.number();
        if (reader.take_if('p') && !reader.take_if('x')) return std::nullopt;
        if (reader.at_end() && std::abs(value) < 1e60) return value;
    } catch (const SvgTextError&) {
    }
    return std::nullopt;
}

/// The colours that drawing programs write by name; another name asks a library.
bool is_common_colour(std::string_view name) {
    return is_one_of(name,
                     {"black",  "white",  "red",   "green", "blue",  "yellow",  "gray", "grey",
                      "orange", "purple", "brown", "pink",  "cyan",  "magenta", "navy", "silver",
                      "maroon", "lime",   "aqua",  "teal",  "olive", "fuchsia", "gold"});
}

bool is_hexadecimal_colour(std::string_view text) {
    if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7)) return false;
    return std::ranges::all_of(text.substr(1), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    });
}

/// Three numbers or three percentages.
bool is_rgb_colour(std::string_view text) {
    if (!text.starts_with("rgb(") || !text.ends_with(')')) return false;
    SvgReader reader(text.substr(4, text.size() - 5));
    try {
        for (int i = 0; i < 3; ++i) {
            reader.skip_spaces();
            (void)reader.number();
            (void)reader.take_if('%');
            reader.skip_spaces();
            if (i < 2 && !reader.take_if(',')) return false;
        }
    } catch (const SvgTextError&) {
        return false;
    }
    return reader.at_end();
}

bool is_opaque_colour(std::string_view text) {
    return is_common_colour(text) || is_hexadecimal_colour(text) || is_rgb_colour(text);
}

std::optional<SvgGradient> paint_of(std::string_view text, const GradientPaint& gradient) {
    if (text == "none" || text == "transparent") return SvgGradient{SvgPaint::none, false};
    if (is_opaque_colour(text)) return SvgGradient{SvgPaint::whole, false};
    if (text.starts_with("url(#") && text.ends_with(')') &&
        text.find_first_of(")'\" ") == text.size() - 1)
        return gradient(text.substr(5, text.size() - 6));
    return std::nullopt;
}

std::optional<std::vector<double>> dashes_in(std::string_view text) {
    std::vector<double> dashes;
    if (text == "none") return dashes;
    SvgReader reader(text);
    try {
        while (!reader.at_end()) {
            dashes.push_back(reader.number());
            if (!(dashes.back() >= 0 && dashes.back() < 1e60)) return std::nullopt;
            if (reader.take_if('p') && !reader.take_if('x')) return std::nullopt;
            reader.skip_separator();
        }
    } catch (const SvgTextError&) {
        return std::nullopt;
    }
    return dashes;
}

/// What draws something else than its outline where it says more than this value.
struct Harmless {
    std::string_view property;
    std::string_view value;
};
constexpr std::array harmless = {
    Harmless{"clip-path", "none"},    Harmless{"mask", "none"},
    Harmless{"filter", "none"},       Harmless{"marker", "none"},
    Harmless{"marker-start", "none"}, Harmless{"marker-mid", "none"},
    Harmless{"marker-end", "none"},   Harmless{"vector-effect", "none"},
};

/// Of CSS, and without meaning as attributes, or with another.
bool moves_or_shapes(std::string_view property) {
    return is_one_of(property, {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height", "d",
                                "transform", "translate", "rotate", "scale", "all", "zoom",
                                "content-visibility", "clip"}) ||
           property.starts_with("animation") || property.starts_with("offset") ||
           property.starts_with("--") || property.starts_with("mask-") ||
           property.starts_with("-webkit-") || property == "perspective";
}

class PlainReader {
  public:
    PlainReader(SvgStyle& style, const GradientPaint& gradient)
        : style_(style), gradient_(gradient) {}

    /// Whether the declaration is understood, or without effect on outlines.
    bool take(std::string_view property, std::string_view value) {
        if (value == "inherit") return !is_read(property);
        bool fill_by_box = false;  // what is flat has no fill in any case
        if (property == "fill") return take_paint(value, style_.fill, fill_by_box);
        if (property == "stroke") {
            return take_paint(value, style_.stroke, style_.stroke_by_box);
        }
        if (property == "fill-opacity") return take_seen(value, style_.fill_seen);
        if (property == "stroke-opacity") return take_seen(value, style_.stroke_seen);
        if (property == "opacity") {
            bool seen = true;
            if (!take_seen(value, seen)) return false;
            faded_ = !seen;
            return true;
        }
        if (property == "display") {
            taken_out_ = value == "none";
            return is_one_of(value, {"none", "inline", "block"});
        }
        if (property == "visibility") {
            style_.visible = value == "visible";
            return is_one_of(value, {"visible", "hidden", "collapse"});
        }
        if (property == "fill-rule") {
            style_.rule = value == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
            return is_one_of(value, {"nonzero", "evenodd"});
        }
        if (property.starts_with("stroke-")) return take_pen(property.substr(7), value);
        if (property.starts_with("transform-")) return false;
        const auto known = std::ranges::find(harmless, property, &Harmless::property);
        return known == harmless.end() || known->value == value;
    }

    [[nodiscard]] bool is_drawn() const { return !faded_ && !taken_out_; }

  private:
    static bool is_read(std::string_view property) {
        return property.starts_with("fill") || property.starts_with("stroke") ||
               is_one_of(property, {"display", "visibility", "opacity"}) ||
               std::ranges::find(harmless, property, &Harmless::property) != harmless.end();
    }
    bool take_paint(std::string_view value, SvgPaint& paint, bool& of_box) {
        const auto found = paint_of(value, gradient_);
        if (found) paint = found->paint;
        if (found) of_box = found->of_box;
        return found.has_value();
    }
    static bool take_seen(std::string_view value, bool& seen) {
        const auto number = length_in(value);
        if (number) seen = *number > 0;
        return number.has_value();
    }
    bool take_number(std::string_view value, double least, double& number) {
        const auto found = length_in(value);
        if (found) number = *found;
        return found && *found >= least;
    }
    bool take_pen(std::string_view property, std::string_view value) {
        StrokeStyle& pen = style_.pen;
        if (property == "width") return take_number(value, 0, pen.width);
        if (property == "miterlimit") return take_number(value, 1, pen.miter_limit);
        if (property == "dashoffset") return take_number(value, -1e60, pen.dash_offset);
        if (property == "dasharray") {
            auto dashes = dashes_in(value);
            if (dashes) pen.dashes = std::move(*dashes);
            return dashes.has_value();
        }
        if (property == "linejoin") {
            pen.join = value == "round"   ? StrokeJoin::round
                       : value == "bevel" ? StrokeJoin::bevel
                                          : StrokeJoin::miter;
            return is_one_of(value, {"miter", "round", "bevel"});
        }
        if (property == "linecap") {
            pen.cap = value == "round"    ? StrokeCap::round
                      : value == "square" ? StrokeCap::square
                                          : StrokeCap::butt;
            return is_one_of(value, {"butt", "round", "square"});
        }
        return false;
    }

    SvgStyle& style_;
    const GradientPaint& gradient_;
    bool faded_ = false;
    bool taken_out_ = false;
};

/// Calls visit(property, value) for each declaration until it returns false; false too for what is
/// written in a way that only CSS understands.
template <typename Visit>
bool visit_declarations(std::string_view text, Visit&& visit) {
    if (text.find_first_of("\\!@{}\"'") != std::string_view::npos &&
        text.find("font") == std::string_view::npos)
        return false;
    if (text.find_first_of("\\!@{}") != std::string_view::npos ||
        text.find("/*") != std::string_view::npos)
        return false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view declaration = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (declaration.empty()) continue;
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) return false;
        const std::string_view property = trimmed(declaration.substr(0, colon));
        const bool lower = std::ranges::none_of(
            property, [](char c) { return (c >= 'A' && c <= 'Z') || c == ' '; });
        if (!lower || moves_or_shapes(property)) return false;
        if (!visit(property, trimmed(declaration.substr(colon + 1)))) return false;
    }
    return true;
}

bool is_condition(std::string_view attribute) {
    return is_one_of(attribute, {"systemLanguage", "requiredExtensions", "requiredFeatures",
                                 "pathLength", "xml:base"});
}

}  // namespace

std::optional<SvgStyle> plain_style(const pugi::xml_node& element, const SvgStyle& parent,
                                    const GradientPaint& gradient) {
    SvgStyle style = parent;
    PlainReader reader(style, gradient);
    for (const pugi::xml_attribute& attribute : element.attributes()) {
        const std::string_view name = attribute.name();
        if (name == "style" || name == "transform") continue;
        if (is_condition(name)) return std::nullopt;
        if (!reader.take(name, trimmed(attribute.value()))) return std::nullopt;
    }
    const bool plain = visit_declarations(element.attribute("style").value(),
                                          [&](std::string_view property, std::string_view value) {
                                              return reader.take(property, value);
                                          });
    style.drawn = parent.drawn && reader.is_drawn();
    return plain ? std::optional(style) : std::nullopt;
}

std::optional<SvgPaint> plain_stops(const pugi::xml_node& gradient) {
    std::size_t seen = 0;
    std::size_t stops = 0;
    for (const pugi::xml_node& stop : gradient.children()) {
        if (stop.type() != pugi::node_element || local_name(stop.name()) != "stop") continue;
        ++stops;
        std::string opacity = stop.attribute("stop-opacity").value();
        std::string colour = stop.attribute("stop-color").value();
        const bool plain =
            visit_declarations(stop.attribute("style").value(),
                               [&](std::string_view property, std::string_view value) {
                                   if (property == "stop-opacity") opacity = value;
                                   if (property == "stop-color") colour = value;
                                   return true;
                               });
        if (!plain || (!colour.empty() && !is_opaque_colour(colour))) return std::nullopt;
        const auto number = opacity.empty() ? 1.0 : length_in(opacity);
        if (!number) return std::nullopt;
        seen += *number > 0;
    }
    if (seen == 0) return SvgPaint::none;
    return seen == stops ? SvgPaint::whole : SvgPaint::fading;
}

}  // namespace lod2d
