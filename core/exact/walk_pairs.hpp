#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/exact_shape.hpp"

namespace lod {

/// A node's box in a tree of boxes over the facets of a boundary, in the body's frame.
template <int Dim>
struct BoxNode {
    Vector<Dim> low;
    Vector<Dim> high;
    std::int32_t second = 0;  ///< of an inner node: its second child; the first follows it
    std::int32_t first = 0;   ///< of a leaf: its facets
    std::int32_t last = 0;    ///< one past them
    [[nodiscard]] bool is_leaf() const { return second == 0; }
};

/// Walks the pairs of facets of two shapes whose boundaries hang in trees of boxes, near boxes
/// first. `Boundary` has `BoxNode<Dim> box_node(int) const` (0 is the root, children follow their
/// parents) and `facet(int) const`, which returns a Facet<Dim>, or a ball for a boundary of balls.
/// `nearest(facet_a, facet_b, feet_within)` returns their PartPair, in A's frame.
template <int Dim, class Boundary, class Nearest>
class PairWalk {
  public:
    PairWalk(const Boundary& a, const Boundary& b, const Placement<Dim>& b_in_a,
             const Nearest& nearest)
        : a_(a), b_(b), place_(b_in_a), nearest_(nearest) {}

    void run(PartVisitor<Dim>& visitor) {
        // A walk holds at most one pair a level of either tree.
        std::vector<Pair> waiting{pair_of(0, 0)};
        while (!waiting.empty() && !visitor.is_done()) {
            const Pair at = waiting.back();
            waiting.pop_back();
            if (skipped(at, visitor)) continue;
            if (at.node_a.is_leaf() && at.node_b.is_leaf()) {
                visit_facets(at, visitor);
                continue;
            }
            Pair nearer = opens_a(at) ? pair_of(at.a + 1, at.b) : pair_of(at.a, at.b + 1);
            Pair farther =
                opens_a(at) ? pair_of(at.node_a.second, at.b) : pair_of(at.a, at.node_b.second);
            if (farther.gap < nearer.gap) std::swap(nearer, farther);
            waiting.push_back(farther);
            waiting.push_back(nearer);
        }
    }

  private:
    struct Pair {
        std::int32_t a;
        std::int32_t b;
        BoxNode<Dim> node_a;
        BoxNode<Dim> node_b;
        double gap;             ///< the boxes are apart by so much at least; 0: perhaps not
        Vector<Dim> direction;  ///< along this unit vector, A's frame; where gap > 0
    };

    /// The gap along A's axes or along B's, whichever is larger.
    Pair pair_of(std::int32_t i, std::int32_t j) const {
        Pair pair{i, j, a_.box_node(i), b_.box_node(j), 0, Vector<Dim>::Zero()};
        const Vector<Dim> half_a = 0.5 * (pair.node_a.high - pair.node_a.low);
        const Vector<Dim> half_b = 0.5 * (pair.node_b.high - pair.node_b.low);
        const Vector<Dim> between = place_.carry(0.5 * (pair.node_b.low + pair.node_b.high)) -
                                    0.5 * (pair.node_a.low + pair.node_a.high);
        const Vector<Dim> along_a = beyond(between, half_a + size_ * half_b);
        const Vector<Dim> along_b =
            beyond(place_.rotation.transpose() * between, half_b + size_.transpose() * half_a);
        const bool by_a = along_a.squaredNorm() >= along_b.squaredNorm();
        pair.gap = by_a ? along_a.norm() : along_b.norm();
        if (pair.gap > 0)
            pair.direction = (by_a ? along_a : Vector<Dim>(place_.rotation * along_b)) / pair.gap;
        return pair;
    }

    /// What a vector sticks out of a box about the origin.
    static Vector<Dim> beyond(const Vector<Dim>& v, const Vector<Dim>& half) {
        return v - v.cwiseMax(-half).cwiseMin(half);
    }

    static bool opens_a(const Pair& pair) {
        if (pair.node_a.is_leaf()) return false;
        if (pair.node_b.is_leaf()) return true;
        return (pair.node_a.high - pair.node_a.low).squaredNorm() >=
               (pair.node_b.high - pair.node_b.low).squaredNorm();
    }

    static ConvexPart<Dim> box_part(const BoxNode<Dim>& node) {
        ConvexPart<Dim> part;
        for (; part.count < part.most_corners; ++part.count)
            for (int axis = 0; axis < Dim; ++axis)
                part.corner[part.count][axis] =
                    (part.count >> axis) % 2 ? node.high[axis] : node.low[axis];
        return part;
    }

    bool skipped(const Pair& at, const PartVisitor<Dim>& visitor) const {
        if (at.gap <= 0) return false;
        ConvexPart<Dim> carried = box_part(at.node_b);
        for (Vector<Dim>& corner : carried.corner) corner = place_.carry(corner);
        return visitor.skips(box_part(at.node_a), carried, at.direction, at.gap);
    }

    void visit_facets(const Pair& at, PartVisitor<Dim>& visitor) {
        for (std::int32_t j = at.node_b.first; j < at.node_b.last; ++j) {
            const auto carried = carry(b_.facet(j));
            for (std::int32_t i = at.node_a.first; i < at.node_a.last; ++i)
                visitor.visit(nearest_(a_.facet(i), carried, visitor.feet_within));
        }
    }

    Facet<Dim> carry(Facet<Dim> facet) const {
        for (Vector<Dim>& corner : facet) corner = place_.carry(corner);
        return facet;
    }
    Sphere<Dim> carry(const Sphere<Dim>& ball) const {
        return {place_.carry(ball.centre), ball.radius};
    }

    const Boundary& a_;
    const Boundary& b_;
    Placement<Dim> place_;
    const Nearest& nearest_;
    /// Rounding may make a rotation's entries too small by a few units.
    Matrix<Dim> size_ = place_.rotation.cwiseAbs() + Matrix<Dim>::Constant(1e-15);
};

/// The shape as a Boundary. Throws Error (input refused) where it is none; `kind` says what one is.
template <class Boundary, int Dim>
[[nodiscard]] const Boundary& of_kind(const ExactShape<Dim>& shape, const std::string& kind) {
    const auto* other = dynamic_cast<const Boundary*>(&shape);
    if (!other) refuse_input(kind, "it meets its own kind only; give both bodies one");
    return *other;
}

/// Walks two boundaries as PairWalk does.
template <int Dim, class Boundary, class Nearest>
void walk_pairs(const Boundary& a, const Boundary& b, const Placement<Dim>& b_in_a,
                const Nearest& nearest, PartVisitor<Dim>& visitor) {
    PairWalk<Dim, Boundary, Nearest>(a, b, b_in_a, nearest).run(visitor);
}

}  // namespace lod
