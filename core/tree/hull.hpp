#pragma once

/// \file
/// The convex hulls of a tree's nodes, which tell contacts better than the balls do.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// Faces of a node's hull at most.
template <int Dim>
inline constexpr int most_hull_faces = Dim * 8;
/// Corners of one: in the plane as many as faces; in space no polytope has more than 2 F - 4.
template <int Dim>
inline constexpr int most_hull_corners = (Dim - 1) * most_hull_faces<Dim>;

/// A convex polygon or polytope. Metres.
template <int Dim>
struct Hull {
    std::vector<Vector<Dim>> corners;
    /// Corner numbers of each face: in space anticlockwise seen from outside, in the plane the two
    /// ends of a side, anticlockwise about the polygon.
    std::vector<std::vector<std::int32_t>> faces;
    /// Of each face: whether it lies within the shape, where the node's piece was cut from its
    /// neighbours'. Nothing can touch the shape there.
    std::vector<bool> inner;
    /// Of each corner: whether only such a cut made it, so that the shape's surface goes on there.
    std::vector<bool> cut;
    /// Whether the hull is the node's piece itself, all but a hair: the piece is convex.
    bool tight = false;
    /// Whether the node's ball stands out of the shape less than the hull does.
    bool round = false;

    /// The mean of a face's corners.
    [[nodiscard]] Vector<Dim> middle(const std::vector<std::int32_t>& face) const {
        Vector<Dim> middle = Vector<Dim>::Zero();
        for (const std::int32_t corner : face)
            middle += corners[static_cast<std::size_t>(corner)] / static_cast<double>(face.size());
        return middle;
    }
};

/// Where two faces of a polytope meet.
struct HullEdge {
    std::int32_t from = 0;  ///< corner numbers; `left` runs from one to the other
    std::int32_t to = 0;
    std::int32_t left = 0;  ///< faces
    std::int32_t right = 0;
};

/// One hull of many, in whatever frame they stand. A half-space has one face and no corners.
template <int Dim>
struct HullView {
    std::span<const Vector<Dim>> corners;
    std::span<const Vector<Dim>> normals;      ///< of each face, unit, outward
    std::span<const double> offsets;           ///< of each face: normal . x <= offset within
    std::span<const char> inner;               ///< of each face: whether it lies within the shape
    std::span<const char> cut;                 ///< of each corner: whether only a cut made it
    std::span<const std::int32_t> loop_begin;  ///< of each face and after the last, into loops
    std::span<const std::int32_t> loops;       ///< corner numbers, face by face
    std::span<const HullEdge> edges;           ///< none in the plane

    /// Whether there is no hull, as below a tight one.
    [[nodiscard]] bool empty() const { return normals.empty(); }
    /// Whether every edge between two faces (in the plane every corner between two sides) is run
    /// through once each way: the faces are all there and turned the same way.
    [[nodiscard]] bool is_closed() const;
    /// The corners of a face, by number.
    [[nodiscard]] std::span<const std::int32_t> loop(std::size_t face) const {
        const auto first = static_cast<std::size_t>(loop_begin[face]);
        return loops.subspan(first, static_cast<std::size_t>(loop_begin[face + 1]) - first);
    }
};

/// The hulls of a tree's nodes, body frame: each holds all of the shape that its node owns
/// (METHOD.md, node hulls), those below a tight one left out. No hulls: empty.
template <int Dim>
class NodeHulls {
  public:
    /// Appends the next node's; one without faces for a node below a tight one. A face's plane
    /// follows from its corners: its normal is that of the facet, its offset the largest of its own
    /// corners.
    void add(const Hull<Dim>& hull);

    /// The next node's: a half-space with its border through the origin, one face without corners.
    void add_half_space(const Vector<Dim>& normal);

    /// Whether the tree has none.
    [[nodiscard]] bool empty() const { return corner_begin_.size() == 1; }
    /// How many nodes have an entry.
    [[nodiscard]] int size() const { return static_cast<int>(corner_begin_.size()) - 1; }
    /// The node's own, empty below a tight one. Requires: node < size().
    [[nodiscard]] HullView<Dim> of(int node) const;
    /// The corners of of(node) alone.
    [[nodiscard]] std::span<const Vector<Dim>> corners_of(int node) const {
        const auto n = static_cast<std::size_t>(node);
        const auto first = static_cast<std::size_t>(corner_begin_[n]);
        return {corners_.data() + first, static_cast<std::size_t>(corner_begin_[n + 1]) - first};
    }
    /// Whether Hull::tight was set for the node.
    [[nodiscard]] bool is_tight(int node) const { return tight_[static_cast<std::size_t>(node)]; }

    /// Whether Hull::round was set for the node.
    [[nodiscard]] bool is_round(int node) const { return round_[static_cast<std::size_t>(node)]; }

    /// The node whose hull says where this one's surface is: the highest above it (or itself) whose
    /// hull is tight, else itself. A part of a convex piece knows less of its surface than the
    /// piece.
    [[nodiscard]] int best(int node) const { return best_[static_cast<std::size_t>(node)]; }
    /// Finds the best nodes. Requires: a parent's number is less than its children's.
    void find_best(std::span<const std::int32_t> parent);

    /// The first level whose hulls leave the shape's hollows free (find_hollows): bodies may lie
    /// there, so that what meets a coarser level only is no collision yet.
    int entry_level = 0;

  private:
    std::vector<std::int32_t> corner_begin_{0};
    std::vector<std::int32_t> face_begin_{0};
    std::vector<std::int32_t> edge_begin_{0};
    std::vector<std::int32_t> loop_begin_{0};
    std::vector<Vector<Dim>> corners_;
    std::vector<Vector<Dim>> normals_;
    std::vector<double> offsets_;
    std::vector<char> inner_;
    std::vector<char> cut_;
    std::vector<char> tight_;
    std::vector<char> round_;
    std::vector<std::int32_t> best_;
    std::vector<std::int32_t> loops_;
    std::vector<HullEdge> edges_;
};

extern template struct HullView<2>;
extern template struct HullView<3>;
extern template class NodeHulls<2>;
extern template class NodeHulls<3>;

}  // namespace lod
