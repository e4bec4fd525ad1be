// Two boxes meet face to face, so at two points at once: six ways to answer, and what each keeps.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

int main() {
    const lod2d::Shape box = lod2d::generate("box:1,1");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(box));
    std::vector<lod::Body<2>> start(2);
    for (lod::Body<2>& body : start) {
        lod::set_mass(body, box.area, lod::Inertia<2>::Constant(box.second_moment));
        body.tree = tree;
    }
    start[0].position = {-0.4999, 0};
    start[0].velocity = {1, 0};
    start[1].position = {0.4999, 0};
    start[1].velocity = {-1, 0};

    double energy_by_net = 0;
    for (const lod::Response response : lod::choices<lod::Response>()) {
        std::vector<lod::Body<2>> bodies = start;
        lod::FrameStorage<2> storage;
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(bodies, {.response = response}, budget, storage);
        std::printf("%-11s %zu contacts, velocities %+.3f and %+.3f m/s, energy %.3f J -> %.3f J\n",
                    std::string(lod::name_of(response)).c_str(), record.impacts.size(),
                    bodies[0].velocity.x(), bodies[1].velocity.x(), record.energy_before,
                    record.energy_after);
        if (response == lod::Response::net) energy_by_net = record.energy_after;
    }
    return std::abs(energy_by_net - 1) < 1e-12 ? 0 : 1;
}
