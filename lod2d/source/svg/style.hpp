#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lodlab/lod2d/source/paths/clean.hpp"
#include "lodlab/lod2d/source/paths/stroke.hpp"

namespace pugi {
class xml_node;
}

namespace lod2d {

/// What a paint leaves on the paper.
enum class SvgPaint { none, whole, fading };  ///< fading: a gradient, in part to nothing

/// What decides whether and how an element is drawn. Inherited from parent to child, but for
/// `drawn`, which a child cannot bring back.
struct SvgStyle {
    SvgPaint fill = SvgPaint::whole;
    bool fill_seen = true;  ///< fill-opacity above 0
    FillRule rule = FillRule::nonzero;
    SvgPaint stroke = SvgPaint::none;
    bool stroke_seen = true;
    bool stroke_by_box = false;  ///< by a gradient of the path's box: nothing where it is flat
    StrokeStyle pen;
    bool visible = true;
    bool drawn = true;  ///< no display: none and no opacity: 0 on the way here
};

/// What the gradient of a paint leaves.
struct SvgGradient {
    SvgPaint paint = SvgPaint::whole;
    bool of_box = true;  ///< in units of the box of what it paints
};
using GradientPaint = std::function<std::optional<SvgGradient>(std::string_view id)>;
/// The style of an element within one of the given style, from its attributes and its `style`,
/// where nothing in them takes more than a table to understand: nothing for whatever does (then
/// lod2d/source/resolve/resolve.hpp is asked). `gradient` tells what the gradient of an id leaves,
/// nothing where there is none that is plain.
[[nodiscard]] std::optional<SvgStyle> plain_style(const pugi::xml_node& element,
                                                  const SvgStyle& parent,
                                                  const GradientPaint& gradient);

/// What a gradient's stops leave, where they are plain.
[[nodiscard]] std::optional<SvgPaint> plain_stops(const pugi::xml_node& gradient);

}  // namespace lod2d
