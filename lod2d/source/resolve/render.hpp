#pragma once

#include <string>

#include "lodlab/lod2d/source/paths/curve_path.hpp"
#include "lodlab/lod2d/source/resolve/prepare.hpp"

namespace lod2d {

/// A drawing as Cairo's script surface writes it, for read_cairo_script().
struct SvgScript {
    std::string text;
    Affine to_page;
    double precision = 0;  ///< the share of its size that its coordinates are right to
};

/// The whole drawing, as large as librsvg draws all of it: newer releases leave out what they take
/// to be beyond Cairo's numbers. Nothing interrupts it. Throws lod::Error as resolve_svg() does.
[[nodiscard]] SvgScript render_svg(const std::string& name, const PreparedSvg& svg);

/// Of the library that is linked: "2.54.7".
[[nodiscard]] std::string librsvg_version();

}  // namespace lod2d
