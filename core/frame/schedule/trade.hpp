#pragma once

/// \file
/// Levels exchanged between pairs from one frame to the next: what Priority::trade goes by.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/frame/broad_phase.hpp"

namespace lod {

/// The level that a candidate pair reached in a frame, what it was worth, and what the next would
/// have been.
struct HeldLevel {
    CandidatePair bodies;
    std::int32_t level = 0;
    std::uint64_t last_tests =
        0;  ///< node tests that its last level took; 0: it cannot be given up
    std::uint64_t next_tests = 0;  ///< that the next one would take; 0: there is none
    double last_fall = 0;          ///< of the error, by the last level [m]
    double next_fall = 0;          ///< and by the next
};

/// Trading levels, after the idea of the LOD Trader (Sunshine-Hill 2011): a frame begins with the
/// levels that its pairs held in the last one, and lets pairs give up their last level for the next
/// one of others while the error falls by more than it grows and the tests that are freed pay for
/// those that are bought. The cheapest give, those with the largest fall a test take; at most
/// `most_trades` of each, so that n pairs take n steps. What the trade expects is what the last
/// frame found; what each pair really gets, the budget decides.
class Trade {
  public:
    /// The level that each pair should reach before any other goes beyond its own; -1 for pairs
    /// that the last frame did not have. Requires: `pairs` are sorted by (a, b).
    void plan(std::span<const CandidatePair> pairs, std::vector<std::int32_t>& targets);

    /// What pairs held in the last frame, in the order of the pairs; for a frame that is to go on
    /// from there, as after loading, set what was saved.
    std::vector<HeldLevel> held;

    /// How many trades the last plan made.
    [[nodiscard]] int trades() const { return trades_; }

    static constexpr std::size_t most_trades = 64;

  private:
    /// One side of a trade.
    struct Side {
        double fall_a_test = 0;
        double fall = 0;
        std::uint64_t tests = 0;
        std::int32_t pair = 0;
    };
    void collect(std::span<const CandidatePair> pairs, std::vector<std::int32_t>& targets);
    bool buy(const Side& buyer, std::size_t& next_seller, std::vector<std::int32_t>& targets);

    std::vector<Side> sellers_;  ///< the least fall a test first
    std::vector<Side> buyers_;   ///< the most first
    std::vector<char> traded_;   ///< of each pair
    int trades_ = 0;
};

}  // namespace lod
