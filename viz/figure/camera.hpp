#pragma once

/// \file
/// From space to a panel of the plane: orthographic or in perspective.
/// World frame, metres, y up.

#include "lodlab/core/math/dimension.hpp"
#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// From a figure's points to lodlab's vectors, in the plane.
[[nodiscard]] inline lod::Vector<2> vector2(Point p) {
    return {p.x, p.y};
}
/// From lodlab's vectors to a figure's points.
[[nodiscard]] inline Point3 point3(const lod::Vector<3>& v) {
    return {v.x(), v.y(), v.z()};
}
/// And back.
[[nodiscard]] inline lod::Vector<3> vector3(Point3 p) {
    return {p.x, p.y, p.z};
}

/// The camera's axes: orthonormal, right-handed as (right, up, -forward).
struct CameraAxes {
    lod::Vector<3> right;
    lod::Vector<3> up;
    lod::Vector<3> forward;
};
/// Of a camera. Requires: its target is not in its eye.
[[nodiscard]] CameraAxes axes_of(const Camera& camera);

/// A camera that looks at `target` from the distance [m], from `azimuth` about y (0: it looks along
/// -z; growing, the eye moves towards +x) and `elevation` above the ground [rad], less than a right
/// angle.
[[nodiscard]] Camera orbit(const lod::Vector<3>& target, double distance, double azimuth,
                           double elevation, bool perspective);

/// The point on the panel (see Camera). In perspective a point behind the eye has none: it is taken
/// as if it lay just in front.
[[nodiscard]] Point project(const Camera& camera, const lod::Vector<3>& point);

/// How far in front of the eye a point lies, along the view [m].
[[nodiscard]] double depth_of(const Camera& camera, const lod::Vector<3>& point);

/// How much larger a metre at that point shows than one at the target: 1 in orthographic views.
[[nodiscard]] double magnification(const Camera& camera, const lod::Vector<3>& point);

/// What words should not cover: round every surface (ghosts aside) and every bold ball, on the
/// panel.
[[nodiscard]] std::vector<Ring> outlines_of(const SpaceScene& scene);

}  // namespace viz
