#pragma once

/// \file
/// A collision in space as a figure of the plane.

#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// The plane that a collision in space is projected onto: along the contacts' mean normal, from A
/// towards B, and square to it, as upright as can be. World frame, unit vectors.
struct ProjectionPlane {
    lod::Vector<3> along = lod::Vector<3>::UnitX();
    lod::Vector<3> up = lod::Vector<3>::UnitY();

    /// A point of space in the plane.
    [[nodiscard]] lod::Vector<2> operator()(const lod::Vector<3>& p) const {
        return {p.dot(along), p.dot(up)};
    }
};

/// Throws lod::Error (input refused) for no contacts.
[[nodiscard]] ProjectionPlane projection_plane(const std::vector<lod::Contact<3>>& contacts);

/// The paper's two-dimensional projection of a collision in space: seen along an axis square to the
/// normal, the spheres that intersect become circles, the bodies their outlines, and the normals
/// lie in the picture. `pair`: one of the record's, of A and B, with at least one contact;
/// otherwise throws lod::Error (input refused).
[[nodiscard]] Figure projected_collision(const Actor<3>& a, const Actor<3>& b,
                                         const lod::FrameRecord<3>& record,
                                         const lod::PairRecord& pair);

/// The region that a surface covers in that projection, holes and all: bounded by its silhouette.
[[nodiscard]] std::vector<Ring> projected_outline(const Surface& surface, const lod::Body<3>& body,
                                                  const ProjectionPlane& plane);

}  // namespace viz
