#pragma once

/// \file
/// Proves that a tree covers its shape, level by level, for any tree: one that a builder made or
/// one that was loaded.

#include <algorithm>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"
#include "lodlab/core/tree/tree.hpp"

namespace lod {

/// What is proved of one level of a tree: that every point of the shape, surface and interior, lies
/// in every ball of a chain from the root to a node of the level (or to a leaf above it).
struct LevelCertificate {
    bool certified = false;
    double uncovered =
        0;  ///< upper bound of the share of the measure without a chain; 0 if certified
};

namespace detail {

template <int Dim, PieceOf<Dim> Piece>
struct Certifier {
    const SphereTree<Dim>& tree;
    double margin;
    std::vector<double> lost;    ///< measure whose chain breaks at the level
    std::vector<char> complete;  ///< whether no chain breaks at the level

    void visit(int node, int level, const Piece& owned) {
        if (owned.vertices().empty()) return;
        const auto at = static_cast<std::size_t>(level);
        Sphere<Dim> ball = tree.sphere(node);
        ball.radius -= margin;
        if (farthest_distance<Dim>(ball.centre, owned.vertices()) <= ball.radius)
            return visit_children(node, level, owned);
        complete[at] = 0;
        auto [held, rest] = owned.held_by(ball);
        lost[at] += rest;
        visit_children(node, level, held);
    }

    void visit_children(int node, int level, const Piece& held) {
        if (tree.is_leaf(node) || held.vertices().empty()) return;
        check_interrupted();
        std::vector<Sphere<Dim>> balls;
        const int first = tree.first_child[tree.index(node)];
        for (int c = 0; c < tree.child_count[tree.index(node)]; ++c)
            balls.push_back(tree.sphere(first + c));
        for (std::size_t c = 0; c < balls.size(); ++c)
            visit(first + static_cast<int>(c), level + 1, held.within(power_cell<Dim>(balls, c)));
    }
};

}  // namespace detail

/// The certificate of coverage, for any tree and the whole shape, one entry a level.
///
/// Each node owns a piece: the root the whole shape, a child what of its parent's piece lies in its
/// cell of the power diagram of the children's balls. Where any child holds a point, the child
/// whose cell it is does, and a ball holds a piece exactly where it holds its vertices; so the
/// children cover the parent's piece if and only if each holds the vertices of its own. A vertex
/// must lie inside by half of rounding_bound(root), which covers the rounding of the cuts.
template <int Dim, PieceOf<Dim> Piece>
[[nodiscard]] std::vector<LevelCertificate> certify(const SphereTree<Dim>& tree,
                                                    const Piece& whole) {
    const auto levels = static_cast<std::size_t>(tree.levels());
    detail::Certifier<Dim, Piece> certifier{tree, rounding_bound(tree.sphere(0)) / 2,
                                            std::vector<double>(levels, 0.0),
                                            std::vector<char>(levels, 1)};
    certifier.visit(0, 0, whole);
    std::vector<LevelCertificate> result(levels);
    bool complete = true;
    double lost = 0;
    for (std::size_t level = 0; level < levels; ++level) {
        complete = complete && certifier.complete[level];
        lost += certifier.lost[level];
        const double share = (std::min)(1.0, lost / whole.measure());
        result[level] = {complete, complete ? 0.0 : share};
    }
    return result;
}

}  // namespace lod
