#include <algorithm>
#include <limits>

#include "lessons/course/02_circle_tree/lesson.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lessons::tree {
namespace {

using lod::Sphere;
using Vec = lod::Vector<2>;

// listing: spoiled
Tree spoiled(const Tree& sound, int leaf) {
    Tree tree = sound;
    tree.radius[Tree::index(leaf)] *= 0.6;
    lod::renew(tree);
    return tree;
}
// end of listing

/// A disc of the shape that meets no leaf of a tree.
struct Hole {
    int leaf = 0;  ///< the one that was spoiled
    Vec centre{0, 0};
    double radius = 0;  ///< 0 where there is none
};

/// How far a point lies outside all leaves.
double outside_leaves(const Tree& tree, const Vec& p, double enough) {
    double free = std::numeric_limits<double>::infinity();
    for (int node = 0; node < tree.size(); ++node) {
        if (!tree.is_leaf(node)) continue;
        const Sphere<2> disc = tree.sphere(node);
        free = std::min(free, (p - disc.centre).norm() - disc.radius);
        if (free <= enough) return free;
    }
    return free;
}

/// The largest hole that spoiling the leaf makes, by points on a grid over the sound leaf.
Hole hole_of(const Crescent& crescent, const lod2d::BoundaryIndex& boundary, int leaf) {
    constexpr int grid = 12;
    const Tree tree = spoiled(*crescent.tree, leaf);
    const Sphere<2> was = crescent.tree->sphere(leaf);
    Hole hole{leaf, {0, 0}, 0};
    for (int i = -grid; i <= grid; ++i)
        for (int j = -grid; j <= grid; ++j) {
            const Vec p = was.centre + was.radius / grid * Vec(i, j);
            const double free = outside_leaves(tree, p, hole.radius);
            if (free > hole.radius && boundary.inside(p)) hole = {leaf, p, free};
        }
    return hole;
}

/// The leaf whose spoiling makes the largest hole.
Hole find_hole(const Crescent& crescent) {
    const lod2d::BoundaryIndex boundary(crescent.shape.polygon);
    Hole largest;
    for (int node = 0; node < crescent.tree->size(); ++node) {
        if (!crescent.tree->is_leaf(node)) continue;
        const Hole hole = hole_of(crescent, boundary, node);
        if (hole.radius > largest.radius) largest = hole;
    }
    constexpr double clearance = 0.9;  // so that the visitor does not touch a leaf
    largest.radius *= clearance;
    return largest;
}

/// Says whether the traversal calls a small disc in the hole apart from the crescent.
lod::Verdict verdict_at(const Hole& hole, const Tree& tree) {
    lod::Body<2> crescent;
    crescent.tree = std::make_shared<const Tree>(tree);
    lod::Body<2> visitor;
    visitor.position = hole.centre;
    visitor.tree = std::make_shared<const Tree>(lod::single_sphere<2>({{0, 0}, hole.radius}));
    return lod::traverse_levels<2>(crescent, visitor).back().verdict;
}

viz::Figure draw_hole(const Crescent& crescent, const Hole& hole) {
    const Tree tree = spoiled(*crescent.tree, hole.leaf);
    const Sphere<2> was = crescent.tree->sphere(hole.leaf);
    viz::Panel panel;
    constexpr double round = 2;  // half the view's height, in radii
    const Vec reach = round * was.radius * Vec(1.5, 1);
    panel.view = {at(was.centre - reach), at(was.centre + reach)};
    add_body(panel, crescent.body, 0);
    for (int node = 0; node < tree.size(); ++node)
        if (tree.is_leaf(node) && node != hole.leaf)
            add_ball(panel, tree.sphere(node), style(viz::Role::node, 0));
    viz::Polyline sound{style(viz::Role::reference), {}, 1, {}};
    constexpr int corners = 72;
    for (int i = 0; i <= corners; ++i) {
        const lod::SineCosine turn = lod::sine_cosine(2 * 3.14159265358979 * i / corners);
        sound.points.push_back(at(was.centre + was.radius * Vec(turn.cosine, turn.sine)));
    }
    panel.marks.push_back(sound);
    add_ball(panel, tree.sphere(hole.leaf), style(viz::Role::meeting_node, 0));
    add_ball(panel, {hole.centre, hole.radius}, style(viz::Role::meeting_node, 1));
    add_label(panel, viz::Role::body, tree.sphere(hole.leaf).centre, "the leaf, too small", 0);
    add_label(panel, viz::Role::body, hole.centre, "visitor", 1, hole.radius);
    return figure_of(std::move(panel));
}

void give_hole(Lesson& lesson, const Crescent& crescent, const Hole& hole) {
    const Number bad = words(in_words(verdict_at(hole, spoiled(*crescent.tree, hole.leaf))));
    const Number good = words(in_words(verdict_at(hole, *crescent.tree)));
    give(lesson, "bad verdict", bad);
    give(lesson, "good verdict", good);
    give(lesson, "visitor", number(1000 * hole.radius, 1, "mm"));
    viz::Figure figure = draw_hole(crescent, hole);
    figure.numbers = {{"sound tree says", good.text}, {"spoiled tree says", bad.text}};
    give(lesson, "hole", std::move(figure));
}

/// One node of level 2 with its piece, the second child of the second child; every corner is shown.
viz::Panel draw_corners(const Crescent& crescent, std::size_t& count) {
    const Tree& tree = *crescent.tree;
    const lod2d::PolygonPiece whole(crescent.shape.polygon);
    const int child = tree.first_child[0] + 1;
    const int node = tree.first_child[Tree::index(child)] + 1;
    const lod2d::PolygonPiece piece =
        pieces_of_children(pieces_of_children(whole, tree, 0)[1], tree, child)[1];
    viz::Panel panel;
    panel.view = viz::grown(box_round({tree.sphere(node)}), 0.15);
    add_body(panel, crescent.body, 0);
    add_piece(panel, piece, 1);
    add_ball(panel, tree.sphere(node), style(viz::Role::level_node, 1, 2));
    std::vector<Vec> corners;
    for (const Vec& corner : piece.vertices()) {
        const auto same = [&](const Vec& other) { return (other - corner).norm() < 1e-9; };
        if (std::none_of(corners.begin(), corners.end(), same)) corners.push_back(corner);
    }
    for (const Vec& corner : corners) add_dot(panel, viz::Role::contact, corner);
    count = corners.size();
    return panel;
}

void give_certificate(Lesson& lesson, const Crescent& crescent, int leaf) {
    const Tree& tree = *crescent.tree;
    const lod2d::PolygonPiece whole(crescent.shape.polygon);
    // listing: certificate
    const std::vector<lod::LevelCertificate> sound = lod::certify<2>(tree, whole);
    const std::vector<lod::LevelCertificate> bad = lod::certify<2>(spoiled(tree, leaf), whole);
    // end of listing
    const auto certified = std::count_if(sound.begin(), sound.end(),
                                         [](const auto& level) { return level.certified; });
    std::size_t corners = 0;
    viz::Figure figure = figure_of(draw_corners(crescent, corners));
    give(lesson, "corners", count(corners));
    give(lesson, "certified levels", count(certified));
    give(lesson, "uncovered", number(100 * bad.back().uncovered, 2, "%"));
    give(lesson, "spoiled certificate", words(bad.back().certified ? "certified too" : "refused"));
    figure.numbers = {
        {"corners", lesson.numbers["corners"].text},
        {"levels certified", std::to_string(certified) + " of " + std::to_string(sound.size())}};
    give(lesson, "certificate", std::move(figure));
}

}  // namespace

void give_bad_tree(Lesson& lesson, const Crescent& crescent) {
    const Hole hole = find_hole(crescent);
    give_hole(lesson, crescent, hole);
    give_certificate(lesson, crescent, hole.leaf);
}

}  // namespace lessons::tree
