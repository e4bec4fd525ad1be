#pragma once

/// \file
/// The triangles of a mesh in a tree of boxes, as queries of distance and intersection take them.

#include <cstdint>
#include <vector>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {

/// A tree of boxes over the triangles of a mesh: what distance and intersection queries walk.
/// Holds its own copy of the corners, those of one leaf side by side.
class TriangleTree {
  public:
    static constexpr int most_in_leaf = 4;
    static constexpr int deepest = 96;  ///< a walk's stack never needs more

    /// A box and what is below it.
    struct Node {
        Point low;
        Point high;
        std::int32_t first =
            0;  ///< a leaf's first triangle; else the second child (first: this + 1)
        std::int32_t count = 0;  ///< triangles of a leaf; 0 for an inner node
        /// Whether triangles lie below it, not boxes.
        [[nodiscard]] bool is_leaf() const { return count > 0; }
    };
    /// Of one triangle.
    struct Corners {
        Point a;
        Point b;
        Point c;
    };

    /// Requires: at least one triangle, numbers checked.
    explicit TriangleTree(const Mesh& mesh);

    /// Node 0 is the root.
    [[nodiscard]] const Node& node(std::int32_t i) const {
        return nodes_[static_cast<std::size_t>(i)];
    }
    /// How many boxes.
    [[nodiscard]] std::int32_t node_count() const {
        return static_cast<std::int32_t>(nodes_.size());
    }
    /// In the order of the leaves.
    [[nodiscard]] const Corners& corners(std::int32_t i) const {
        return corners_[static_cast<std::size_t>(i)];
    }
    /// The mesh's number of the i-th triangle in the order of the leaves.
    [[nodiscard]] std::int32_t triangle(std::int32_t i) const {
        return order_[static_cast<std::size_t>(i)];
    }

  private:
    std::int32_t build(std::int32_t first, std::int32_t count, int depth,
                       const std::vector<Point>& middles, const Mesh& mesh);

    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;
    std::vector<Corners> corners_;
};

/// Squared distance of a point from a box; 0 inside.
[[nodiscard]] inline double squared_distance(const TriangleTree::Node& box, const Point& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).squaredNorm();
}

}  // namespace lod3d
