#pragma once

/// \file
/// The scheduler: refines the candidate pairs of a frame under one budget, a level of a pair at a
/// time, in the order of a policy.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/frame/broad_phase.hpp"
#include "lodlab/core/frame/schedule/attention.hpp"
#include "lodlab/core/frame/schedule/collision_tree.hpp"
#include "lodlab/core/frame/schedule/entries.hpp"
#include "lodlab/core/frame/schedule/level_heap.hpp"
#include "lodlab/core/frame/schedule/policy.hpp"
#include "lodlab/core/frame/schedule/trade.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lod {

/// To which levels a frame refines.
struct Levels {
    int deepest = 1000;           ///< refinement stops after this level
    bool begin_at_entry = false;  ///< hulls tell of contacts: see Scheduler::refine_all
};

/// What a frame refines.
template <int Dim>
struct RefineTask {
    std::span<const Body<Dim>> bodies;
    std::span<const CandidatePair> pairs;
    std::span<PosedTree<Dim>> world_S;  ///< of all bodies
    Levels levels;
    Priority priority = Priority::closing_speed;
    Viewer viewer;  ///< of Priority::perceptual
    Organisation organisation = Organisation::interleaved;
    Executor* executor = nullptr;  ///< of entry levels, and of all where there is no limit
};

/// The first level that says something of a pair: 0, or where contacts come from hulls the deeper
/// of the two bodies' entry levels (NodeHulls::entry_level).
template <int Dim>
[[nodiscard]] int entry_level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, bool by_hulls);

/// Of every candidate pair, in their order: how far it was refined.
struct Fronts {
    std::vector<ListedFront> of_pair;
    std::vector<FrontList> lists{1};  ///< one for each worker of an executor
    std::uint64_t meeting = 0;        ///< pairs that no entry level told apart

    /// The list that has the nodes of a candidate pair.
    [[nodiscard]] FrontList& list_of(std::size_t pair) { return lists[at(of_pair[pair].list)]; }
    /// The overlapping nodes of a candidate pair.
    [[nodiscard]] std::span<const NodePair> pairs(std::size_t pair) const {
        return lists[at(of_pair[pair].list)].pairs_of(of_pair[pair]);
    }
    /// The front of a candidate pair with a list of its own.
    [[nodiscard]] Front front(std::size_t pair) const {
        return lists[at(of_pair[pair].list)].front(of_pair[pair]);
    }
};

/// The node tests of a pair's next level, known before it is begun: over its front, the children of
/// one node times those of the other, a leaf counting as its own child beside an inner node.
template <int Dim>
[[nodiscard]] std::uint64_t next_level_tests(const SphereTree<Dim>& a, const SphereTree<Dim>& b,
                                             std::span<const NodePair> front);

/// What a scheduler did with the levels beyond the entry ones.
struct LevelCounts {
    std::uint64_t finished = 0;
    std::uint64_t skipped = 0;   ///< not begun, for they would not have fitted; one a pair at most
    std::uint64_t by_roots = 0;  ///< pairs that were not taken to their entry levels either
    std::uint64_t dropped = 0;   ///< begun, but they found more node pairs than could be paid for,
                                 ///< or the clock ran out
};

/// What became of a level that had its turn under a limit.
enum class TurnEnd {
    finished,  ///< the pair stands one level deeper
    dropped,   ///< begun, and thrown away: LevelCounts::dropped
    skipped,   ///< not begun, for it would not have fitted
};

/// The turn of a pair's next level.
struct Turn {
    std::int32_t pair = 0;    ///< into the candidates
    std::int32_t level = 0;   ///< in the making
    std::uint64_t tests = 0;  ///< done; of a skipped one: that it would have taken
    TurnEnd end = TurnEnd::finished;
    friend bool operator==(const Turn&, const Turn&) = default;
};

/// The scheduler (section 5.1). The entry level of every pair is always done, which is level 0 but
/// for bodies with hollows; its tests are spent whatever the budget says. Only on a clock that
/// reserves what follows, where there is no time for that, those pairs alone go on from level 0
/// which matter most to the policy (Budget::entries): the others stay there and touch as their root
/// balls do. Then one level of one
/// pair at a time, from a heap in the order of the policy, ties by candidate number, until nothing
/// waits or fits. The cost of a level is known before it is begun: one that does not fit into the
/// rest of the budget is skipped, its pair stays where it stands, and cheaper levels of other pairs
/// may still fit. What follows stays reserved: beyond the entry level, tests and node pairs
/// together never cost more than a quota of tests. Where the budget cuts something, Budget::cut
/// says where.
///
/// A scheduler keeps its storage, how long a node test took so far, and for Priority::trade the
/// levels of the last frame.
template <int Dim>
class Scheduler {
  public:
    /// Refines all pairs. Without a limit each goes down to its end at once: the order changes
    /// nothing then.
    void refine_all(const RefineTask<Dim>& task, Budget& budget, Fronts& fronts);

    /// The pairs as the levels after the leaves take them: by attention with
    /// Priority::perceptual, by closing speed with closing_speed, else by number. Requires: `task`
    /// is that of the last refine_all.
    [[nodiscard]] std::span<const std::int32_t> rank(const RefineTask<Dim>& task);

    /// Takes the place of the policy in refine_all; an empty one gives it back.
    LevelValue<Dim> own_value;
    /// What Priority::trade remembers.
    Trade trade;

    /// Of the last refine_all.
    [[nodiscard]] const LevelCounts& counts() const { return counts_; }
    /// Its turns, in their order: the levels beyond the entry ones. None where there was no limit,
    /// nor of levels that were still waiting when nothing fitted any more.
    [[nodiscard]] const std::vector<Turn>& turns() const { return turns_; }
    /// At the end of a frame: what was measured of time, for the next.
    void learn(const Budget& budget) { pace_ = budget.next_pace().value_or(pace_); }
    /// What is expected on a clock.
    [[nodiscard]] const Pace& pace() const { return pace_; }

  private:
    struct Frame;
    void weigh(const RefineTask<Dim>& task);
    /// What the entry of a part of the pairs came to.
    struct Entered {
        std::uint64_t node_pairs = 0;
        std::uint64_t meeting = 0;
        std::uint64_t tests = 0;
    };
    void enter_all(Frame& frame, int deepest, bool roots_alone);
    void enter(const Frame& frame, const Part& part, int deepest, bool roots_alone);
    void deepen(const Frame& frame, std::size_t pair, int deepest, FrontList& list);
    void enter_chosen(Frame& frame);
    void enter_again(const Frame& frame, const Part& part);
    void choose(const Frame& frame, std::uint64_t most);
    void add_up(Frame& frame);
    void note(std::size_t pair, std::uint64_t tests);
    [[nodiscard]] Refinement refine_one(Frame& frame, std::size_t pair, Budget& by);
    void fill_heap(Frame& frame);
    [[nodiscard]] std::uint64_t next_tests(const Frame& frame, std::size_t pair) const;
    [[nodiscard]] bool offer(const Frame& frame, std::size_t pair, WaitingLevel& waiting) const;
    [[nodiscard]] std::int32_t tier(Priority priority, std::size_t pair, int level) const;
    [[nodiscard]] double value(const Frame& frame, const WaitingLevel& waiting, int level) const;
    void run(Frame& frame);
    void take_turn(Frame& frame, const WaitingLevel& next);
    void skip(Frame& frame);
    void remember(const Frame& frame);
    void store(const Frame& frame, std::size_t pair);
    void store_entries(Frame& frame);
    void resolve(Frame& frame);

    std::vector<Entered> entered_;
    LevelHeap heap_;
    std::vector<double> weight_;  ///< of each pair, where the policy has one
    bool weighed_ = false;        ///< since refine_all began
    Attention<Dim> attention_;
    std::vector<std::int32_t> order_;
    std::vector<std::int32_t> targets_;      ///< of each pair, for trade
    std::vector<std::uint64_t> last_tests_;  ///< of each pair's last finished level, for trade
    Entries entries_;
    CollisionTree stored_;
    Pace pace_;
    LevelCounts counts_;
    std::vector<Turn> turns_;
};

extern template class Scheduler<2>;
extern template class Scheduler<3>;

}  // namespace lod
