// Four gears meet in two pairs, and the budget is enough for one: which pair gets the detail?
#include <cstdio>
#include <string>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

int main() {
    const lod2d::Shape gear = lod2d::generate("gear:9");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(gear));
    std::vector<lod::Body<2>> bodies(4);
    for (std::size_t i = 0; i < 4; ++i) {
        lod::set_mass(bodies[i], gear.area, lod::Inertia<2>::Constant(gear.second_moment));
        bodies[i].tree = tree;
        bodies[i].position = {i % 2 == 0 ? 0 : 0.88, i < 2 ? 0 : 3.0};
    }
    bodies[1].velocity = {-0.1, 0};  // a slow pair, and far above it
    bodies[3].velocity = {-5, 0};    // a fast one

    lod::FrameStorage<2> storage;
    const auto levels_by = [&](const std::string& name, lod::Priority priority) {
        lod::Budget budget = lod::Budget::node_tests(570);
        const auto& record = lod::detect<2>(bodies, {.priority = priority}, budget, storage);
        std::printf("%s:", name.c_str());
        for (const lod::PairRecord& pair : record.pairs)
            std::printf(" gears %d and %d to level %d;", pair.bodies.a, pair.bodies.b, pair.level);
        std::printf(" %llu tests\n", static_cast<unsigned long long>(record.tests));
        return record.pairs.back().level - record.pairs.front().level;
    };
    for (const lod::Priority priority : lod::choices<lod::Priority>())
        levels_by(std::string(lod::name_of(priority)), priority);

    // A policy of one's own says what the next level of a pair is worth: here the upper pair's all.
    storage.scheduler.own_value = [](const lod::LevelOffer<2>& offer) {
        return offer.a.position.y();
    };
    return levels_by("the upper first", lod::Priority::level_order) > 0 ? 0 : 1;
}
