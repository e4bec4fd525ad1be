#pragma once

#include <filesystem>
#include <string_view>

#include "lodlab/lod2d/filled_paths.hpp"

namespace lod2d {

struct SvgSettings {
    OutlineSettings outline;
    std::size_t most_bytes = 64'000'000;
    std::size_t most_elements = 200'000;  ///< drawn, each time that `use` draws them
    int most_depth = 200;                 ///< of elements within elements
};

/// The shape that an SVG file draws: the union of all its filled regions, whatever their colour
/// (white too), as one rigid body, which may have several parts. Up in the picture is up (+y).
/// The shape is scaled by settings.outline.size; width, height and viewBox of the file set no
/// scale.
///
/// Read: path (all commands), rect, circle, ellipse, polygon, polyline; groups, nested svg, symbol,
/// use, switch; transform; fill, fill-rule, fill-opacity, opacity, display and visibility, as
/// attributes, in `style`, and in style sheets with selectors of one element, class or id.
/// Filled outlines count in full: clipping, masks and filters are not applied. Not drawn: whatever
/// has fill="none" (a file that only strokes is drawn by its strokes, at their width), text
/// (convert it to paths), images, and the contents of defs, clipPath, mask, pattern, marker.
///
/// Throws lod::Error naming the file and, where there is one, line and column: input refused for a
/// file that is missing, no SVG, broken, that uses itself, or that fills nothing; limit exceeded
/// (naming the limit) beyond the settings. Reads no other file.
[[nodiscard]] Shape load_svg(const std::filesystem::path& path, const SvgSettings& settings = {});

/// The same from text; `name` stands in the errors and names the shape.
[[nodiscard]] Shape parse_svg(const std::string& name, std::string_view text,
                              const SvgSettings& settings = {});

}  // namespace lod2d
