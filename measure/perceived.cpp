#include "lodlab/measure/perceived.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lodlab/measure/first_impact.hpp"

namespace measure {
namespace {

template <int Dim>
using Two = std::array<lod::Body<Dim>, 2>;

double two_sided(double value, double above, double below) {
    return value >= 0 ? value / above : -value / below;
}

/// What one body shows.
struct Shown {
    double angle = 0;
    double speed = 0;
    double spin = 0;
};

/// A body before and after a collision.
template <int Dim>
struct Course {
    const lod::Body<Dim>& before;
    const lod::Body<Dim>& after;
};

/// By what a body's motion is measured.
struct Measures {
    double size = 0;
    double pace = 0;
    double still = 0;
};

template <int Dim>
Shown shown_by(const Course<Dim>& in_reference, const Course<Dim>& in_seen,
               const Measures& measures) {
    const auto [size, pace, still] = measures;
    const lod::Vector<Dim>& reference = in_reference.after.velocity;
    const lod::Vector<Dim>& seen = in_seen.after.velocity;
    Shown shown;
    shown.speed = (seen.norm() - reference.norm()) / pace;
    shown.spin = (in_seen.after.spin - in_reference.after.spin).norm() * size / 2 / pace;
    const double slowest = still * pace;
    if (std::min(seen.norm(), reference.norm()) < slowest) return shown;
    shown.angle = angle_between<Dim>(seen, reference);
    const auto deflection = [&](const lod::Body<Dim>& from, const lod::Vector<Dim>& to) {
        return from.velocity.norm() < slowest ? 0 : angle_between<Dim>(from.velocity, to);
    };
    if (deflection(in_seen.before, seen) < deflection(in_reference.before, reference))
        shown.angle = -shown.angle;
    return shown;
}

/// The relative change of the two bodies' kinetic energy.
template <int Dim>
double energy_change(const Collision<Dim>& collision) {
    const double before = lod::kinetic_energy<Dim>(collision.before);
    return before > 0 ? lod::kinetic_energy<Dim>(collision.after) / before - 1 : 0;
}

template <int Dim>
double pace_of(const Two<Dim>& bodies, const std::array<double, 2>& sizes) {
    double pace = 0;
    for (std::size_t i = 0; i < 2; ++i)
        pace = std::max({pace, bodies[i].velocity.norm(), bodies[i].spin.norm() * sizes[i] / 2});
    return pace;
}

void add(PerceivedCost& sum, const PerceivedCost& cost, double share) {
    sum.gap += share * cost.gap;
    sum.delay += share * cost.delay;
    sum.angle += share * cost.angle;
    sum.speed += share * cost.speed;
    sum.spin += share * cost.spin;
    sum.penetration += share * cost.penetration;
    sum.energy += share * cost.energy;
}

}  // namespace

template <int Dim>
std::vector<bool> first_collisions(std::span<const Collision<Dim>> collisions) {
    std::set<int> met;
    std::vector<bool> result;
    for (const Collision<Dim>& collision : collisions) {
        // Walls go nowhere: what hit them before does not matter.
        const auto is_new = [&](int body, std::size_t i) {
            return collision.before[i].is_static() || met.insert(body).second;
        };
        const bool a = is_new(collision.a, 0);
        const bool b = is_new(collision.b, 1);
        result.push_back(a && b);
    }
    return result;
}

template <int Dim>
Perceived perceived(const Collision<Dim>& reference, const Collision<Dim>& seen,
                    const BodyShapes<Dim>& shapes, const PerceivedSettings& settings) {
    const std::array<double, 2> sizes{shapes.size(reference.a), shapes.size(reference.b)};
    const double size = std::min(sizes[0], sizes[1]);
    const double pace = pace_of<Dim>(reference.before, sizes);
    Perceived error;
    error.gap = std::max(0.0, seen.gap - reference.gap) / size;
    error.penetration = std::max(0.0, seen.penetration - reference.penetration) / size;
    error.delay = seen.time - reference.time;
    error.energy = energy_change(seen) - energy_change(reference);
    if (!(pace > 0)) return error;
    for (std::size_t i = 0; i < 2; ++i) {
        if (reference.before[i].is_static()) continue;
        const Shown shown =
            shown_by<Dim>({reference.before[i], reference.after[i]},
                          {seen.before[i], seen.after[i]}, {sizes[i], pace, settings.still});
        const auto strictest = [](double& kept, double value, double above, double below) {
            if (two_sided(value, above, below) > two_sided(kept, above, below)) kept = value;
        };
        strictest(error.angle, shown.angle, settings.angle_expanded, settings.angle_contracted);
        strictest(error.speed, shown.speed, settings.speed_raised, settings.speed_lowered);
        error.spin = std::max(error.spin, shown.spin);
    }
    return error;
}

PerceivedCost cost_of(const Perceived& error, const PerceivedSettings& settings) {
    return {error.gap / settings.gap,
            two_sided(error.delay, settings.late, settings.early),
            two_sided(error.angle, settings.angle_expanded, settings.angle_contracted),
            two_sided(error.speed, settings.speed_raised, settings.speed_lowered),
            error.spin / settings.spin,
            error.penetration / settings.penetration,
            two_sided(error.energy, settings.energy_gained, settings.energy_lost)};
}

template <int Dim>
PerceivedError perceived_error(std::span<const Collision<Dim>> reference,
                               std::span<const Collision<Dim>> seen, const BodyShapes<Dim>& shapes,
                               const PerceivedSettings& settings) {
    Matching matching = match<Dim>(reference, seen, settings.window);
    const std::vector<bool> first_of_reference = first_collisions<Dim>(reference);
    const std::vector<bool> first_of_seen = first_collisions<Dim>(seen);
    PerceivedError result;
    for (const Matching::Pair& pair : matching.pairs) {
        const auto r = static_cast<std::size_t>(pair.reference);
        const auto s = static_cast<std::size_t>(pair.seen);
        const Perceived error = perceived<Dim>(reference[r], seen[s], shapes, settings);
        result.collisions.push_back({pair.reference, pair.seen,
                                     first_of_reference[r] && first_of_seen[s], error,
                                     cost_of(error, settings)});
    }
    result.missing = std::move(matching.missing);
    result.extra = std::move(matching.extra);
    const std::size_t events =
        result.collisions.size() + result.missing.size() + result.extra.size();
    if (events == 0) return result;
    const double share = 1 / static_cast<double>(events);
    for (const CollisionError& collision : result.collisions)
        add(result.cost, collision.cost, share);
    result.missing_cost = share * settings.missing * static_cast<double>(result.missing.size());
    result.extra_cost = share * settings.extra * static_cast<double>(result.extra.size());
    result.total = result.cost.sum() + result.missing_cost + result.extra_cost;
    return result;
}

#define MEASURE_INSTANTIATE(Dim)                                                    \
    template Perceived perceived(const Collision<Dim>&, const Collision<Dim>&,      \
                                 const BodyShapes<Dim>&, const PerceivedSettings&); \
    template std::vector<bool> first_collisions(std::span<const Collision<Dim>>);   \
    template PerceivedError perceived_error(std::span<const Collision<Dim>>,        \
                                            std::span<const Collision<Dim>>,        \
                                            const BodyShapes<Dim>&, const PerceivedSettings&);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
