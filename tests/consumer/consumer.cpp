// Two discs meet head-on (m 1, v 2 against m 3, v -1): -2.5 and +0.5 after, by the laws of mechanics.
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/frame.hpp"

lod::Body<2> disc(double mass, double x, double velocity) {
    lod::Body<2> body;
    lod::set_mass(body, mass, lod::Inertia<2>::Constant(mass / 2));
    body.position = {x, 0};
    body.velocity = {velocity, 0};
    body.tree = std::make_shared<lod::SphereTree<2>>(lod::single_sphere(lod::Sphere<2>{{0, 0}, 1}));
    return body;
}

int main() {
    std::vector<lod::Body<2>> bodies = {disc(1, 0, 2), disc(3, 1.9, -1)};
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    lod::advance<2>(bodies, {}, budget, storage);

    std::printf("%g and %g m/s\n", bodies[0].velocity.x(), bodies[1].velocity.x());
    const double error =
        std::abs(bodies[0].velocity.x() + 2.5) + std::abs(bodies[1].velocity.x() - 0.5);
    return error < 1e-12 ? 0 : 1;
}
