#pragma once

/// \file
/// What a frame found and did: the record that pictures, traces and metrics read.

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/core/frame/finest.hpp"
#include "lodlab/core/frame/schedule.hpp"
#include "lodlab/core/frame/sweep.hpp"
#include "lodlab/core/response/response.hpp"
#include "lodlab/core/tree/budget.hpp"

namespace lod {

/// What a frame found of one candidate pair; the lists that it points into are the record's.
struct PairRecord {
    CandidatePair bodies;
    int level = 0;  ///< last finished level
    Verdict verdict = Verdict::possible;
    std::uint64_t tests = 0;
    std::int32_t first_contact = 0;  ///< into impacts, impulses and contact_nodes
    std::int32_t contact_count = 0;
    Range nodes;  ///< into node_pairs: the overlapping nodes that nothing proved apart
    /// Beyond leaves: `level` is the leaves', but the verdict and the contacts are those of the
    /// true shapes.
    Finest finest = Finest::leaves;
    double impact_time = 0;  ///< when the true shapes touched, from the frame's instant [s]
};

/// What a frame did with its budget.
struct Spending {
    LevelCounts levels;  ///< beyond the entry ones
    /// Of a quota of node tests, beside what is reserved.
    std::optional<std::uint64_t> tests_left = {};
    /// Of a quota on a clock, at the end of the frame; negative where it was overrun.
    std::optional<std::chrono::nanoseconds> time_left = {};
    /// The same when the levels were done, and what was held back of it then.
    std::optional<AfterLevels> after_levels = {};
};

/// Which levels a frame reached, over the pairs that nothing proved apart: those that it answered.
struct LevelsReached {
    std::size_t pairs = 0;
    int least = -1;   ///< -1: there was none
    double mean = 0;  ///< 0 where there was none
};

/// Every stage's result of one frame. Pictures, lessons, traces and metrics read it and never hook
/// into the solver.
template <int Dim>
struct FrameRecord {
    std::vector<PairRecord> pairs;     ///< every candidate pair of the broad phase
    std::vector<NodePair> node_pairs;  ///< pair by pair, patch by patch
    std::vector<Impact<Dim>> impacts;  ///< the contacts, pair by pair; `pair` indexes `pairs`
    std::vector<Range> contact_nodes;  ///< same order; into node_pairs: the nodes behind each
                                       ///< contact, none behind an exact one
    std::vector<double> impulses;      ///< same order [N s]
    std::uint64_t tests = 0;           ///< node tests of the frame
    /// Where the budget ended before the finest level. A frame that ran on a clock gives the same
    /// bits when it is played again with Budget::until(*cut), unlimited where there is none.
    std::optional<Cut> cut;
    Spending spending;
    /// The levels beyond the entry ones, in the order in which they had their turn; none where
    /// there was no limit.
    std::vector<Turn> turns;
    /// What the response of the finished levels may cost at most, in row visits: the reserve that
    /// Budget holds back as the cost of node pairs. Of Response::net.
    std::uint64_t reserved_row_visits = 0;
    ResponseReport response;   ///< of `advance`
    double energy_before = 0;  ///< kinetic, before the response [J]
    double energy_after = 0;   ///< kinetic, after it [J]
    /// What fast bodies ran into on the way to the next frame, in the order of time.
    std::vector<SweptImpact<Dim>> swept;

    /// Whether the budget ended before the finest level.
    [[nodiscard]] bool interrupted() const { return cut.has_value(); }
    /// Its levels.
    [[nodiscard]] LevelsReached levels_reached() const {
        LevelsReached reached;
        for (const PairRecord& pair : pairs) {
            if (pair.verdict == Verdict::apart) continue;
            ++reached.pairs;
            reached.mean += pair.level;
            if (reached.least < 0 || pair.level < reached.least) reached.least = pair.level;
        }
        if (reached.pairs > 0) reached.mean /= static_cast<double>(reached.pairs);
        return reached;
    }
    /// The node pairs of a pair or behind a contact.
    [[nodiscard]] std::span<const NodePair> nodes_of(const Range& range) const {
        return range.of(std::span<const NodePair>(node_pairs));
    }
};

}  // namespace lod
