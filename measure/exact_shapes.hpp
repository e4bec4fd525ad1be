#pragma once

#include <memory>

#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/lod3d/solid/surface.hpp"

namespace measure {

/// What a body's `exact` points to, for a shape of the plane or of space.
[[nodiscard]] inline std::shared_ptr<const lod::ExactShape<2>> exact_shape(
    const lod2d::Shape& shape) {
    return std::make_shared<const lod2d::ExactOutline>(shape);
}
[[nodiscard]] inline std::shared_ptr<const lod::ExactShape<3>> exact_shape(
    const lod3d::Solid& solid) {
    return std::make_shared<const lod3d::ExactSurface>(solid);
}

}  // namespace measure
