#pragma once

// The Flexible Collision Library as an oracle, and what it does not answer: whether one solid lies
// wholly inside the other. Neither shares code with lod3d.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <memory>

#include "lodlab/core/math/eigen.hpp"
#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lodtest {

using FclModel = fcl::BVHModel<fcl::OBBRSSd>;

inline std::shared_ptr<FclModel> fcl_model(const lod3d::Mesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    for (const lod3d::Triangle& t : mesh.triangles)
        triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                               static_cast<std::size_t>(t[2]));
    auto model = std::make_shared<FclModel>();
    model->beginModel();
    std::vector<fcl::Vector3d> vertices;
    for (const lod3d::Point& p : mesh.vertices) vertices.push_back(lod::to_eigen(p));
    model->addSubModel(vertices, triangles);
    model->endModel();
    return model;
}

inline fcl::Transform3d fcl_pose(const lod::Matrix<3>& rotation, const lod3d::Point& position) {
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.linear() = lod::to_eigen(rotation);
    pose.translation() = lod::to_eigen(position);
    return pose;
}

/// Whether the surfaces share a point.
inline bool fcl_collide(const std::shared_ptr<FclModel>& a, const fcl::Transform3d& pose_a,
                        const std::shared_ptr<FclModel>& b, const fcl::Transform3d& pose_b) {
    fcl::CollisionResultd result;
    return fcl::collide(a.get(), pose_a, b.get(), pose_b, fcl::CollisionRequestd(), result) > 0;
}

/// Whether the point lies in the solid: a ray in a direction that meets no edge passes the surface
/// an odd number of times. A cavity is outside.
inline bool ray_inside(const lod3d::Mesh& mesh, const lod3d::Point& p) {
    const lod3d::Point way = lod3d::Point(0.5377, 0.8339, -0.2259).normalized();
    int passes = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const lod3d::Point ab = mesh.corner(t, 1) - mesh.corner(t, 0);
        const lod3d::Point ac = mesh.corner(t, 2) - mesh.corner(t, 0);
        const lod3d::Point h = way.cross(ac);
        const double det = ab.dot(h);
        if (det == 0) continue;
        const lod3d::Point s = p - mesh.corner(t, 0);
        const double u = s.dot(h) / det;
        const lod3d::Point q = s.cross(ab);
        const double v = way.dot(q) / det;
        if (u < 0 || v < 0 || u + v > 1) continue;
        passes += ac.dot(q) / det > 0;
    }
    return passes % 2 == 1;
}

}  // namespace lodtest
