#pragma once

#include <algorithm>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// A side of a triangle, named by its lesser vertex first.
struct MeshSide {
    std::int32_t low = 0;
    std::int32_t high = 0;
    std::int32_t triangle = 0;
    std::int32_t place = 0;  ///< in the triangle: 0 between its first two corners
    bool upwards = false;    ///< the triangle passes it from low to high

    [[nodiscard]] bool same_edge(const MeshSide& other) const {
        return low == other.low && high == other.high;
    }
};

/// All sides, those of one edge side by side, by triangle and place.
[[nodiscard]] std::vector<MeshSide> sorted_sides(const Mesh& mesh);

/// Calls visit(first, last) for the sides of every edge.
template <typename Visit>
void each_edge(const std::vector<MeshSide>& sides, const Visit& visit) {
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(
            first, sides.end(), [&](const MeshSide& side) { return !side.same_edge(*first); });
        visit(first, last);
        first = last;
    }
}

}  // namespace lod3d
