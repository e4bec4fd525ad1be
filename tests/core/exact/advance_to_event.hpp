#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/response/impact.hpp"

namespace lodtest {

/// A collision that was found ahead.
template <int Dim>
struct Event {
    double time = 0;                        ///< from now [s]
    std::vector<lod::Impact<Dim>> impacts;  ///< every approaching contact of that moment
};

template <int Dim>
void check_search(const lod::TimeOfImpact<Dim>& touch, std::size_t i, std::size_t j) {
    const bool overlap = touch.outcome == lod::ImpactOutcome::overlapping;
    if (!overlap && touch.outcome != lod::ImpactOutcome::cap_reached) return;
    throw lod::Error(
        lod::ErrorKind::limit_exceeded,
        "bodies number " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
            (overlap ? " overlap, so no impact of theirs lies ahead; move them apart"
                     : ": the search for their impact reached its cap; raise most_rounds"));
}

/// Contacts of a pair that stands within the tolerance and approaches there.
template <int Dim>
void add_impacts(std::span<const lod::Body<Dim>> bodies, std::int32_t i, std::int32_t j,
                 std::int32_t pair, double tolerance, Event<Dim>& event) {
    const lod::Body<Dim>& a = bodies[static_cast<std::size_t>(i)];
    const lod::Body<Dim>& b = bodies[static_cast<std::size_t>(j)];
    const double gap = lod::separation(a, b).distance;
    if (gap > tolerance) return;
    std::vector<lod::Contact<Dim>> contacts;
    lod::touching_contacts(a, b, gap + tolerance, contacts);
    for (const lod::Contact<Dim>& contact : contacts)
        if (lod::closing_velocity(a, b, contact) < 0)
            event.impacts.push_back({i, j, pair, contact});
}

/// Event-driven motion of a few bodies: moves all of them freely to the first moment at which any
/// two of them collide, or for settings.horizon seconds if none do within it, and then returns
/// nothing. The response is the caller's: Resolver, with the event's impacts. Every pair is
/// searched anew, so the time grows with the square of the number of bodies: this is a reference,
/// not a way to simulate crowds.
/// Throws Error (limit exceeded) when bodies overlap or when a search reaches its cap; and as
/// lod::time_of_impact does.
template <int Dim>
std::optional<Event<Dim>> advance_to_event(std::span<lod::Body<Dim>> bodies,
                                           const lod::ImpactSettings& settings = {}) {
    lod::ImpactSettings search = settings;
    bool any = false;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (bodies[i].is_static() && bodies[j].is_static()) continue;
            const auto touch = lod::time_of_impact(bodies[i], bodies[j], search);
            check_search(touch, i, j);
            if (touch.outcome != lod::ImpactOutcome::touching) continue;
            any = true;
            search.horizon = touch.time;  // nothing later matters
        }
    for (lod::Body<Dim>& body : bodies)
        body = lod::moved_freely(body, search.horizon, settings.longest_turn);
    if (!any) return {};
    Event<Dim> event;
    event.time = search.horizon;
    std::int32_t pair = 0;
    const auto count = static_cast<std::int32_t>(bodies.size());
    for (std::int32_t i = 0; i < count; ++i)
        for (std::int32_t j = i + 1; j < count; ++j, ++pair)
            if (!bodies[static_cast<std::size_t>(i)].is_static() ||
                !bodies[static_cast<std::size_t>(j)].is_static())
                add_impacts<Dim>(bodies, i, j, pair, settings.tolerance, event);
    return event;
}

}  // namespace lodtest
