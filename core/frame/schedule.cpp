#include "lodlab/core/frame/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

constexpr std::size_t pairs_fetched = 8;  ///< before they are tested

/// How far the nodes of a level stand out of the leaves, both bodies together [m].
template <int Dim>
double pair_error(const PosedTree<Dim>& a, const PosedTree<Dim>& b, int level) {
    return a.tree().error_at(level) + b.tree().error_at(level);
}

}  // namespace

/// What a frame hands to the scheduler's steps.
template <int Dim>
struct Scheduler<Dim>::Frame {
    const RefineTask<Dim>& task;
    Budget& budget;
    Fronts& fronts;
    std::uint64_t node_pairs = 0;  ///< of all fronts

    [[nodiscard]] PosedTree<Dim>& a(std::size_t pair) const {
        return task.world_S[at(task.pairs[pair].a)];
    }
    [[nodiscard]] PosedTree<Dim>& b(std::size_t pair) const {
        return task.world_S[at(task.pairs[pair].b)];
    }
};

template <int Dim>
void Scheduler<Dim>::refine_all(const RefineTask<Dim>& task, Budget& budget, Fronts& fronts) {
    fronts.of_pair.resize(task.pairs.size());
    counts_ = {};
    turns_.clear();
    weighed_ = false;
    const bool trades = task.priority == Priority::trade && !own_value;
    refill(last_tests_, trades ? task.pairs.size() : 0, std::uint64_t{0});
    Frame frame{task, budget, fronts};
    const bool at_once = budget.is_unlimited();
    const bool governed = budget.governs_entries();
    enter_all(frame, at_once ? task.levels.deepest : 0, governed);
    if (governed) enter_chosen(frame);
    if (!at_once) {
        budget.expect(pace_);
        if (budget.goes_deeper()) {
            if (!own_value) weigh(task);
            fill_heap(frame);
        }
        const bool stores = task.organisation == Organisation::stored;
        if (stores) store_entries(frame);
        if (budget.goes_deeper()) run(frame);
        if (stores) resolve(frame);
        budget.reserve(frame.node_pairs);
        budget.levels_done();
    }
    if (trades) remember(frame);
}

/// Whatever the budget says. Each worker has a list of its own; a front says in which it is.
template <int Dim>
void Scheduler<Dim>::enter_all(Frame& frame, int deepest, bool roots_alone) {
    Executor* const executor = frame.task.executor;
    const std::size_t pairs = frame.task.pairs.size();
    frame.fronts.lists.resize(workers_of(executor));
    for (FrontList& list : frame.fronts.lists) list.clear();
    entered_.resize(parts_of(executor, pairs, pairs_of_a_part));
    each_part(executor, pairs, pairs_of_a_part,
              [&](const Part& part) { enter(frame, part, deepest, roots_alone); });
    frame.fronts.meeting = 0;
    add_up(frame);
}

template <int Dim>
void Scheduler<Dim>::add_up(Frame& frame) {
    frame.node_pairs = 0;
    for (const Entered& part : entered_) {
        frame.node_pairs += part.node_pairs;
        frame.fronts.meeting += part.meeting;
        frame.budget.spend(part.tests);
    }
}

template <int Dim>
void Scheduler<Dim>::enter(const Frame& frame, const Part& part, int deepest, bool roots_alone) {
    FrontList& list = frame.fronts.lists[part.worker];
    Entered& done = entered_[part.number];
    done = {};
    for (std::size_t pair = part.begin; pair < part.end; ++pair) {
        ListedFront& front = frame.fronts.of_pair[pair];
        if (pair + pairs_fetched < part.end) prefetch(frame.b(pair + pairs_fetched));
        test_roots(frame.a(pair), frame.b(pair), front, list);
        front.list = static_cast<std::int32_t>(part.worker);
        if (front.pairs.count > 0) {  // most are apart
            ++done.meeting;
            if (!roots_alone) deepen(frame, pair, deepest, list);
            done.node_pairs += static_cast<std::uint64_t>(front.pairs.count);
        }
        done.tests += front.tests;
    }
}

/// From level 0 to the entry level, or deeper.
template <int Dim>
void Scheduler<Dim>::deepen(const Frame& frame, std::size_t pair, int deepest, FrontList& list) {
    ListedFront& front = frame.fronts.of_pair[pair];
    const PosedTree<Dim>& a = frame.a(pair);
    const PosedTree<Dim>& b = frame.b(pair);
    const int entry = std::max(entry_level(a, b, frame.task.levels.begin_at_entry), deepest);
    const std::uint64_t last = refine_to(a, b, entry, front, list);
    if (last > 0) note(pair, last);
}

/// Takes as many pairs to their entry levels as there is time for, those first that matter most.
template <int Dim>
void Scheduler<Dim>::enter_chosen(Frame& frame) {
    frame.budget.expect(pace_);
    const std::uint64_t meeting = frame.fronts.meeting;
    const std::uint64_t most = frame.budget.entries({frame.task.bodies.size(), 0, meeting});
    counts_.by_roots = meeting - most;
    if (most < meeting) choose(frame, most);
    if (!frame.budget.goes_deeper()) counts_.skipped += meeting;
    if (most > 0 && frame.task.levels.begin_at_entry) {
        each_part(frame.task.executor, frame.task.pairs.size(), pairs_of_a_part,
                  [&](const Part& part) { enter_again(frame, part); });
        frame.fronts.meeting = 0;
        add_up(frame);
    }
    frame.budget.entries_done(most);
}

/// The roots of each pair have been tested, perhaps by another worker.
template <int Dim>
void Scheduler<Dim>::enter_again(const Frame& frame, const Part& part) {
    FrontList& list = frame.fronts.lists[part.worker];
    Entered& done = entered_[part.number];
    done = {};
    for (std::size_t pair = part.begin; pair < part.end; ++pair) {
        ListedFront& front = frame.fronts.of_pair[pair];
        if (front.pairs.count == 0) continue;
        if (!front.by_roots && !front.finest) {
            front.pairs.first = static_cast<std::int32_t>(list.size());
            *list.room_for(1) = {0, 0};
            list.take(1);
            front.list = static_cast<std::int32_t>(part.worker);
            deepen(frame, pair, 0, list);
            done.tests += front.tests - 1;
        }
        done.meeting += front.pairs.count > 0 ? 1 : 0;
        done.node_pairs += static_cast<std::uint64_t>(front.pairs.count);
    }
}

/// By what the policy knows of pairs before their levels; by number where that is nothing.
template <int Dim>
void Scheduler<Dim>::choose(const Frame& frame, std::uint64_t most) {
    const RefineTask<Dim>& task = frame.task;
    weight_.clear();
    if (most > 0 && !own_value) {
        if (task.priority == Priority::best_gain || task.priority == Priority::trade)
            for (std::size_t i = 0; i < task.pairs.size(); ++i)
                weight_.push_back(pair_error(frame.a(i), frame.b(i), 0));
        else
            weigh(task);
    }
    entries_.choose(most, weight_, frame.fronts.of_pair);
}

template <int Dim>
Refinement Scheduler<Dim>::refine_one(Frame& frame, std::size_t pair, Budget& by) {
    ListedFront& front = frame.fronts.of_pair[pair];
    const std::uint64_t tests_before = front.tests;
    frame.node_pairs -= static_cast<std::uint64_t>(front.pairs.count);
    const Refinement done =
        refine(frame.a(pair), frame.b(pair), by, front, frame.fronts.list_of(pair));
    frame.node_pairs += static_cast<std::uint64_t>(front.pairs.count);
    if (done == Refinement::finished) note(pair, front.tests - tests_before);
    return done;
}

/// What the pair's last finished level took, where the policy asks for that.
template <int Dim>
void Scheduler<Dim>::note(std::size_t pair, std::uint64_t tests) {
    if (pair < last_tests_.size()) last_tests_[pair] = tests;
}

/// What the policy knows of pairs before their levels.
template <int Dim>
void Scheduler<Dim>::weigh(const RefineTask<Dim>& task) {
    if (std::exchange(weighed_, true)) return;
    if (task.priority == Priority::perceptual)
        attention_.weigh(task.viewer, task.bodies, task.pairs, weight_);
    if (task.priority == Priority::trade) trade.plan(task.pairs, targets_);
    if (task.priority != Priority::closing_speed) return;
    weight_.resize(task.pairs.size());
    for (std::size_t i = 0; i < task.pairs.size(); ++i)
        weight_[i] =
            closing_speed(task.bodies[at(task.pairs[i].a)], task.bodies[at(task.pairs[i].b)]);
}

template <int Dim>
std::span<const std::int32_t> Scheduler<Dim>::rank(const RefineTask<Dim>& task) {
    order_.resize(task.pairs.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (task.priority != Priority::closing_speed && task.priority != Priority::perceptual)
        return order_;
    weigh(task);
    std::sort(order_.begin(), order_.end(), [&](std::int32_t x, std::int32_t y) {
        return weight_[at(x)] != weight_[at(y)] ? weight_[at(x)] > weight_[at(y)] : x < y;
    });
    return order_;
}

/// Node tests of the pair's next level; 0 where there is none.
template <int Dim>
std::uint64_t Scheduler<Dim>::next_tests(const Frame& frame, std::size_t pair) const {
    const ListedFront& front = frame.fronts.of_pair[pair];
    if (front.finest || front.level >= frame.task.levels.deepest) return 0;
    return next_level_tests(frame.a(pair).tree(), frame.b(pair).tree(), frame.fronts.pairs(pair));
}

/// The next level of a pair. Returns whether there is one.
template <int Dim>
bool Scheduler<Dim>::offer(const Frame& frame, std::size_t pair, WaitingLevel& waiting) const {
    waiting.tests = next_tests(frame, pair);
    if (waiting.tests == 0) return false;
    waiting.pair = static_cast<std::int32_t>(pair);
    const int level = frame.fronts.of_pair[pair].level + 1;
    waiting.tier = own_value ? 0 : tier(frame.task.priority, pair, level);
    waiting.value = value(frame, waiting, level);
    if (std::isnan(waiting.value)) waiting.value = -std::numeric_limits<double>::infinity();
    return true;
}

template <int Dim>
std::int32_t Scheduler<Dim>::tier(Priority priority, std::size_t pair, int level) const {
    switch (priority) {
        case Priority::level_order:
        case Priority::closing_speed:
            return level;
        case Priority::trade:
            return level > targets_[pair] ? 1 : 0;
        case Priority::first_come:
        case Priority::perceptual:
        case Priority::best_gain:
            break;
    }
    return 0;
}

template <int Dim>
double Scheduler<Dim>::value(const Frame& frame, const WaitingLevel& waiting, int level) const {
    const std::size_t pair = at(waiting.pair);
    const auto fall = [&] {
        return pair_error(frame.a(pair), frame.b(pair), level - 1) -
               pair_error(frame.a(pair), frame.b(pair), level);
    };
    const RefineTask<Dim>& task = frame.task;
    if (own_value)
        return own_value({task.bodies[at(task.pairs[pair].a)], task.bodies[at(task.pairs[pair].b)],
                          waiting.pair, level, waiting.tests, fall()});
    switch (task.priority) {
        case Priority::level_order:
        case Priority::first_come:
            return 0;
        case Priority::closing_speed:
            return weight_[pair];
        case Priority::perceptual:
            return weight_[pair] * fall() / static_cast<double>(waiting.tests);
        case Priority::best_gain:
        case Priority::trade:
            break;
    }
    return fall() / static_cast<double>(waiting.tests);
}

template <int Dim>
void Scheduler<Dim>::fill_heap(Frame& frame) {
    heap_.clear();
    WaitingLevel waiting;
    for (std::size_t i = 0; i < frame.task.pairs.size(); ++i)
        if (offer(frame, i, waiting)) heap_.append(waiting);
    heap_.put_in_order();
}

template <int Dim>
void Scheduler<Dim>::run(Frame& frame) {
    while (!heap_.empty()) {
        const WaitingLevel next = heap_.pop();
        frame.budget.reserve(frame.node_pairs);
        take_turn(frame, next);
        if (frame.budget.ended()) {
            counts_.skipped += heap_.size();
            return;
        }
    }
}

template <int Dim>
void Scheduler<Dim>::take_turn(Frame& frame, const WaitingLevel& next) {
    const std::size_t pair = at(next.pair);
    const ListedFront& front = frame.fronts.of_pair[pair];
    Turn turn{next.pair, front.level + 1, next.tests, TurnEnd::skipped};
    frame.budget.begin(turn.pair, turn.level);
    if (!frame.budget.fits(next.tests)) {
        turns_.push_back(turn);
        return skip(frame);
    }
    const std::uint64_t tests_before = front.tests;
    const bool done = refine_one(frame, pair, frame.budget) == Refinement::finished;
    turn.tests = front.tests - tests_before;
    turn.end = done ? TurnEnd::finished : TurnEnd::dropped;
    turns_.push_back(turn);
    if (!done) {
        ++counts_.dropped;
        return;
    }
    ++counts_.finished;
    if (frame.task.organisation == Organisation::stored) store(frame, pair);
    WaitingLevel deeper;
    if (offer(frame, pair, deeper)) heap_.push(deeper);
}

/// The level just taken does not fit; where none that waits does either, all are left out.
template <int Dim>
void Scheduler<Dim>::skip(Frame& frame) {
    ++counts_.skipped;
    if (heap_.empty() || frame.budget.fits_any(heap_.least_tests())) return;
    counts_.skipped += heap_.size();
    heap_.clear();
}

template <int Dim>
void Scheduler<Dim>::store(const Frame& frame, std::size_t pair) {
    stored_.add(static_cast<std::int32_t>(pair), frame.fronts.of_pair[pair],
                frame.fronts.pairs(pair));
}

template <int Dim>
void Scheduler<Dim>::store_entries(Frame& frame) {
    stored_.clear();
    for (std::size_t i = 0; i < frame.task.pairs.size(); ++i) store(frame, i);
    frame.budget.divide(frame.node_pairs);
}

/// Decides at which of its stored levels each pair is answered.
template <int Dim>
void Scheduler<Dim>::resolve(Frame& frame) {
    const std::uint64_t most = frame.budget.join();
    for (FrontList& list : frame.fronts.lists) list.clear();
    if (!stored_.resolve(most, frame.fronts.of_pair, frame.fronts.lists.front()))
        frame.budget.answer_only(most);
    frame.node_pairs = 0;
    for (const ListedFront& front : frame.fronts.of_pair)
        frame.node_pairs += static_cast<std::uint64_t>(front.pairs.count);
}

/// What trade goes by in the next frame.
template <int Dim>
void Scheduler<Dim>::remember(const Frame& frame) {
    trade.held.clear();
    for (std::size_t i = 0; i < frame.task.pairs.size(); ++i) {
        const ListedFront& front = frame.fronts.of_pair[i];
        const auto error = [&](int level) { return pair_error(frame.a(i), frame.b(i), level); };
        HeldLevel held{frame.task.pairs[i], front.level};
        const int entry = entry_level(frame.a(i), frame.b(i), frame.task.levels.begin_at_entry);
        if (front.level > entry) {
            held.last_tests = last_tests_[i];
            held.last_fall = error(front.level - 1) - error(front.level);
        }
        held.next_tests = next_tests(frame, i);
        if (held.next_tests > 0) held.next_fall = error(front.level) - error(front.level + 1);
        trade.held.push_back(held);
    }
}

template class Scheduler<2>;
template class Scheduler<3>;

}  // namespace lod
