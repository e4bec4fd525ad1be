// A run under a deadline depends on the machine's speed; played again from where its frames were
// cut, it gives the same bits on any machine.
#include <cstdio>
#include <optional>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/core/frame/state_hash.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>

// Stands for a slow machine: five microseconds pass between two looks. A game takes
// lod::SteadyClock.
class SlowMachine final : public lod::Clock {
  public:
    std::chrono::nanoseconds now() const override { return time_ += std::chrono::microseconds(5); }

  private:
    mutable std::chrono::nanoseconds time_{0};
};

std::vector<lod::Body<2>> gears() {
    const lod2d::Shape gear = lod2d::generate("gear:9");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(gear));
    std::vector<lod::Body<2>> bodies(2);
    for (lod::Body<2>& body : bodies) {
        lod::set_mass(body, gear.area, lod::Inertia<2>::Constant(gear.second_moment));
        body.tree = tree;
    }
    bodies[1].position = {0.88, 0.02};  // teeth between teeth
    bodies[1].spin[0] = 0.3;
    return bodies;
}

int main() {
    std::vector<std::optional<lod::Cut>> cuts;  // all that a replay needs to know of each frame
    std::vector<lod::Body<2>> live = gears();
    std::vector<lod::Body<2>> again = live;
    lod::FrameStorage<2> storage;
    const SlowMachine clock;
    int interrupted = 0;
    for (int frame = 0; frame < 120; ++frame) {
        lod::Budget budget = lod::Budget::deadline(clock, std::chrono::microseconds(10));
        cuts.push_back(lod::advance<2>(live, {}, budget, storage).cut);
        interrupted += cuts.back().has_value();
    }
    for (const std::optional<lod::Cut>& cut : cuts) {
        lod::Budget budget = cut ? lod::Budget::until(*cut) : lod::Budget::unlimited();
        lod::advance<2>(again, {}, budget, storage);
    }
    const bool same = lod::state_hash<2>(live) == lod::state_hash<2>(again);
    std::printf("%d of %zu frames were interrupted; the replay has %s bits\n", interrupted,
                cuts.size(), same ? "the same" : "OTHER");
    return same && interrupted > 0 ? 0 : 1;
}
