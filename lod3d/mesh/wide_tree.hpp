#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lodlab/core/base/lanes.hpp"
#include "lodlab/lod3d/mesh/triangle_tree.hpp"

namespace lod3d {

/// The boxes of a triangle tree, four to a node and in single precision, for quick distances: half
/// the memory, and four boxes are tested at once. A box may only be too large, never too small.
class WideTree {
  public:
    static constexpr std::size_t width = 4;
    using Four = lod::Lanes<width>;

    /// Four boxes, in units of the mesh. An entry without a box is infinitely far from anything.
    struct Node {
        std::array<Four, 3> low;
        std::array<Four, 3> high;
        std::array<std::int32_t, width> first{};  ///< of a leaf its first triangle; else its node
        std::array<std::int32_t, width> count{};  ///< triangles of a leaf; 0 for an inner node
    };

    explicit WideTree(const TriangleTree& tree);

    /// Node 0 is the root.
    [[nodiscard]] const Node& node(std::int32_t i) const {
        return nodes_[static_cast<std::size_t>(i)];
    }
    /// A point in units of the mesh.
    [[nodiscard]] std::array<float, 3> place(const Point& p) const {
        const Point at = ((p - centre_) * per_unit_).cwiseMax(-farthest).cwiseMin(farthest);
        return {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())};
    }
    /// A squared distance [m^2] in units of the mesh.
    [[nodiscard]] float squared(double distance) const {
        return static_cast<float>((std::min)(distance * per_unit_ * per_unit_, most_squared));
    }

    /// No more than the squared distance of the point from each box, in units of the mesh.
    [[nodiscard]] static Four squared_distances(const Node& node, const std::array<float, 3>& p) {
        Four sum = Four::all(0);
        for (std::size_t d = 0; d < 3; ++d) {
            const Four at = Four::all(p[d]);
            const Four gap = upper(upper(node.low[d] - at, at - node.high[d]), Four::all(0));
            sum += gap * gap;
        }
        return sum * Four::all(below_rounding);
    }

  private:
    static constexpr double farthest = 1e15;      ///< squares stay finite
    static constexpr double most_squared = 1e35;  ///< beyond every squared distance
    static constexpr float below_rounding = 1 - 4e-6f;

    std::int32_t add(const TriangleTree& tree, std::int32_t root);

    Point centre_ = Point::Zero();
    double per_unit_ = 1;
    std::vector<Node> nodes_;
};

}  // namespace lod3d
