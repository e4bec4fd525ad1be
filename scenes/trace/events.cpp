#include "lodlab/scenes/trace/events.hpp"

#include "lodlab/core/base/lists.hpp"

namespace scenes {
namespace {

template <int Dim>
void add_levels(const Step<Dim>& step, const lod::PairRecord& pair,
                std::span<const lod::Body<Dim>> bodies, std::vector<Event<Dim>>& events) {
    const auto [a, b] = pair.bodies;
    const auto before = [&](std::int32_t number) {
        lod::Body<Dim> body = bodies[lod::at(number)];
        put(step.before[lod::at(number)], body);
        return body;
    };
    std::uint64_t tests = 0;
    for (const lod::Front& front : lod::traverse_levels<Dim>(before(a), before(b), pair.level)) {
        Event<Dim> event{EventKind::level, a, b};
        event.level = front.level;
        event.tests = front.tests - tests;
        event.overlapping = front.pairs.size();
        tests = front.tests;
        events.push_back(event);
    }
    if (pair.finest == lod::Finest::leaves) return;
    Event<Dim> event{EventKind::exact, a, b};
    event.overlapping = static_cast<std::uint64_t>(pair.contact_count);
    event.time = pair.impact_time;
    events.push_back(event);
}

}  // namespace

template <int Dim>
std::vector<Event<Dim>> events_of(const Step<Dim>& step, std::span<const lod::Body<Dim>> bodies) {
    const lod::FrameRecord<Dim>& record = step.record;
    std::vector<Event<Dim>> events;
    for (const lod::PairRecord& pair : record.pairs) add_levels(step, pair, bodies, events);
    for (const lod::Impact<Dim>& impact : record.impacts) {
        Event<Dim> event{EventKind::contact, impact.a, impact.b};
        event.contact = impact.contact;
        events.push_back(event);
    }
    for (std::size_t i = 0; i < record.impacts.size(); ++i) {
        if (record.impulses[i] == 0) continue;
        Event<Dim> event{EventKind::impulse, record.impacts[i].a, record.impacts[i].b};
        event.contact = record.impacts[i].contact;
        event.impulse = record.impulses[i];
        events.push_back(event);
    }
    for (const lod::SweptImpact<Dim>& met : record.swept) {
        Event<Dim> event{EventKind::swept, met.a, met.b};
        event.contact = met.contact;
        event.impulse = met.impulse;
        event.time = met.time;
        events.push_back(event);
    }
    return events;
}

template std::vector<Event<2>> events_of(const Step<2>&, std::span<const lod::Body<2>>);
template std::vector<Event<3>> events_of(const Step<3>&, std::span<const lod::Body<3>>);

}  // namespace scenes
