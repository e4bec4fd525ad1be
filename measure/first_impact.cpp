#include "lodlab/measure/first_impact.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace measure {

template <int Dim>
double angle_between(const lod::Vector<Dim>& u, const lod::Vector<Dim>& v) {
    if (u.norm() == 0 || v.norm() == 0) return 0;
    // Keeps its digits near 0 and pi (Kahan).
    const lod::Vector<Dim> a = u.normalized();
    const lod::Vector<Dim> b = v.normalized();
    return 2 * lod::direction_angle((a - b).norm(), (a + b).norm());
}

template <int Dim>
lod::Vector<Dim> impulse_of(const Collision<Dim>& collision) {
    const std::size_t i = collision.before[1].is_static() ? 0 : 1;
    const double sign = i == 1 ? 1 : -1;
    return sign / collision.before[i].inverse_mass *
           (collision.after[i].velocity - collision.before[i].velocity);
}

template <int Dim>
ImpactError impact_error(const Collision<Dim>& reference, const Collision<Dim>& seen) {
    ImpactError error;
    const lod::Vector<Dim> J = impulse_of(reference);
    error.impulse = (impulse_of(seen) - J).norm() / J.norm();
    for (std::size_t i = 0; i < 2; ++i) {
        if (reference.before[i].is_static()) continue;
        const lod::Body<Dim>& right = reference.after[i];
        const lod::Body<Dim>& wrong = seen.after[i];
        error.angle = std::max(error.angle, angle_between<Dim>(wrong.velocity, right.velocity));
        error.spin = std::max(error.spin, (wrong.spin - right.spin).norm());
    }
    return error;
}

template <int Dim>
std::optional<Collision<Dim>> exact_collision(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                                              lod::Response response, double horizon) {
    lod::ImpactSettings settings;
    settings.horizon = horizon;
    const lod::TimeOfImpact<Dim> touch = lod::time_of_impact(a, b, settings);
    if (touch.outcome != lod::ImpactOutcome::touching) return {};
    std::vector<lod::Body<Dim>> bodies{touch.a, touch.b};
    std::vector<lod::Impact<Dim>> impacts;
    for (const lod::Contact<Dim>& contact : touch.contacts) impacts.push_back({0, 1, 0, contact});
    std::vector<double> impulses(impacts.size(), 0.0);
    lod::Resolver<Dim> resolver;
    resolver.resolve(response, impacts, bodies, impulses);
    return Collision<Dim>{0, 1, touch.time,         touch.time,
                          0, 0, {touch.a, touch.b}, {bodies[0], bodies[1]}};
}

template <int Dim>
std::optional<Collision<Dim>> framed_collision(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                                               const lod::FrameSettings& settings,
                                               const BodyShapes<Dim>& shapes, const Watch& watch) {
    std::vector<lod::Body<Dim>> bodies{a, b};
    lod::FrameStorage<Dim> storage;
    CollisionLog<Dim> log(shapes, watch.pause);
    for (int frame = 0; frame * settings.time_step <= watch.horizon; ++frame) {
        lod::check_interrupted();
        const double time = frame * settings.time_step;
        if (!log.collisions().empty() && time - log.collisions()[0].until > watch.pause) break;
        const std::vector<lod::Body<Dim>> before = bodies;
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<Dim>(bodies, settings, budget, storage);
        const bool pushed = std::any_of(record.impulses.begin(), record.impulses.end(),
                                        [](double j) { return j > 0; });
        if (pushed) log.add(time, 0, 1, before, bodies);
    }
    if (log.collisions().empty()) return {};
    return log.collisions()[0];
}

#define MEASURE_INSTANTIATE(Dim)                                                          \
    template double angle_between<Dim>(const lod::Vector<Dim>&, const lod::Vector<Dim>&); \
    template lod::Vector<Dim> impulse_of(const Collision<Dim>&);                          \
    template ImpactError impact_error(const Collision<Dim>&, const Collision<Dim>&);      \
    template std::optional<Collision<Dim>> exact_collision(                               \
        const lod::Body<Dim>&, const lod::Body<Dim>&, lod::Response, double);             \
    template std::optional<Collision<Dim>> framed_collision(                              \
        const lod::Body<Dim>&, const lod::Body<Dim>&, const lod::FrameSettings&,          \
        const BodyShapes<Dim>&, const Watch&);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
