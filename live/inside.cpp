#include <algorithm>
#include <map>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/live/parts.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace live::detail {
namespace {

using Kind = scenes::EventKind;

constexpr double pale = 0.3;  ///< what came before

/// Draws a frame up to an event.
class InsidePicture {
  public:
    InsidePicture(viz::Panel& panel, const Stage& stage)
        : panel_(panel),
          stage_(stage),
          record_(stage.inside().step.record),
          events_(stage.inside().events),
          present_(events_[*stage.event()]) {}

    void draw() {
        add_levels();
        if (present_.kind < Kind::contact) return;
        add_nodes_behind();
        add_contacts();
        if (present_.kind == Kind::round) return add_pushes();
        add_impulses();
    }

  private:
    using Event = scenes::Event<2>;

    [[nodiscard]] std::span<const Event> reached() const {
        return std::span(events_).first(*stage_.event() + 1);
    }
    [[nodiscard]] viz::NumberedBody<2> body(std::int32_t number) const {
        return {stage_.bodies()[lod::at(number)], number};
    }
    [[nodiscard]] double longer() const { return viz::longer_side(panel_.view); }

    /// Each pair at the last level that it has reached by now, the present one in full.
    void add_levels() {
        std::map<std::pair<std::int32_t, std::int32_t>, const Event*> last;
        for (const Event& event : reached())
            if (event.kind <= Kind::skipped) last[{event.a, event.b}] = &event;
        for (const auto& [pair, event] : last)
            if (event != &present_) add_level(*event, pale);
        if (present_.kind <= Kind::skipped) add_level(present_, 1);
    }

    void add_level(const Event& event, double opacity) {
        const viz::NumberedBody<2> a = body(event.a);
        const viz::NumberedBody<2> b = body(event.b);
        const bool is_whole = event.kind == Kind::level;
        const std::vector<lod::Front> fronts =
            lod::traverse_levels<2>(a.body, b.body, is_whole ? event.level : event.level - 1);
        const lod::Front& front = fronts.back();
        if (is_whole && &event == &present_)
            add_tested(event, viz::tested_nodes<2>(a.body, b.body, fronts, event.level),
                       tested_role(stage_));
        if (event.kind == Kind::dropped && &event == &present_)
            add_tested(event, viz::tested_nodes<2>(a.body, b.body, front, event.tests),
                       viz::Role::dropped_node);
        viz::add_meeting_nodes<2>(panel_, a, b, front.pairs, opacity);
        if (&event == &present_) add_lines(panel_, a.body, b.body, front.pairs, opacity);
    }

    void add_tested(const Event& event, const viz::TestedNodes& tested, viz::Role role) {
        add_tested_of(event.a, tested.a, role);
        add_tested_of(event.b, tested.b, role);
    }
    void add_tested_of(std::int32_t number, const std::vector<int>& nodes, viz::Role role) {
        const lod::Body<2>& of = stage_.bodies()[lod::at(number)];
        if (!of.tree->is_half_space()) viz::add_nodes<2>(panel_, of, nodes, role, number);
    }

    /// The nodes that the present contact comes from.
    void add_nodes_behind() {
        if (present_.kind != Kind::contact) return;
        const lod::Range& range = record_.contact_nodes[lod::at(present_.nth - 1)];
        viz::add_meeting_nodes<2>(panel_, body(present_.a), body(present_.b),
                                  record_.nodes_of(range));
    }

    /// Those that are reached; the present one with its normal alone, for normals hide each other.
    void add_contacts() {
        std::vector<lod::Contact<2>> before;
        for (const Event& event : reached())
            if (event.kind == Kind::contact && &event != &present_) before.push_back(event.contact);
        const bool is_contact = present_.kind == Kind::contact;
        viz::add_contact_points<2>(panel_, before, is_contact ? pale : 1);
        if (!is_contact && present_.kind != Kind::swept) return;
        const std::vector<lod::Contact<2>> present{present_.contact};
        viz::add_contact_points<2>(panel_, present);
        if (is_contact) viz::add_normals<2>(panel_, present, normal_length * longer());
    }

    void add_push(const lod::Contact<2>& contact, double impulse, double most, double opacity,
                  bool is_told) {
        const double length = longest_impulse * longer() * impulse / most;
        viz::add_arrow<2>(panel_, {.role = viz::Role::impulse, .opacity = opacity}, contact.point,
                          contact.point + length * contact.normal,
                          is_told ? viz::quantity_text(impulse, "N\u00A0s", 2) : std::string());
    }

    void add_pushes() {
        for (std::size_t i = 0; i < present_.pushes.size(); ++i)
            if (present_.pushes[i] > 0)
                add_push(record_.impacts[i].contact, present_.pushes[i], present_.impulse, 1,
                         present_.overlapping <= told_impulses ||
                             present_.pushes[i] == present_.impulse);
    }

    void add_impulses() {
        double most = 0;
        for (const Event& event : events_)
            if (event.kind >= Kind::impulse) most = std::max(most, event.impulse);
        for (const Event& event : reached())
            if (event.kind >= Kind::impulse && event.impulse > 0)
                add_push(event.contact, event.impulse, most, &event == &present_ ? 1 : 2 * pale,
                         &event == &present_);
    }

    viz::Panel& panel_;
    const Stage& stage_;
    const lod::FrameRecord<2>& record_;
    const std::vector<Event>& events_;
    const Event& present_;
};

}  // namespace

void add_inside(viz::Panel& panel, const Stage& stage) {
    InsidePicture(panel, stage).draw();
}

std::string inside_finding(const Stage& stage) {
    const std::size_t place = *stage.event();
    const std::vector<scenes::Event<2>>& events = stage.inside().events;
    return "Event " + std::to_string(place + 1) + " of " + std::to_string(events.size()) + ": " +
           viz::literal_text(
               scenes::sentence<2>(events[place], stage.names(), scenes::Places::left_out)) +
           ".";
}

}  // namespace live::detail
