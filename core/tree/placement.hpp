#pragma once

/// \file
/// Where a body stands, and how one stands to another.

#include "lodlab/core/tree/body.hpp"

namespace lod {

/// Where a body stands: body frame to world frame.
template <int Dim>
struct Placement {
    Matrix<Dim> rotation = Matrix<Dim>::Identity();
    Vector<Dim> position = Vector<Dim>::Zero();

    /// A point of the body frame in the world.
    [[nodiscard]] Vector<Dim> carry(const Vector<Dim>& p) const { return rotation * p + position; }
};

/// Where a body stands now.
template <int Dim>
[[nodiscard]] Placement<Dim> placement(const Body<Dim>& body) {
    return {Space<Dim>::rotation(body.orientation), body.position};
}

/// Body B's frame seen from body A's.
template <int Dim>
[[nodiscard]] Placement<Dim> seen_from(const Placement<Dim>& a, const Placement<Dim>& b) {
    return {a.rotation.transpose() * b.rotation,
            a.rotation.transpose() * (b.position - a.position)};
}

}  // namespace lod
