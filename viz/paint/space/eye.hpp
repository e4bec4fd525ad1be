#pragma once

#include <algorithm>

#include "lodlab/viz/figure/camera.hpp"

namespace viz {

/// The camera's own frame: x to the right, y up, z forward from the eye [m], and the pixels of a
/// picture that it takes.
struct Eye {
    CameraAxes axes;
    lod::Vector<3> origin;
    double distance;  ///< to the target
    bool perspective;
    Box view;                 ///< of the panel: what the picture shows
    double metres_per_pixel;  ///< of the panel

    Eye(const Camera& camera, const Box& shown, int width)
        : axes(axes_of(camera)),
          origin(vector3(camera.eye)),
          distance((vector3(camera.target) - origin).norm()),
          perspective(camera.perspective),
          view(shown),
          metres_per_pixel((shown.high.x - shown.low.x) / width) {}

    /// A direction of the world in the eye's frame.
    [[nodiscard]] lod::Vector<3> turned(const lod::Vector<3>& v) const {
        return {v.dot(axes.right), v.dot(axes.up), v.dot(axes.forward)};
    }
    [[nodiscard]] lod::Vector<3> seen(const lod::Vector<3>& p) const { return turned(p - origin); }
    [[nodiscard]] lod::Vector<3> world(const lod::Vector<3>& p) const {
        return origin + p.x() * axes.right + p.y() * axes.up + p.z() * axes.forward;
    }
    /// Metres of the panel for a metre at a depth.
    [[nodiscard]] double magnification(double z) const {
        return perspective ? distance / (std::max)(z, 1e-3 * distance) : 1;
    }
    /// From the eye's frame to pixels, y down.
    [[nodiscard]] Point pixel(const lod::Vector<3>& p) const {
        const double size = magnification(p.z());
        return {(size * p.x() - view.low.x) / metres_per_pixel,
                (view.high.y - size * p.y()) / metres_per_pixel};
    }
    /// The line of sight through a pixel: from + z along, z the depth.
    struct Ray {
        lod::Vector<3> from;
        lod::Vector<3> along;
        [[nodiscard]] lod::Vector<3> at(double z) const { return from + z * along; }
    };
    [[nodiscard]] Ray ray(double pixel_x, double pixel_y) const {
        const double x = view.low.x + pixel_x * metres_per_pixel;
        const double y = view.high.y - pixel_y * metres_per_pixel;
        if (!perspective) return {{x, y, 0}, {0, 0, 1}};
        return {{0, 0, 0}, {x / distance, y / distance, 1}};
    }
    /// The least depth that is seen.
    [[nodiscard]] double nearest_depth() const { return perspective ? 1e-3 * distance : -1e30; }
};

}  // namespace viz
