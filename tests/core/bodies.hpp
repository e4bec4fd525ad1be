#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "tests/random.hpp"

// Bodies, trees and random states that the tests of core share. What is planar stands in the plane
// z = 0 of space, so one source states a planar case for both dimensions.

namespace lodtest {

using Planar = lod::Vector<2>;

/// Seen along the third axis.
inline Planar in_plane(const lod::Vector<3>& v) {
    return {v.x(), v.y()};
}

template <int Dim>
lod::Vector<Dim> planar(double x, double y) {
    lod::Vector<Dim> v = lod::Vector<Dim>::Zero();
    v[0] = x;
    v[1] = y;
    return v;
}

/// Spin about the axis that leaves the plane.
template <int Dim>
lod::Spin<Dim> planar_spin(double w) {
    lod::Spin<Dim> spin = lod::Spin<Dim>::Zero();
    spin[spin.size() - 1] = w;
    return spin;
}

template <int Dim>
double planar_spin(const lod::Body<Dim>& body) {
    return body.spin[body.spin.size() - 1];
}

/// A body whose inertia about z is `inertia`; the other two moments play no part in planar motion.
template <int Dim>
lod::Body<Dim> planar_body(double mass, double inertia, Planar x = {0, 0}, Planar v = {0, 0},
                           double w = 0) {
    lod::Body<Dim> body;
    lod::Inertia<Dim> about = 0.6 * inertia * lod::Inertia<Dim>::Identity();
    about(about.rows() - 1, about.rows() - 1) = inertia;
    lod::set_mass(body, mass, about);
    body.position = planar<Dim>(x.x(), x.y());
    body.velocity = planar<Dim>(v.x(), v.y());
    body.spin = planar_spin<Dim>(w);
    return body;
}

/// A uniform disc with the tree of one circle. Its inertia is that of a disc in both dimensions.
template <int Dim>
lod::Body<Dim> disc(double mass, double radius, Planar x, Planar v = {0, 0}) {
    auto body = planar_body<Dim>(mass, mass * radius * radius / 2, x, v);
    body.tree = std::make_shared<lod::SphereTree<Dim>>(
        lod::single_sphere<Dim>({lod::Vector<Dim>::Zero(), radius}));
    return body;
}

template <int Dim>
lod::Body<Dim> immovable() {
    lod::Body<Dim> body;
    lod::make_static(body);
    return body;
}

/// A contact at a point of the plane.
template <int Dim>
lod::Contact<Dim> planar_contact(Planar point, Planar normal) {
    return {planar<Dim>(point.x(), point.y()), planar<Dim>(normal.x(), normal.y()), 0};
}

template <int Dim>
lod::Vector<Dim> random_vector(Random& random, double size) {
    lod::Vector<Dim> v;
    for (int d = 0; d < Dim; ++d) v[d] = random.in(-size, size);
    return v;
}

template <int Dim>
lod::Vector<Dim> random_unit(Random& random) {
    for (;;) {
        const lod::Vector<Dim> v = random_vector<Dim>(random, 1);
        if (const double length = v.norm(); length > 0.1 && length <= 1) return v / length;
    }
}

template <int Dim>
lod::Spin<Dim> random_spin(Random& random, double size) {
    lod::Spin<Dim> w;
    for (int d = 0; d < w.size(); ++d) w[d] = random.in(-size, size);
    return w;
}

/// A turned body of random mass (0.2 to 5) and inertia (moments within a factor of 5).
template <int Dim>
lod::Body<Dim> random_body(Random& random) {
    lod::Body<Dim> body;
    lod::Inertia<Dim> inertia = lod::Inertia<Dim>::Zero();
    const double mass = random.in(0.2, 5);
    for (int d = 0; d < inertia.rows(); ++d) inertia(d, d) = mass * random.in(0.2, 1);
    lod::set_mass(body, mass, inertia);
    body.position = random_vector<Dim>(random, 2);
    body.orientation =
        lod::Space<Dim>::turned(lod::Space<Dim>::unturned(), random_spin<Dim>(random, 3));
    body.velocity = random_vector<Dim>(random, 2);
    body.spin = random_spin<Dim>(random, 2);
    return body;
}

/// A tree whose balls nest: every ball holds its children. Up to `branching` children a node;
/// some nodes above the deepest level are leaves.
template <int Dim>
std::vector<lod::TreeNode<Dim>> random_nodes(Random& random, int depth, int branching,
                                             double radius = 1) {
    std::vector<lod::TreeNode<Dim>> nodes(1);
    nodes[0].sphere = {lod::Vector<Dim>::Zero(), radius};
    std::size_t begin = 0;
    for (int level = 0; level < depth; ++level) {
        const std::size_t end = nodes.size();
        for (std::size_t parent = begin; parent < end; ++parent) {
            const bool leaf = level > 0 && random.below(5) == 0;
            const int children = leaf ? 0 : 1 + random.below(branching);
            const lod::Sphere<Dim> outer = nodes[parent].sphere;
            for (int c = 0; c < children; ++c) {
                const double r = outer.radius * random.in(0.3, 0.7);
                const double shift = 0.999 * (outer.radius - r) * random.in(0, 1);
                nodes[parent].children.push_back(static_cast<int>(nodes.size()));
                nodes.push_back({{outer.centre + shift * random_unit<Dim>(random), r},
                                 random.in(0, 1) * random_unit<Dim>(random),
                                 {}});
            }
        }
        begin = end;
    }
    return nodes;
}

template <int Dim>
std::shared_ptr<const lod::SphereTree<Dim>> random_tree(Random& random, int depth, int branching,
                                                        double radius = 1) {
    const auto nodes = random_nodes<Dim>(random, depth, branching, radius);
    return std::make_shared<lod::SphereTree<Dim>>(lod::lay_out<Dim>(std::span(nodes)));
}

/// The classical quadtree of a rectangle: `deep` levels of 4 children below the root, each ball
/// around a quarter of its parent's rectangle. In space the balls' centres lie in the plane z = 0.
template <int Dim>
std::shared_ptr<const lod::SphereTree<Dim>> box_tree(double width, double height, int deep) {
    std::vector<lod::TreeNode<Dim>> nodes;
    const auto add = [&](auto&& self, Planar middle, double w, double h, int levels) -> int {
        const int number = static_cast<int>(nodes.size());
        nodes.push_back({{planar<Dim>(middle.x(), middle.y()), 0.5 * std::hypot(w, h)},
                         lod::Vector<Dim>::Zero(),
                         {}});
        if (levels == 0) return number;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const Planar step{(quarter % 2 ? 0.25 : -0.25) * w, (quarter / 2 ? 0.25 : -0.25) * h};
            const int child = self(self, middle + step, w / 2, h / 2, levels - 1);
            nodes[static_cast<std::size_t>(number)].children.push_back(child);
        }
        return number;
    };
    add(add, {0, 0}, width, height, deep);
    return std::make_shared<lod::SphereTree<Dim>>(lod::lay_out<Dim>(std::span(nodes)));
}

/// The trees of bodies where they stand.
template <int Dim>
std::vector<lod::PosedTree<Dim>> posed(const std::vector<lod::Body<Dim>>& bodies) {
    std::vector<lod::PosedTree<Dim>> world_S(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
    return world_S;
}

/// Resolves contacts and returns the impulse of each.
template <int Dim>
std::vector<double> resolve(lod::Response response, const std::vector<lod::Impact<Dim>>& impacts,
                            std::vector<lod::Body<Dim>>& bodies) {
    lod::Resolver<Dim> resolver;
    std::vector<double> impulses;
    resolver.resolve(response, impacts, bodies, impulses);
    return impulses;
}

template <int Dim>
double energy(const std::vector<lod::Body<Dim>>& bodies) {
    return lod::kinetic_energy(std::span<const lod::Body<Dim>>(bodies));
}

}  // namespace lodtest
