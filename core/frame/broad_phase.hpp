#pragma once

/// \file
/// Which pairs of bodies are near enough to be looked at.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/math/box.hpp"
#include "lodlab/core/tree/posed_tree.hpp"

namespace lod {

/// Two bodies that the broad phase could not tell apart; a < b.
struct CandidatePair {
    std::int32_t a = 0;
    std::int32_t b = 0;
    friend bool operator==(const CandidatePair&, const CandidatePair&) = default;
};

/// Sweep and prune in rows: sorts the boxes of the root balls along the axis on which they spread
/// widest, keeping the order from frame to frame, deals them into strips across the next widest of
/// twice their mean height, and sweeps each strip, so that a slowly moving crowd of bodies of like
/// size costs about linear time in the plane, and in space where they lie in a row or a sheet.
/// Allocates nothing once the number of bodies and pairs has been met before.
template <int Dim>
class BroadPhase {
  public:
    /// Finds every pair of bodies, not both static, whose root balls' boxes meet, and
    /// with a half-space every body whose root ball does; sorted by (a, b).
    /// Requires: world_S of every body has been posed.
    void find(std::span<const Body<Dim>> bodies, std::span<const PosedTree<Dim>> world_S,
              std::vector<CandidatePair>& pairs);
    /// How many pairs of boxes the last `find` compared, for the order and in the sweep; without
    /// those of std::sort, which puts boxes in order that come in none.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    static void add_pairs(std::int32_t wall, std::span<const Body<Dim>> bodies,
                          std::span<const PosedTree<Dim>> world_S,
                          std::vector<CandidatePair>& pairs);

    void choose_axes(const Box<Dim>& all);
    void sort_along_sweep();
    bool insert_in_order();
    void deal_into_rows(std::span<const Body<Dim>> bodies, const Box<Dim>& all);
    void sweep(std::size_t row, std::vector<CandidatePair>& pairs);
    void sort_pairs(std::size_t bodies, std::vector<CandidatePair>& pairs);

    struct Entry {
        Box<Dim> box;
        std::int32_t body = 0;
        bool is_static = false;
    };
    std::vector<Box<Dim>> boxes_;
    std::vector<std::int32_t> half_spaces_;
    int along_ = 0;                    ///< axis of the sweep
    int across_ = 1;                   ///< axis of the rows
    std::vector<std::int32_t> order_;  ///< bodies by the low end of their box along the sweep
    bool in_order_ = false;            ///< order_ stems from a frame of as many boxes, same axis
    /// Equal strips across the other axis.
    struct Rows {
        std::size_t count = 1;
        double low = 0;
        double height = 0;
        [[nodiscard]] std::size_t of(double y) const {
            if (!(y > low) || !(height > 0)) return 0;
            const double row = (y - low) / height;
            return row < static_cast<double>(count) ? static_cast<std::size_t>(row) : count - 1;
        }
    };
    static constexpr double most_rows = 4096;
    Rows rows_;
    std::vector<std::int32_t> row_begin_;  ///< of each row, into entries_
    std::vector<Entry> entries_;
    std::vector<std::int32_t> begin_;  ///< of each body: where the pairs begin whose first it is
    std::vector<CandidatePair> unsorted_;
    std::uint64_t steps_ = 0;
};

extern template class BroadPhase<2>;
extern template class BroadPhase<3>;

}  // namespace lod
