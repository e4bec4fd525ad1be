// The same instant under ever smaller budgets: detection stops at a coarser level, but always
// answers.
#include <cstdio>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

int main() {
    const lod2d::Shape gear = lod2d::generate("gear:9");
    const auto tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(gear, {.depth = 5}));

    std::vector<lod::Body<2>> bodies(2);
    for (lod::Body<2>& body : bodies) {
        lod::set_mass(body, gear.area, lod::Inertia<2>::Constant(gear.second_moment));
        body.tree = tree;
    }
    bodies[1].position = {0.85, 0.1};
    bodies[1].velocity = {-1, 0};

    for (const std::uint64_t quota : {0, 20, 50, 100, 200, 400, 1000000}) {
        lod::Budget budget = lod::Budget::node_tests(quota);
        lod::FrameStorage<2> storage;
        const auto& record = lod::detect<2>(bodies, {}, budget, storage);
        const lod::PairRecord& pair = record.pairs.front();
        std::printf("%7llu node tests allowed, %4llu done: level %d, %2d contacts, %s%s\n",
                    static_cast<unsigned long long>(quota),
                    static_cast<unsigned long long>(record.tests), pair.level, pair.contact_count,
                    pair.verdict == lod::Verdict::apart      ? "apart"
                    : pair.verdict == lod::Verdict::possible ? "possibly touching"
                                                             : "touching",
                    record.interrupted() ? " (interrupted)" : "");
    }
}
