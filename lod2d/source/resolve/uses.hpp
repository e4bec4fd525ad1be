#pragma once

#include "lodlab/lod2d/source/svg/settings.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {

/// Throws lod::Error: input refused where an element draws itself by `use`; limit exceeded where
/// more than settings.most_elements are drawn, each time that `use` draws them, or they nest deeper
/// than settings.most_depth.
void check_svg_uses(const SvgXml& xml, const SvgSettings& settings);

}  // namespace lod2d
