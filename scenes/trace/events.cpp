#include "lodlab/scenes/trace/events.hpp"

#include <algorithm>
#include <limits>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/response/response.hpp"

namespace scenes {
namespace {

/// A frame that is taken apart.
template <int Dim>
struct PastFrame {
    const Step<Dim>& step;
    std::span<const lod::Body<Dim>> bodies;
    const lod::FrameSettings& settings;

    /// As the frame found it.
    [[nodiscard]] lod::Body<Dim> before(std::int32_t number) const {
        lod::Body<Dim> body = bodies[lod::at(number)];
        put(step.before[lod::at(number)], body);
        return body;
    }
};

/// The levels of one pair.
struct PairLevels {
    std::vector<lod::Front> fronts;                    ///< that were made
    int first_turn = std::numeric_limits<int>::max();  ///< level of it
    int deepest = 0;                                   ///< that was made
    bool is_told = false;  ///< what became of the level after the deepest one
};

template <int Dim>
class LevelEvents {
  public:
    LevelEvents(const PastFrame<Dim>& frame, std::vector<Event<Dim>>& events)
        : frame_(frame), record_(frame.step.record), events_(events) {}

    void add() {
        traverse();
        for (std::size_t p = 0; p < pairs_.size(); ++p)
            for (int level = 0; level < std::min(pairs_[p].first_turn, made(p)); ++level)
                add_finished(p, level);
        for (const lod::Turn& turn : record_.turns) add_turn(turn);
        for (std::size_t p = 0; p < pairs_.size(); ++p)
            if (waits(p)) add_unfinished(p, EventKind::skipped, pairs_[p].deepest + 1, 0);
    }

  private:
    [[nodiscard]] int made(std::size_t pair) const {
        return static_cast<int>(pairs_[pair].fronts.size());
    }

    /// All levels that a pair was refined by, whether or not it was answered at the last of them.
    void traverse() {
        pairs_.resize(record_.pairs.size());
        for (std::size_t p = 0; p < pairs_.size(); ++p) pairs_[p].deepest = record_.pairs[p].level;
        for (const lod::Turn& turn : record_.turns) {
            PairLevels& of = pairs_[lod::at(turn.pair)];
            of.first_turn = std::min(of.first_turn, turn.level);
            if (turn.end == lod::TurnEnd::finished) of.deepest = std::max(of.deepest, turn.level);
        }
        for (std::size_t p = 0; p < pairs_.size(); ++p) {
            PairLevels& of = pairs_[p];
            if (of.first_turn != std::numeric_limits<int>::max())
                of.deepest = std::max(of.deepest, of.first_turn - 1);
            of.fronts = lod::traverse_levels<Dim>(before_a(p), before_b(p), of.deepest);
        }
    }

    [[nodiscard]] lod::Body<Dim> before_a(std::size_t pair) const {
        return frame_.before(record_.pairs[pair].bodies.a);
    }
    [[nodiscard]] lod::Body<Dim> before_b(std::size_t pair) const {
        return frame_.before(record_.pairs[pair].bodies.b);
    }

    Event<Dim>& append(std::size_t pair, EventKind kind, int level) {
        Event<Dim>& event = events_.emplace_back();
        event.kind = kind;
        event.a = record_.pairs[pair].bodies.a;
        event.b = record_.pairs[pair].bodies.b;
        event.level = level;
        return event;
    }

    void add_finished(std::size_t pair, int level) {
        const std::vector<lod::Front>& fronts = pairs_[pair].fronts;
        Event<Dim>& event = append(pair, EventKind::level, level);
        event.tests = fronts[lod::at(level)].tests;
        if (level > 0) event.tests -= fronts[lod::at(level - 1)].tests;
        event.overlapping = fronts[lod::at(level)].pairs.size();
    }

    void add_unfinished(std::size_t pair, EventKind kind, int level, std::uint64_t tests) {
        Event<Dim>& event = append(pair, kind, level);
        event.tests = tests;
        event.needed = lod::next_level_tests<Dim>(*frame_.bodies[lod::at(event.a)].tree,
                                                  *frame_.bodies[lod::at(event.b)].tree,
                                                  pairs_[pair].fronts[lod::at(level - 1)].pairs);
        pairs_[pair].is_told = true;
    }

    void add_turn(const lod::Turn& turn) {
        const std::size_t pair = lod::at(turn.pair);
        if (turn.end == lod::TurnEnd::finished) return add_finished(pair, turn.level);
        if (turn.end == lod::TurnEnd::dropped)
            return add_unfinished(pair, EventKind::dropped, turn.level, turn.tests);
        add_unfinished(pair, EventKind::skipped, turn.level, 0);
    }

    /// Whether the budget left out the pair's next level without a turn of its own.
    [[nodiscard]] bool waits(std::size_t pair) const {
        const PairLevels& of = pairs_[pair];
        if (!record_.cut || of.is_told || of.fronts.back().finest) return false;
        if (record_.cut->modelled && pair >= *record_.cut->modelled) return false;
        return of.deepest < frame_.settings.deepest_level;
    }

    const PastFrame<Dim>& frame_;
    const lod::FrameRecord<Dim>& record_;
    std::vector<Event<Dim>>& events_;
    std::vector<PairLevels> pairs_;
};

template <int Dim>
void add_exact(const lod::FrameRecord<Dim>& record, std::vector<Event<Dim>>& events) {
    for (const lod::PairRecord& pair : record.pairs) {
        if (pair.finest == lod::Finest::leaves) continue;
        Event<Dim>& event = events.emplace_back();
        event.kind = EventKind::exact;
        event.a = pair.bodies.a;
        event.b = pair.bodies.b;
        event.overlapping = static_cast<std::uint64_t>(pair.contact_count);
        event.time = pair.impact_time;
    }
}

/// One at a contact.
template <int Dim>
Event<Dim> at_contact(EventKind kind, const lod::Impact<Dim>& impact, double impulse) {
    Event<Dim> event;
    event.kind = kind;
    event.a = impact.a;
    event.b = impact.b;
    event.contact = impact.contact;
    event.impulse = impulse;
    return event;
}

/// The impulses after each round of the response, as it is done again with one more of them; none
/// where it does not end as the frame's did.
template <int Dim>
std::vector<std::vector<double>> impulses_by_round(const PastFrame<Dim>& frame) {
    const lod::FrameRecord<Dim>& record = frame.step.record;
    std::vector<std::vector<double>> by_round;
    if (frame.settings.response != lod::Response::net || record.impacts.empty()) return by_round;
    lod::Resolver<Dim> resolver;
    for (std::int32_t rounds = 1;; ++rounds) {
        std::vector<lod::Body<Dim>> bodies;
        for (std::size_t i = 0; i < frame.bodies.size(); ++i)
            bodies.push_back(frame.before(static_cast<std::int32_t>(i)));
        lod::Cut cut;
        cut.rounds = rounds;
        lod::Budget budget = lod::Budget::until(cut);
        resolver.budget = &budget;
        resolver.resolve(lod::Response::net, record.impacts, bodies, by_round.emplace_back());
        if (!budget.refused() || (record.cut && record.cut->rounds == rounds)) break;
    }
    if (by_round.back() != record.impulses) by_round.clear();
    return by_round;
}

template <int Dim>
Event<Dim> round_of(const lod::FrameRecord<Dim>& record, std::vector<double> pushes) {
    const auto hardest = std::max_element(pushes.begin(), pushes.end()) - pushes.begin();
    const auto place = static_cast<std::size_t>(hardest);
    Event<Dim> event = at_contact(EventKind::round, record.impacts[place], pushes[place]);
    event.overlapping = static_cast<std::uint64_t>(
        std::count_if(pushes.begin(), pushes.end(), [](double push) { return push > 0; }));
    event.pushes = std::move(pushes);
    return event;
}

template <int Dim>
void add_rounds(const PastFrame<Dim>& frame, std::vector<Event<Dim>>& events) {
    std::vector<Event<Dim>> rounds;
    std::vector<double> before(frame.step.record.impacts.size());
    for (const std::vector<double>& after : impulses_by_round(frame)) {
        std::vector<double> pushes(after);
        for (std::size_t i = 0; i < pushes.size(); ++i) pushes[i] -= before[i];
        before = after;
        Event<Dim> event = round_of(frame.step.record, std::move(pushes));
        if (event.overlapping > 0) rounds.push_back(std::move(event));
    }
    if (rounds.size() < 2) return;  // the impulses say the same
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        rounds[i].round = static_cast<int>(i) + 1;
        rounds[i].rounds = static_cast<int>(rounds.size());
        events.push_back(std::move(rounds[i]));
    }
}

}  // namespace

template <int Dim>
std::vector<Event<Dim>> events_of(const Step<Dim>& step, std::span<const lod::Body<Dim>> bodies,
                                  const lod::FrameSettings& settings) {
    const lod::FrameRecord<Dim>& record = step.record;
    const PastFrame<Dim> frame{step, bodies, settings};
    std::vector<Event<Dim>> events;
    LevelEvents<Dim>(frame, events).add();
    add_exact(record, events);
    for (const lod::Impact<Dim>& impact : record.impacts)
        events.push_back(at_contact(EventKind::contact, impact, 0));
    add_rounds(frame, events);
    for (std::size_t i = 0; i < record.impacts.size(); ++i)
        if (record.impulses[i] != 0)
            events.push_back(at_contact(EventKind::impulse, record.impacts[i], record.impulses[i]));
    for (const lod::SweptImpact<Dim>& met : record.swept) {
        events.push_back(
            at_contact<Dim>(EventKind::swept, {met.a, met.b, 0, met.contact}, met.impulse));
        events.back().time = met.time;
    }
    std::array<int, names_of(EventKind{}).size()> counts{};
    for (Event<Dim>& event : events) event.nth = ++counts[static_cast<std::size_t>(event.kind)];
    return events;
}

template std::vector<Event<2>> events_of(const Step<2>&, std::span<const lod::Body<2>>,
                                         const lod::FrameSettings&);
template std::vector<Event<3>> events_of(const Step<3>&, std::span<const lod::Body<3>>,
                                         const lod::FrameSettings&);

}  // namespace scenes
