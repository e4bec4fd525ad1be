#pragma once

/// \file
/// Distances from a polygon, and whether a point is inside, in O(log n).

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// Where a body stands: body frame to world frame.
struct Pose {
    Point position = {0, 0};  ///< of the centre of mass [m]
    double angle = 0;         ///< [rad]
};

/// The point of the segment ab that is nearest to p.
[[nodiscard]] Point nearest_on_segment(const Point& a, const Point& b, const Point& p);

/// The boundary point that is nearest to a query.
struct NearestPoint {
    Point point = {0, 0};
    double distance = 0;    ///< to the boundary, >= 0 [m]
    std::int32_t edge = 0;  ///< see BoundaryIndex::edge_start
};

/// A polygon's edges in a tree of boxes. A box holds a run of consecutive edges of one ring, or
/// several whole rings, so that a run to one side of a ray counts by its two ends alone.
/// Requires a polygon as shape.hpp describes it. Queries take O(log n) on usual outlines, allocate
/// nothing, and may run in parallel.
class BoundaryIndex {
  public:
    /// A box of the tree and what follows it.
    struct Node {
        Box box;
        std::int32_t right = 0;       ///< the second child; the first follows its parent. 0: a leaf
        std::uint32_t after = 0;      ///< the node that follows this one and all below it
        std::int32_t first_edge = 0;  ///< of the run; undefined over several rings
        std::int32_t last_edge = 0;   ///< one past the run
        bool one_run = false;         ///< edges of one ring
    };

    /// Copies the polygon's points.
    explicit BoundaryIndex(const Polygon& polygon);

    /// Whether the point lies in the closed region. Exact (see orientation.hpp).
    [[nodiscard]] bool inside(const Point& p) const;
    /// The boundary point nearest to p.
    [[nodiscard]] NearestPoint nearest(const Point& p) const;
    /// To the region: 0 inside [m].
    [[nodiscard]] double distance(const Point& p) const;
    /// To the boundary, negative inside [m].
    [[nodiscard]] double signed_distance(const Point& p) const;

    /// Writes the same boundary under a pose into `result`, whose storage is used again.
    void carry(const Pose& pose, BoundaryIndex& result) const;
    /// The same boundary under a pose.
    [[nodiscard]] BoundaryIndex carried(const Pose& pose) const;

    /// Node 0 is the root.
    [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
    /// Where an edge begins; its region lies on its left.
    [[nodiscard]] const Point& edge_start(std::int32_t edge) const { return points_[index(edge)]; }
    /// Where it ends.
    [[nodiscard]] const Point& edge_end(std::int32_t edge) const {
        return points_[index(edge + 1)];
    }
    /// The first edge of each ring; edge numbers run on from there, and skip one between two rings.
    [[nodiscard]] std::span<const std::int32_t> ring_starts() const { return ring_starts_; }

  private:
    static constexpr int edges_in_leaf = 4;
    static constexpr int deepest = 64;

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    void build_run(std::int32_t first_edge, std::int32_t last_edge);
    void build_rings(std::span<std::int32_t> rings, std::span<const Box> boxes);
    void fit_boxes();
    [[nodiscard]] Box box_of_run(const Node& node) const;

    std::vector<Point> points_;  ///< ring by ring, each with its first point repeated at the end
    std::vector<std::int32_t> ring_starts_;
    std::vector<std::int32_t> ring_ends_;
    std::vector<Node> nodes_;  ///< depth first
};

/// Calls visit(edge) for every edge within `reach` of the point, ends included.
template <typename Visit>
void visit_edges_near(const BoundaryIndex& index, const Point& p, double reach, Visit&& visit) {
    const auto nodes = index.nodes();
    for (std::size_t at = 0; at < nodes.size();) {
        const BoundaryIndex::Node& node = nodes[at];
        if (node.box.squared_distance(p) > reach * reach) {
            at = node.after;
            continue;
        }
        if (node.right == 0)
            for (std::int32_t e = node.first_edge; e < node.last_edge; ++e)
                if ((nearest_on_segment(index.edge_start(e), index.edge_end(e), p) - p)
                        .squaredNorm() <= reach * reach)
                    visit(e);
        ++at;
    }
}

}  // namespace lod2d
