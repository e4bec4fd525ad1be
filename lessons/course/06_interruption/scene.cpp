#include "lessons/course/06_interruption/lesson.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons::interruption {
namespace {

using Vec = lod::Vector<2>;

struct Outlined {
    const char* name;
    double size;
};

/// B comes towards A along a way, and stops where their outlines are so far apart; 0: they touch.
Pair pair_of(const Outlined& a, const Outlined& b, const Vec& place, const Vec& way, double gap) {
    constexpr double step = 0.01;  // [m]
    const lod2d::Shape shape_a = scaled(lod2d::generate(a.name), a.size);
    const lod2d::Shape shape_b = scaled(lod2d::generate(b.name), b.size);
    Pair pair{actor(a.name, shape_a, tree_of(shape_a, depth)),
              actor(b.name, shape_b, tree_of(shape_b, depth)),
              {},
              false};
    pair.a.visual.name = pair.a.visual.name.substr(0, pair.a.visual.name.find(':'));
    pair.b.visual.name = pair.b.visual.name.substr(0, pair.b.visual.name.find(':'));
    pair.a.body.position = place;
    pair.b.body.orientation = gap == 0 ? 0.4 : 0.5;
    double now = 1;
    for (double distance = 2.2; now > gap; distance -= step) {
        pair.b.body.position = place + distance * way;
        now = lod2d::distance(outline_of(shape_a, pair.a.body), outline_of(shape_b, pair.b.body));
    }
    pair.touch = now == 0;
    pair.levels = lod::traverse_levels<2>(pair.a.body, pair.b.body);
    return pair;
}

}  // namespace

Scene::Scene()
    : pairs{pair_of({"comb:4", 1.6}, {"L", 1.4}, Vec(0, 0), Vec(0.2, -0.98), 0),
            pair_of({"gear:7", 1.8}, {"star:5", 1.4}, Vec(2.6, -0.8), Vec(0.96, 0.28), 0.04)},
      costs{pairs[0].costs(), pairs[1].costs()} {}

// listing: detect
std::vector<lod::PairRecord> detect(const Scene& scene, lod::Priority order, lod::Budget budget) {
    lod::FrameSettings settings;
    settings.priority = order;
    settings.contact_model = lod::ContactModel::centre_line;  // by circles alone
    lod::FrameStorage<2> storage;
    return lod::detect<2>(scene.bodies(), settings, budget, storage).pairs;
}

std::vector<lod::PairRecord> detect_until(const Scene& scene, std::uint64_t tests) {
    const Turn last = turns_of(scene.costs, lod::Priority::level_order, Stop::clock, tests).back();
    if (last.end == End::done)
        return detect(scene, lod::Priority::level_order, lod::Budget::unlimited());
    return detect(
        scene, lod::Priority::level_order,
        lod::Budget::until({.pair = last.pair, .level = last.level, .tests = last.tests}));
}
// end of listing

}  // namespace lessons::interruption
