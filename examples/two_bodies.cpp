// Two bodies meet: one loop, one call a frame. What they do is in the record.
#include <cstdio>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

lod::Body<2> body_of(const char* name, lod::Vector<2> position, lod::Vector<2> velocity) {
    const lod2d::Shape shape = lod2d::generate(name);
    lod::Body<2> body;
    lod::set_mass(body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));  // 1 kg/m^2
    body.position = position;
    body.velocity = velocity;
    body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape));
    return body;
}

int main() {
    std::vector<lod::Body<2>> bodies = {body_of("star:5", {-1, 0}, {1, 0}),
                                        body_of("L", {1, 0.3}, {-1, 0})};
    const lod::FrameSettings settings{.time_step = 1.0 / 240};
    lod::FrameStorage<2> storage;

    for (int frame = 0; frame < 480; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(bodies, settings, budget, storage);
        for (std::size_t i = 0; i < record.impacts.size(); ++i)
            if (record.impulses[i] > 0)
                std::printf(
                    "t = %.3f s: impulse %.4f N s at (%.3f, %.3f); energy %.6f J -> %.6f J\n",
                    frame * settings.time_step, record.impulses[i],
                    record.impacts[i].contact.point.x(), record.impacts[i].contact.point.y(),
                    record.energy_before, record.energy_after);
    }
    for (const lod::Body<2>& body : bodies)
        std::printf("velocity (%.4f, %.4f) m/s, spin %.4f rad/s\n", body.velocity.x(),
                    body.velocity.y(), body.spin[0]);
}
