// The same core in space: only the number changes. A spinning dumb-bell is struck off centre.
#include <cstdio>
#include <vector>

#include <lodlab/core/frame/frame.hpp>

using Vector = lod::Vector<3>;

int main() {
    // Two balls of radius 0.3 m on a line, and the ball that holds both.
    const std::vector<lod::TreeNode<3>> nodes = {
        {{Vector(0, 0, 0), 1.0}, Vector::Zero(), {1, 2}},
        {{Vector(-0.7, 0, 0), 0.3}, Vector::Zero(), {}},
        {{Vector(0.7, 0, 0), 0.3}, Vector::Zero(), {}},
    };
    std::vector<lod::Body<3>> bodies(2);
    lod::set_mass<3>(bodies[0], 1.0, Vector(0.04, 0.5, 0.5).asDiagonal());
    bodies[0].spin = Vector(3, 0, 0.1);
    bodies[0].tree = std::make_shared<lod::SphereTree<3>>(lod::lay_out<3>(nodes));
    lod::set_mass<3>(bodies[1], 1.0, 0.016 * lod::Inertia<3>::Identity());
    bodies[1].position = Vector(0.7, 1.5, 0.1);
    bodies[1].velocity = Vector(0, -2, 0);
    bodies[1].tree =
        std::make_shared<lod::SphereTree<3>>(lod::single_sphere<3>({Vector::Zero(), 0.2}));

    const auto print = [&](const char* when) {
        const Vector turning = lod::angular_momentum<3>(bodies);
        std::printf("%s: energy %.12f J, angular momentum (%.9f, %.9f, %.9f) kg m^2/s\n", when,
                    lod::kinetic_energy<3>(bodies), turning.x(), turning.y(), turning.z());
    };
    print("before");
    lod::FrameStorage<3> storage;
    for (int frame = 0; frame < 240; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        lod::advance<3>(bodies, {}, budget, storage);
    }
    print("after ");
    std::printf("the dumb-bell spins at %.4f rad/s\n", bodies[0].spin.norm());
    return bodies[0].velocity.y() < -0.1 ? 0 : 1;
}
