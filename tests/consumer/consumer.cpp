// Two discs meet head-on (m 1, v 2 against m 3, v -1): -2.5 and +0.5 after, by the laws of
// mechanics.
#include <cmath>
#include <cstdio>
#include <vector>

#include <lodlab/core.hpp>
#include <lodlab/lod2d.hpp>
#include <lodlab/scenes.hpp>
#include <lodlab/viz.hpp>

lod::Body<2> disc(double mass, double x, double velocity) {
    const lod2d::Shape shape = scenes::Shapes<2>::named("disc", {});
    lod::Body<2> body;
    lod::set_mass(body, mass, lod::Inertia<2>::Constant(mass * shape.second_moment / shape.area));
    body.position = {x, 0};
    body.velocity = {velocity, 0};
    body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape, {.depth = 0}));
    return body;
}

int main() {
    std::vector<lod::Body<2>> bodies = {disc(1, 0, 2), disc(3, 0.99, -1)};
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    lod::advance<2>(bodies, {}, budget, storage);

    viz::Figure figure;
    figure.title = "Two discs part";
    figure.panels.push_back(
        {.title = "",
         .view = {{-3, -1}, {3, 1}},
         .marks = {viz::Disc{{viz::Role::body, 0}, {bodies[0].position.x(), 0}, 0.5},
                   viz::Disc{{viz::Role::body, 1}, {bodies[1].position.x(), 0}, 0.5}}});
    viz::write_svg("discs.svg", figure);

    std::printf("%g and %g m/s\n", bodies[0].velocity.x(), bodies[1].velocity.x());
    const double error =
        std::abs(bodies[0].velocity.x() + 2.5) + std::abs(bodies[1].velocity.x() - 0.5);
    return error < 1e-12 ? 0 : 1;
}
