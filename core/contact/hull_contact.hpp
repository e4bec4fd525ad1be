#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "lodlab/core/contact/contact.hpp"
#include "lodlab/core/tree/hull.hpp"

namespace lod {

/// A node's hull in the world's directions, about an origin that both hulls of a pair share.
template <int Dim>
struct PosedHull {
    std::array<Vector<Dim>, most_hull_corners<Dim>> corners;
    std::array<Vector<Dim>, most_hull_faces<Dim>> normals;
    std::array<double, most_hull_faces<Dim>> offsets;
    HullView<Dim> body;  ///< the same, body frame

    /// `position`: of the body from the common origin. Requires: no more faces and corners than
    /// there is room for.
    void pose(const HullView<Dim>& hull, const Matrix<Dim>& rotation, const Vector<Dim>& position);
};

/// How two bodies move against each other.
template <int Dim>
struct PairMotion {
    Vector<Dim> centre_a;  ///< of mass, from the common origin [m]
    Vector<Dim> centre_b;
    Vector<Dim> velocity_a;
    Vector<Dim> velocity_b;
    Spin<Dim> spin_a;
    Spin<Dim> spin_b;
    double time_step = 0;  ///< of the frame [s]

    /// The velocity of B's material point at p relative to A's.
    [[nodiscard]] Vector<Dim> at(const Vector<Dim>& p) const {
        return (velocity_b + Space<Dim>::cross(spin_b, p - centre_b)) -
               (velocity_a + Space<Dim>::cross(spin_a, p - centre_a));
    }
};

/// With A's centre of mass as the origin.
template <int Dim>
[[nodiscard]] PairMotion<Dim> pair_motion(const Body<Dim>& a, const Body<Dim>& b,
                                          double time_step) {
    return {Vector<Dim>::Zero(),
            b.position - a.position,
            a.velocity,
            b.velocity,
            a.spin,
            b.spin,
            time_step};
}

/// Where two hulls touch: one normal, and few points. With one normal the closing velocity is
/// affine in the point, so that the two extremes decide as much as all in the plane, and the
/// corners of their outline in space, of which four are kept.
template <int Dim>
struct Manifold {
    static constexpr std::size_t most_points = most_patch_points<Dim>;
    Vector<Dim> normal = Vector<Dim>::Zero();  ///< unit, from A to B
    std::array<Vector<Dim>, most_points> points;
    std::array<double, most_points> depths{};  ///< [m], >= 0
    std::size_t count = 0;

    [[nodiscard]] double depth() const;  ///< of the deepest point
    /// Whether the bodies part at every point.
    [[nodiscard]] bool parts(const PairMotion<Dim>& motion) const;
};

/// Where two hulls meet (METHOD.md, node hulls). Of the faces of both, inner ones left out, that
/// along which the hulls overlap least gives the normal; but where some were crossed within the
/// last time step, as the centres of mass move, the one crossed last: there the bodies met. The
/// facet that lies against the face, clipped to it, gives the points, as far as they are within,
/// halfway between the two surfaces. One may be a half-space, whose face then decides. Returns
/// nothing where some face separates the hulls by more
/// than `slack` [m]: a proof that what they hold is apart.
template <int Dim>
[[nodiscard]] std::optional<Manifold<Dim>> meet(const PosedHull<Dim>& a, const PosedHull<Dim>& b,
                                                const PairMotion<Dim>& motion, double slack);

}  // namespace lod
