#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lodlab/lod2d/source/svg/drawing.hpp"

namespace lod2d {

/// What relative values of CSS are of, as far as the document decides it.
struct SvgFrame {
    std::optional<Point> percent_of;  ///< nothing where elements have viewports of their own
    std::optional<double> root_font;  ///< [px], what rem counts
    bool has_uses = false;
    bool has_viewports = false;  ///< nested <svg> and <symbol>
};

/// The value of a property, in lower case, as a library with an old or small CSS is to see it; ""
/// where the declaration is to be left out. What a browser follows and this cannot say is a doubt.
[[nodiscard]] std::string followed_value(std::string_view property, std::string text,
                                         const SvgFrame& frame, SvgNotes& notes);

/// Whether its value is a length, or several.
[[nodiscard]] bool is_svg_length(std::string_view property);

/// Whether a transform-origin is where it is anyway.
[[nodiscard]] bool is_svg_origin(std::string_view text);

/// A transform of CSS in words that every library knows: its lengths in px, its angles in degrees,
/// what of it lies in the plane. "" where it is no transform, so that browsers leave it out;
/// nothing where it leaves the plane or takes a font or a viewport to understand.
[[nodiscard]] std::optional<std::string> followed_transform(std::string_view text,
                                                            const SvgFrame& frame);

}  // namespace lod2d
