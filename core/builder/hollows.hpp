#pragma once

#include <algorithm>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/builder/protrusion.hpp"
#include "lodlab/core/math/box.hpp"
#include "lodlab/core/tree/hull.hpp"
#include "lodlab/core/tree/tree.hpp"

namespace lod {

/// A hollow is free for other bodies where a ball of more than this share of the root ball's radius
/// fits between a hull and the shape. Half: gear:9, star:9 and ring enter at level 2 instead of 0,
/// 0 and 1, for notches in which nothing lies, and their errors at levels 0 and 1 are those of
/// level 2 at its cost; double: a ring enters at 0 and fills its hole, .146 instead of .093 there.
inline constexpr double hollow_share = 0.3;

/// Whether some point of the hull lies farther from the shape than `reach` [m], to within an eighth
/// of it.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] bool stands_out(const HullView<Dim>& hull, const Distance& shape, double reach) {
    struct Cube {
        Vector<Dim> centre;
        double half;
    };
    Box<Dim> box;
    for (const Vector<Dim>& corner : hull.corners) box.hold(corner);
    if (hull.empty()) return false;
    const double root_of_dim = std::sqrt(static_cast<double>(Dim));
    const double finest =
        reach / 16;  // half a cube's side; 8 and 32 give all shapes the same levels
    std::vector<Cube> waiting{{box.centre(), box.size().maxCoeff() / 2}};
    while (!waiting.empty()) {
        const auto [centre, half] = waiting.back();
        waiting.pop_back();
        double beyond = -half * root_of_dim;
        for (std::size_t face = 0; face < hull.normals.size(); ++face)
            beyond = (std::max)(beyond, hull.normals[face].dot(centre) - hull.offsets[face]);
        if (beyond > half * root_of_dim) continue;  // no part of the cube is within the hull
        const double distance = shape.distance(centre);
        if (beyond <= 0 && distance > reach) return true;
        if (distance + half * root_of_dim <= reach || half < finest) continue;
        for (int part = 0; part < 1 << Dim; ++part) {
            Vector<Dim> middle = centre;
            for (int axis = 0; axis < Dim; ++axis)
                middle[axis] += (part >> axis & 1) != 0 ? half / 2 : -half / 2;
            waiting.push_back({middle, half / 2});
        }
    }
    return false;
}

/// The first level none of whose hulls covers a hollow (hollow_share); the deepest where all do.
/// Requires: the tree's hulls.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] int find_entry_level(const SphereTree<Dim>& tree, const Distance& shape) {
    const double reach = hollow_share * tree.radius[0];
    for (int level = 0; level + 1 < tree.levels(); ++level) {
        check_interrupted();
        const std::vector<int> nodes = tree.level_nodes(level);
        const bool covers = std::any_of(nodes.begin(), nodes.end(), [&](int node) {
            return stands_out<Dim>(tree.hulls.of(tree.hulls.best(node)), shape, reach);
        });
        if (!covers) return level;
    }
    return tree.levels() - 1;
}

}  // namespace lod
