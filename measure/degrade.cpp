#include "lodlab/measure/degrade.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/measure/first_impact.hpp"
#include "lodlab/measure/free_flight.hpp"

namespace measure {
namespace {

/// How a level's answer came about.
template <int Dim>
struct Push {
    double time = 0;
    std::vector<lod::Body<Dim>> before;
    std::vector<lod::Body<Dim>> after;
    double tests = 0;
    double microseconds = 0;
};

template <int Dim>
Collision<Dim> collision_of(const Push<Dim>& push) {
    return {0,
            1,
            push.time,
            push.time,
            0,
            0,
            {push.before[0], push.before[1]},
            {push.after[0], push.after[1]}};
}

constexpr std::size_t impacts_of_a_batch = 8;  // of each worker

/// The measuring of one share.
template <int Dim>
class Measurement {
  public:
    using Body = lod::Body<Dim>;

    Measurement(const Plan& plan, std::span<const MeasuredShape<Dim>> shapes,
                const lod::Clock* clock)
        : plan_(plan), shapes_(shapes), clock_(clock) {}

    ImpactSample measure(int number) {
        approach_ = draw_approach<Dim>(shapes_, plan_.ensemble, static_cast<std::uint64_t>(number),
                                       plan_.time_step);
        find_entries();
        ImpactSample result{number, {}};
        for (const lod::ContactModel model : plan_.models)
            for (const lod::Response response : plan_.responses) {
                const lod::TimeOfImpact<Dim>& touch = approach_.touch;
                const Push<Dim> reference =
                    answered(approach_.time, touch.a, touch.b, touch.contacts, response);
                for (int level = 0; level <= plan_.depth; ++level)
                    result.outcomes.push_back(
                        judged(pushed(entries_[static_cast<std::size_t>(level)],
                                      settings(level, model, response)),
                               reference, level));
                result.outcomes.push_back(
                    judged(pushed_exactly(entries_.back(), settings(1000, model, response)),
                           reference, -1));
            }
        return result;
    }

  private:
    [[nodiscard]] double end() const { return approach_.time + patience; }

    /// For each level the flight shortly before its first front, or beyond the end. A deeper
    /// level's is never earlier.
    void find_entries() {
        FreeFlight<Dim> flight({0, {approach_.a, approach_.b}}, plan_.time_step);
        entries_.clear();
        for (int level = 0; level <= plan_.depth; ++level) {
            flight.to_front(level, end());
            entries_.push_back(flight.now());
        }
    }

    /// The response to the touch of exact shapes.
    Push<Dim> answered(double time, const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                       const std::vector<lod::Contact<Dim>>& contacts, lod::Response response) {
        Push<Dim> push{time, {a, b}, {a, b}, 0, 0};
        impacts_.clear();
        for (const lod::Contact<Dim>& contact : contacts) impacts_.push_back({0, 1, 0, contact});
        impulses_.assign(impacts_.size(), 0.0);
        storage_.resolver.resolve(response, impacts_, push.after, impulses_);
        return push;
    }

    [[nodiscard]] lod::FrameSettings settings(int level, lod::ContactModel model,
                                              lod::Response response) const {
        lod::FrameSettings settings;
        settings.time_step = plan_.time_step;
        settings.deepest_level = level;
        settings.contact_model = model;
        settings.response = response;
        return settings;
    }

    struct Advanced {
        double tests = 0;
        double microseconds = 0;
        bool pushed = false;
    };

    /// One frame of the simulation.
    Advanced advance(std::vector<Body>& bodies, const lod::FrameSettings& frame) {
        lod::check_interrupted();
        lod::Budget budget = lod::Budget::unlimited();
        const auto begin = clock_ ? clock_->now() : std::chrono::nanoseconds{};
        const auto& record = lod::advance<Dim>(bodies, frame, budget, storage_);
        Advanced advanced;
        if (clock_)
            advanced.microseconds =
                std::chrono::duration<double, std::micro>(clock_->now() - begin).count();
        advanced.tests = static_cast<double>(record.tests);
        advanced.pushed = std::any_of(record.impulses.begin(), record.impulses.end(),
                                      [](double j) { return j > 0; });
        return advanced;
    }

    /// Frames from the level's first front on until one pushes.
    Push<Dim> pushed(const Moment<Dim>& entry, const lod::FrameSettings& frame) {
        std::vector<Body> now = entry.bodies;
        std::int64_t number = entry.frame;
        for (;; ++number) {
            const double time = static_cast<double>(number) * plan_.time_step;
            if (time > end()) return {end(), now, now, 0, 0};
            Push<Dim> push{time, now, now, 0, 0};
            const Advanced advanced = advance(now, frame);
            if (!advanced.pushed) continue;
            push.tests = advanced.tests;
            push.microseconds = advanced.microseconds;
            // The response alone, again: the frame moved the bodies on as well.
            storage_.resolver.resolve(frame.response, storage_.record.impacts, push.after,
                                      impulses_);
            return push;
        }
    }

    /// The same with exact contact and backtracking after the leaves.
    Push<Dim> pushed_exactly(const Moment<Dim>& entry, lod::FrameSettings frame) {
        FreeFlight<Dim> flight(entry, plan_.time_step);
        frame.finest.level = lod::Finest::backtrack;
        frame.finest.tolerance = touching_within;
        while (flight.to_near(end())) {
            std::vector<Body> now = flight.now().bodies;
            const Advanced advanced = advance(now, frame);
            if (!advanced.pushed) {
                flight.step(1);
                continue;
            }
            const lod::FinestPair<Dim>& exact = storage_.true_shapes.found().at(0);
            Push<Dim> push = answered(flight.time() + exact.touch.time, exact.touch.a,
                                      exact.touch.b, exact.touch.contacts, frame.response);
            push.tests = advanced.tests;
            push.microseconds = advanced.microseconds;
            return push;
        }
        return {end(), flight.now().bodies, flight.now().bodies, 0, 0};
    }

    /// `level` -1: the exact one.
    [[nodiscard]] Outcome judged(const Push<Dim>& push, const Push<Dim>& reference,
                                 int level) const {
        Outcome outcome;
        const Collision<Dim> seen = collision_of(push);
        const ImpactError error = impact_error(collision_of(reference), seen);
        outcome.impulse_error = error.impulse;
        outcome.angle_error = error.angle;
        outcome.spin_error = error.spin;
        outcome.delay = push.time - reference.time;
        outcome.tests = push.tests;
        outcome.microseconds = push.microseconds;
        outcome.missed = impulse_of(seen).isZero(0);
        if (outcome.missed) return outcome;
        const Body& a = push.before[0];
        const Body& b = push.before[1];
        if (!lod::exactly_overlap(a, b)) outcome.gap = lod::separation(a, b).distance;
        outcome.gap_bound =
            fastest_approach(a, a.exact->radius(), b, b.exact->radius()) * plan_.time_step;
        if (level >= 0)
            outcome.gap_bound +=
                shapes_[static_cast<std::size_t>(approach_.shape_a)].protrusion_at(level) +
                shapes_[static_cast<std::size_t>(approach_.shape_b)].protrusion_at(level);
        return outcome;
    }

    const Plan& plan_;
    std::span<const MeasuredShape<Dim>> shapes_;
    const lod::Clock* clock_;
    Approach<Dim> approach_;
    std::vector<Moment<Dim>> entries_;
    lod::FrameStorage<Dim> storage_;
    std::vector<lod::Impact<Dim>> impacts_;
    std::vector<double> impulses_;
};

}  // namespace

void check_plan(const Plan& plan, const Share& share) {
    const auto refuse = [](const std::string& line) {
        throw lod::Error(lod::ErrorKind::usage, line);
    };
    if (plan.shapes.empty() || plan.models.empty() || plan.responses.empty())
        refuse("nothing to measure: name at least one shape, contact model and response");
    if (plan.impacts < 1 || plan.impacts > 10'000'000)
        refuse("the number of impacts must lie between 1 and 10000000, not " +
               std::to_string(plan.impacts));
    if (plan.depth < 0 || plan.depth > 12)
        refuse("the depth must lie between 0 and 12, not " + std::to_string(plan.depth));
    if (!(plan.time_step > 0) || !(plan.ensemble.speed > 0))
        refuse("time step and speed must be above 0");
    if (share.count < 1 || share.index < 1 || share.index > share.count)
        refuse("share " + std::to_string(share.index) + "/" + std::to_string(share.count) +
               " does not exist; write 1/" + std::to_string(std::max(1, share.count)) +
               ", the first, and so on");
    if (share.index > plan.impacts)
        refuse("share " + std::to_string(share.index) + "/" + std::to_string(share.count) + " of " +
               std::to_string(plan.impacts) + " impacts holds none; cut them into fewer shares");
}

template <int Dim>
Outcomes degrade(const Plan& plan, std::span<const MeasuredShape<Dim>> shapes,
                 const DegradeOptions& options) {
    check_plan(plan, options.share);
    Outcomes outcomes{plan, {}};
    for (int number = 0; number < plan.impacts; ++number)
        if (options.share.holds(number)) outcomes.impacts.push_back({number, {}});
    const std::size_t workers = lod::workers_of(options.executor);
    std::vector<Measurement<Dim>> measurements;
    for (std::size_t i = 0; i < workers; ++i)
        measurements.emplace_back(plan, shapes, options.clock);
    const std::span<ImpactSample> impacts(outcomes.impacts);
    // A batch at a time, so that this thread tells of progress.
    const std::size_t batch = workers * impacts_of_a_batch;
    for (std::size_t done = 0; done < impacts.size(); done += batch) {
        const auto some = impacts.subspan(done, std::min(batch, impacts.size() - done));
        lod::each_part(options.executor, some.size(), 1, [&](const lod::Part& part) {
            for (ImpactSample& impact : some.subspan(part.begin, part.end - part.begin))
                impact = measurements[part.worker].measure(impact.number);
        });
        if (options.progress)
            options.progress(static_cast<double>(done + some.size()) /
                             static_cast<double>(impacts.size()));
    }
    return outcomes;
}

Outcomes merged(std::vector<Outcomes> shares) {
    const auto refuse = [](const std::string& line) {
        throw lod::Error(lod::ErrorKind::input_refused, line);
    };
    if (shares.empty()) refuse("no shares to merge");
    Outcomes all{shares[0].plan, {}};
    for (Outcomes& share : shares) {
        if (share.plan != all.plan)
            refuse("the shares do not belong together: their settings differ");
        all.impacts.insert(all.impacts.end(), share.impacts.begin(), share.impacts.end());
    }
    std::sort(all.impacts.begin(), all.impacts.end(),
              [](const auto& x, const auto& y) { return x.number < y.number; });
    for (std::size_t i = 0; i < all.impacts.size(); ++i) {
        const int number = all.impacts[i].number;
        if (number < static_cast<int>(i) || number >= all.plan.impacts)
            refuse("impact " + std::to_string(number) + " is there twice; name each share once");
        if (number > static_cast<int>(i))
            refuse("impact " + std::to_string(i) + " is missing; name every share");
    }
    if (!all.complete())
        refuse("impact " + std::to_string(all.impacts.size()) + " is missing; name every share");
    return all;
}

template Outcomes degrade(const Plan&, std::span<const MeasuredShape<2>>, const DegradeOptions&);
template Outcomes degrade(const Plan&, std::span<const MeasuredShape<3>>, const DegradeOptions&);

}  // namespace measure
