// How near each level of detail comes to Box2D after one impact of two concave shapes, and what it
// costs in node tests. Error: of both bodies' velocities, over the change that Box2D makes.
//
// bench_box2d_levels [BUILDER [DEPTH]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "bench/timing.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/measure/reference/box2d_reference.hpp"

namespace {

using Bodies = std::vector<lod::Body<2>>;

struct Pair {
    lod2d::Shape a;
    lod2d::Shape b;
    Bodies start;
    lod2d::Box2dImpact reference;
};

lod::Body<2> body_of(const lod2d::Shape& shape, double mass, const lod2d::TreeSettings& settings) {
    lod::Body<2> body;
    lod::set_mass<2>(body, mass,
                     lod::Inertia<2>::Constant(mass * shape.second_moment / shape.area));
    body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
    return body;
}

Pair make_pair(const char* a, const char* b, const lod2d::TreeSettings& settings, double angle) {
    Pair pair{lod2d::generate(a), lod2d::generate(b), {}, {}};
    pair.start = {body_of(pair.a, 1, settings), body_of(pair.b, 2, settings)};
    pair.start[0].position = {-1, 0};
    pair.start[0].velocity = {1.5, 0.2};
    pair.start[0].orientation = angle;
    pair.start[0].spin[0] = 0.8;
    pair.start[1].position = {0.6, 0.15};
    pair.start[1].velocity = {-1, 0};
    pair.start[1].spin[0] = -1.1;
    const lod2d::Shape* const shapes[] = {&pair.a, &pair.b};
    pair.reference = lod2d::run_to_impact(pair.start, shapes);
    return pair;
}

struct Outcome {
    Bodies bodies;
    std::uint64_t tests = 0;  ///< of the frame of the impact
    std::size_t contacts = 0;
    double time = 0;
};

/// Runs to the first impulse with detection stopped at a level.
Outcome run(const Pair& pair, int level) {
    lod::FrameSettings settings;
    settings.deepest_level = level;
    settings.time_step = 1.0 / 960;
    Outcome outcome{pair.start, 0, 0, 0};
    lod::FrameStorage<2> storage;
    for (int frame = 0; frame < 4000; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(outcome.bodies, settings, budget, storage);
        outcome.tests = record.tests;
        outcome.contacts = record.impacts.size();
        outcome.time = frame * settings.time_step;
        for (const double j : record.impulses)
            if (j > 0) return outcome;
    }
    return outcome;
}

double linear_error(const Outcome& outcome, const lod2d::Box2dImpact& reference) {
    double error = 0;
    double change = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        error += (outcome.bodies[i].velocity - reference.after[i].velocity).squaredNorm();
        change += (reference.after[i].velocity - reference.before[i].velocity).squaredNorm();
    }
    return std::sqrt(error / change);
}

}  // namespace

int main(int argc, char** argv) {
    lod2d::TreeSettings settings;
    if (argc > 1)
        settings.builder = lod::chosen<lod2d::Builder>(argv[1], "builder of circle trees");
    settings.depth = argc > 2 ? std::atoi(argv[2]) : 4;
    std::printf("builder %s, contact normals of the nodes; error of the velocities\n",
                std::string(lod::name_of(settings.builder)).c_str());
    std::vector<Pair> pairs;
    for (const auto& [a, b] : {std::pair{"gear:9", "star:5"},
                               {"L", "star:7"},
                               {"star:5", "cross"},
                               {"arrow", "blob:3"},
                               {"U", "gear:7"},
                               {"crescent", "T"}})
        for (const double angle : {0.3, 1.2, 2.1})
            pairs.push_back(make_pair(a, b, settings, angle));
    for (int level = 0; level <= settings.depth; ++level) {
        std::vector<double> errors;
        std::vector<double> early;
        std::vector<double> tests;
        for (const Pair& pair : pairs) {
            if (!pair.reference.happened) continue;
            const Outcome outcome = run(pair, level);
            errors.push_back(linear_error(outcome, pair.reference));
            early.push_back(1e3 * (pair.reference.time - outcome.time));
            tests.push_back(static_cast<double>(outcome.tests));
        }
        const auto first = errors.front();
        std::printf(
            "level %d: median error %.3f (gear on star %.3f), %.1f ms before Box2D, "
            "%.0f tests\n",
            level, bench::median(errors), first, bench::median(early), bench::median(tests));
    }
}
