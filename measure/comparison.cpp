#include "lodlab/measure/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/measure/plane_bodies.hpp"

namespace measure {
namespace {

using Bodies = std::span<const lod::Body<2>>;
using Shapes = std::span<const lod2d::Shape* const>;

constexpr double most_units_per_metre = 4096;
constexpr double least_step = 1e-5;  ///< [s]
constexpr double first_push = 0;     ///< no pause: pushes are compared, not what follows them

/// Reports shares of a whole, part after part.
class Parts {
  public:
    Parts(const std::function<void(double)>& progress, double parts)
        : progress_(progress), parts_(parts) {}
    [[nodiscard]] std::function<void(double)> next() {
        const double begin = done_++;
        return [this, begin](double share) {
            if (progress_) progress_((begin + share) / parts_);
        };
    }

  private:
    const std::function<void(double)>& progress_;
    double parts_;
    double done_ = 0;
};

/// Box2D's run, at the first scale that can hold its shapes and the first step that can hold its
/// speeds.
lod2d::Box2dRun run_reference(Bodies bodies, Shapes shapes, const ComparisonOptions& options,
                              lod2d::Box2dSettings& settings) {
    for (;;) {
        try {
            return lod2d::run_box2d(bodies, shapes, options.frames, options.settings.time_step,
                                    settings);
        } catch (const lod::Error& error) {
            const bool too_fine = error.kind() == lod::ErrorKind::input_refused &&
                                  2 * settings.units_per_metre <= most_units_per_metre;
            const bool too_fast = error.kind() == lod::ErrorKind::limit_exceeded &&
                                  settings.time_step / 2 >= least_step;
            if (too_fine)
                settings.units_per_metre *= 2;
            else if (too_fast)
                settings.time_step /= 2;
            else
                throw;
        }
    }
}

int deepest_level(Bodies bodies) {
    int deepest = 0;
    for (const lod::Body<2>& body : bodies) deepest = std::max(deepest, body.tree->levels() - 1);
    return deepest;
}

/// Nothing beyond the leaves, at most to a level.
lod::FrameSettings down_to(lod::FrameSettings settings, int level) {
    settings.deepest_level = level;
    settings.finest = {};
    settings.sweep.deepest_level = level;
    settings.sweep.exact = false;
    return settings;
}

/// All pairs down to their true shapes.
lod::FrameSettings exactly(lod::FrameSettings settings, int level) {
    settings = down_to(settings, level);
    settings.finest.level = lod::Finest::backtrack;
    settings.finest.most_pairs = std::numeric_limits<int>::max();
    settings.sweep.on = true;
    settings.sweep.exact = true;
    return settings;
}

/// What all runs of a comparison share.
struct Compared {
    Bodies bodies;
    const ComparisonOptions& options;
    const PlaneBodies& planar;
    const std::vector<Collision<2>>& reference;
};

ComparedRun run_level(const Compared& scene, const lod::FrameSettings& settings,
                      const std::function<void(double)>& progress) {
    const auto& [bodies, options, planar, reference] = scene;
    scenes::RunOptions run;
    run.settings = settings;
    run.frames = options.frames;
    run.executor = options.executor;
    run.progress = progress;
    ComparedRun compared;
    compared.level = settings.deepest_level;
    compared.run = scenes::run(std::vector<lod::Body<2>>(bodies.begin(), bodies.end()), run);
    compared.collisions = collisions_of<2>(compared.run, bodies, planar);
    compared.perceived =
        perceived_error<2>(reference, compared.collisions, planar, options.perceived);
    return compared;
}

/// The pairs that are compared impact by impact, with Box2D's answer where it has one.
std::vector<FirstImpact> pairs_that_meet_first(const Comparison& comparison,
                                               const PlaneBodies& planar) {
    std::vector<FirstImpact> found;
    std::set<int> met;
    const auto reference = collisions_of(comparison.box2d, planar, first_push);
    const std::vector<bool> first = first_collisions<2>(reference);
    for (std::size_t i = 0; i < reference.size(); ++i) {
        met.insert({reference[i].a, reference[i].b});
        if (first[i]) found.push_back({reference[i].a, reference[i].b, reference[i], {}, {}});
    }
    std::set<std::pair<int, int>> phantoms;
    for (const ComparedRun& level : comparison.levels) {
        const std::vector<bool> here = first_collisions<2>(level.collisions);
        for (std::size_t i = 0; i < level.collisions.size(); ++i) {
            const Collision<2>& collision = level.collisions[i];
            if (here[i] && !met.contains(collision.a) && !met.contains(collision.b) &&
                phantoms.insert({collision.a, collision.b}).second)
                found.push_back({collision.a, collision.b, {}, {}, {}});
        }
    }
    return found;
}

void answer(FirstImpact& impact, Bodies bodies, Shapes shapes, const ComparisonOptions& options,
            std::size_t levels) {
    const lod::Body<2>& a = bodies[lod::at(impact.a)];
    const lod::Body<2>& b = bodies[lod::at(impact.b)];
    const double end = static_cast<double>(options.frames) * options.settings.time_step;
    const auto renamed = [&](std::optional<Collision<2>> collision) {
        if (collision) {
            collision->a = impact.a;
            collision->b = impact.b;
        }
        return collision;
    };
    impact.exact = renamed(exact_collision(a, b, options.settings.response, end));
    const lod2d::Shape* const two[] = {shapes[lod::at(impact.a)], shapes[lod::at(impact.b)]};
    const PlaneBodies planar(two);
    // A level that has not pushed by then lets them pass.
    double horizon = end;
    if (impact.exact) horizon = std::min(end, impact.exact->time + options.perceived.window);
    for (std::size_t level = 0; level < levels; ++level) {
        const lod::FrameSettings settings = down_to(options.settings, static_cast<int>(level));
        impact.levels.push_back(
            renamed(framed_collision<2>(a, b, settings, planar, {horizon, first_push})));
    }
}

}  // namespace

Comparison compare(Bodies bodies, Shapes shapes, const ComparisonOptions& options) {
    const int deepest = deepest_level(bodies);
    Parts parts(options.progress, deepest + 3);
    const PlaneBodies planar(shapes);
    Comparison comparison;
    comparison.box2d_settings = options.box2d;
    comparison.box2d_settings.progress = parts.next();
    comparison.box2d = run_reference(bodies, shapes, options, comparison.box2d_settings);
    comparison.box2d_settings.progress = {};
    comparison.box2d_collisions = collisions_of(comparison.box2d, planar);
    const Compared scene{bodies, options, planar, comparison.box2d_collisions};
    for (int level = 0; level <= deepest; ++level)
        comparison.levels.push_back(
            run_level(scene, down_to(options.settings, level), parts.next()));
    comparison.exact = run_level(scene, exactly(options.settings, deepest), parts.next());
    comparison.first_impacts = pairs_that_meet_first(comparison, planar);
    for (FirstImpact& impact : comparison.first_impacts)
        answer(impact, bodies, shapes, options, comparison.levels.size());
    return comparison;
}

}  // namespace measure
