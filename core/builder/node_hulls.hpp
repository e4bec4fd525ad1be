#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/builder/fit_hull.hpp"
#include "lodlab/core/builder/hollows.hpp"
#include "lodlab/core/builder/piece.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"
#include "lodlab/core/math/power_diagram.hpp"
#include "lodlab/core/tree/tree.hpp"

namespace lod {

/// Calls visit(node, piece) for every node of a tree and what it owns of the whole shape: for a
/// child, what of its parent's piece lies in its cell of the power diagram of the children's balls.
/// Where visit returns false, no node below is visited.
/// The order of the nodes is depth first.
template <int Dim, PieceOf<Dim> Piece, class Visit>
void visit_pieces(const SphereTree<Dim>& tree, int node, const Piece& owned, const Visit& visit) {
    check_interrupted();
    if (!visit(node, owned) || tree.is_leaf(node)) return;
    std::vector<Sphere<Dim>> balls;
    const int first = tree.first_child[tree.index(node)];
    for (int c = 0; c < tree.child_count[tree.index(node)]; ++c)
        balls.push_back(tree.sphere(first + c));
    for (std::size_t c = 0; c < balls.size(); ++c)
        visit_pieces<Dim>(tree, first + static_cast<int>(c),
                          owned.within(power_cell<Dim>(std::span<const Sphere<Dim>>(balls), c)),
                          visit);
}

/// Marks the faces whose middle lies deeper within the shape than `margin` [m].
template <int Dim, DistanceFrom<Dim> Distance>
void mark_inner_faces(const Distance& shape, double margin, Hull<Dim>& hull) {
    for (const std::vector<std::int32_t>& face : hull.faces) {
        hull.inner.push_back(shape.signed_distance(hull.middle(face)) < -margin);
    }
}

/// Marks the corners at inner faces where the shape's surface goes on beyond the cut: at a step of
/// `reach` [m] along an outer face, out of the inner one, it is still near.
template <int Dim, DistanceFrom<Dim> Distance>
void mark_cut_corners(const Distance& shape, double reach, Hull<Dim>& hull) {
    // Of the surface, as a sine: where it turns more it ends in a true corner. Half or double: 4 to
    // 11 % fewer, 3 to 8 % more corners in space are cut ones, none in the plane; the same errors.
    constexpr double least_turn = 0.3;
    // Faces that turn less have no edge worth the name: 1e-9 and 1e-3 change no corner.
    constexpr double parallel = 1e-6;
    const auto has = [](const std::vector<std::int32_t>& face, std::size_t corner) {
        return std::find(face.begin(), face.end(), static_cast<std::int32_t>(corner)) != face.end();
    };
    std::vector<Vector<Dim>> normals;
    std::vector<Vector<Dim>> facet;
    for (const std::vector<std::int32_t>& face : hull.faces) {
        facet.clear();
        for (const std::int32_t corner : face)
            facet.push_back(hull.corners[static_cast<std::size_t>(corner)]);
        normals.push_back(Space<Dim>::area_vector(facet).normalized());
    }
    hull.cut.assign(hull.corners.size(), false);
    for (std::size_t inner = 0; inner < hull.faces.size(); ++inner)
        for (std::size_t outer = 0; outer < hull.faces.size() && hull.inner[inner]; ++outer) {
            if (hull.inner[outer]) continue;
            const Vector<Dim>& m = normals[outer];
            const Vector<Dim>& q = normals[inner];
            const Vector<Dim> along = q - q.dot(m) * m;
            if (along.norm() < parallel) continue;
            const Vector<Dim> step = reach * along.normalized();
            for (std::size_t corner = 0; corner < hull.corners.size(); ++corner) {
                if (hull.cut[corner] || !has(hull.faces[inner], corner) ||
                    !has(hull.faces[outer], corner))
                    continue;
                const double beyond = shape.signed_distance(hull.corners[corner] + step);
                hull.cut[corner] = beyond < least_turn * reach;
            }
        }
}

/// A step that is small beside what is cut, as a share of the root ball's radius. Half: as half of
/// least_turn, the same errors; double: as double, and .068 instead of .053 at level 2 in space.
inline constexpr double cut_share = 0.01;

/// A hull that stands out of the shape by no more than this share of the root ball's radius is
/// taken for the piece itself. In the plane with half 391 nodes are tight, of smaller pieces, with
/// double 288, instead of 341; the medians of errors are the same to four digits.
inline constexpr double tight_share = 1e-3;

/// How far the hull's faces stand out of the shape, at points spread over them [m].
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] double lid_height(const Distance& shape, const Hull<Dim>& hull) {
    constexpr int steps = 4;  // from the middle to a corner: 335 and 341 of 341 nodes are tight
    double most = 0;
    for (const std::vector<std::int32_t>& face : hull.faces) {
        const Vector<Dim> middle = hull.middle(face);
        most = (std::max)(most, static_cast<double>(shape.distance(middle)));
        for (const std::int32_t corner : face)
            for (int step = 1; step <= steps; ++step) {
                const double share = static_cast<double>(step) / steps;
                const Vector<Dim> p =
                    (1 - share) * middle + share * hull.corners[static_cast<std::size_t>(corner)];
                most = (std::max)(most, static_cast<double>(shape.distance(p)));
            }
    }
    return most;
}

/// The box about a ball.
template <int Dim>
[[nodiscard]] Hull<Dim> hull_of_ball(const Sphere<Dim>& ball, double margin) {
    const Vector<Dim> half = Vector<Dim>::Constant(ball.radius);
    const std::array<Vector<Dim>, 2> ends{ball.centre - half, ball.centre + half};
    return fit_hull<Dim>(ends, ends, {}, margin);
}

/// Gives the nodes their hulls: convex polygons or polytopes of few faces that hold their pieces,
/// with rounding_bound(root) to spare; and the tree its entry level. Below a node whose hull is
/// tight no node has one of its own (NodeHulls::best).
/// Requires a tree that passes `certify` for the shape.
template <int Dim, PieceOf<Dim> Piece, DistanceFrom<Dim> Distance>
void give_hulls(SphereTree<Dim>& tree, const Piece& whole, const Distance& shape) {
    std::vector<Hull<Dim>> hulls(static_cast<std::size_t>(tree.size()));
    const double margin = rounding_bound(tree.sphere(0));
    visit_pieces<Dim>(tree, 0, whole, [&](int node, const Piece& piece) {
        Hull<Dim>& hull = hulls[static_cast<std::size_t>(node)];
        if (piece.vertices().empty()) {  // whatever lies in its ball, then
            hull = hull_of_ball(tree.sphere(node), margin);
            return true;
        }
        const HullHints<Dim> hints = piece.hull_hints();
        hull = fit_hull<Dim>(piece.vertices(), hints.corners, hints.normals, margin);
        mark_inner_faces<Dim>(shape, margin, hull);
        mark_cut_corners<Dim>(shape, cut_share * tree.radius[0], hull);
        const double out = lid_height<Dim>(shape, hull);
        hull.tight = out <= tight_share * tree.radius[0];
        hull.round = protrusion_bound<Dim>(shape, tree.sphere(node)) < out;
        return !hull.tight;
    });
    tree.hulls = {};
    for (const Hull<Dim>& hull : hulls) tree.hulls.add(hull);
    tree.hulls.find_best(tree.parent);
    tree.hulls.entry_level = find_entry_level<Dim>(tree, shape);
}

/// The certificate of hulls, for any tree and the whole shape: for each level whether every node of
/// it has a hull (NodeHulls::best) that holds its piece, the piece's vertices lying within each
/// face by half of rounding_bound(root), and that is a closed surface, so that its corners are
/// those of the intersection of its faces' half-spaces.
template <int Dim, PieceOf<Dim> Piece>
[[nodiscard]] std::vector<char> certify_hulls(const SphereTree<Dim>& tree, const Piece& whole) {
    std::vector<char> certified(static_cast<std::size_t>(tree.levels()), tree.has_hulls());
    if (!tree.has_hulls()) return certified;
    const double margin = rounding_bound(tree.sphere(0)) / 2;
    visit_pieces<Dim>(tree, 0, whole, [&](int node, const Piece& piece) {
        const HullView<Dim> hull = tree.hulls.of(tree.hulls.best(node));
        bool holds = hull.is_closed();
        for (std::size_t face = 0; face < hull.normals.size() && holds; ++face)
            holds =
                piece.vertices().empty() ||
                support<Dim>(piece.vertices(), hull.normals[face]) <= hull.offsets[face] - margin;
        certified[static_cast<std::size_t>(tree.level_of(node))] &= static_cast<char>(holds);
        return true;
    });
    return certified;
}

}  // namespace lod
