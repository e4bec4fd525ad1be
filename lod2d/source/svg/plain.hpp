#pragma once

#include <optional>

#include "lodlab/lod2d/source/svg/drawing.hpp"
#include "lodlab/lod2d/source/svg/settings.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {

/// Reads a drawing that takes no more than paths, basic shapes, groups, transforms and colours, to
/// the last bit and by no library but the XML's. Nothing for any other
/// (lod2d/source/resolve/resolve.hpp reads it): one with a style sheet, `use`, nested <svg>,
/// switch, clips, masks, markers, filters, patterns, CSS that says more than attributes do,
/// animations or conditions. Throws lod::Error as parse_svg() does.
[[nodiscard]] std::optional<SvgDrawing> read_plain_svg(const SvgXml& xml,
                                                       const SvgSettings& settings);

}  // namespace lod2d
