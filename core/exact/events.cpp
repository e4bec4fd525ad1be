#include "lodlab/core/exact/events.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/response/impact.hpp"

namespace lod {
namespace {

template <int Dim>
void check(const TimeOfImpact<Dim>& touch, std::size_t i, std::size_t j) {
    const bool overlap = touch.outcome == ImpactOutcome::overlapping;
    if (!overlap && touch.outcome != ImpactOutcome::cap_reached) return;
    throw Error(ErrorKind::limit_exceeded,
                "bodies number " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                    (overlap ? " overlap, so no impact of theirs lies ahead; move them apart"
                             : ": the search for their impact reached its cap; raise most_rounds"));
}

/// Contacts of a pair that stands within the tolerance and approaches there.
template <int Dim>
void add_impacts(std::span<const Body<Dim>> bodies, std::int32_t i, std::int32_t j,
                 std::int32_t pair, double tolerance, Event<Dim>& event) {
    const Body<Dim>& a = bodies[static_cast<std::size_t>(i)];
    const Body<Dim>& b = bodies[static_cast<std::size_t>(j)];
    const double gap = separation(a, b).distance;
    if (gap > tolerance) return;
    std::vector<Contact<Dim>> contacts;
    touching_contacts(a, b, gap + tolerance, contacts);
    for (const Contact<Dim>& contact : contacts)
        if (closing_velocity(a, b, contact) < 0) event.impacts.push_back({i, j, pair, contact});
}

}  // namespace

template <int Dim>
std::optional<Event<Dim>> advance_to_event(std::span<Body<Dim>> bodies,
                                           const ImpactSettings& settings) {
    ImpactSettings search = settings;
    bool any = false;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (bodies[i].is_static() && bodies[j].is_static()) continue;
            const auto touch = time_of_impact(bodies[i], bodies[j], search);
            check(touch, i, j);
            if (touch.outcome != ImpactOutcome::touching) continue;
            any = true;
            search.horizon = touch.time;  // nothing later matters
        }
    for (Body<Dim>& body : bodies) body = moved_freely(body, search.horizon, settings.longest_turn);
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

template std::optional<Event<2>> advance_to_event(std::span<Body<2>>, const ImpactSettings&);
template std::optional<Event<3>> advance_to_event(std::span<Body<3>>, const ImpactSettings&);

}  // namespace lod
