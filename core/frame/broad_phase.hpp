#pragma once

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

/// Sweep and prune in rows: sorts the boxes of the root balls along the first axis, keeping the
/// order from frame to frame, deals them into strips across the second of twice their mean height,
/// and sweeps each strip, so that a slowly moving crowd of bodies of like size costs about linear
/// time in the plane. Allocates nothing once the number of bodies and pairs has been met before.
template <int Dim>
class BroadPhase {
  public:
    /// Finds every pair of bodies, not both static, whose root balls' boxes meet, and
    /// with a half-space every body whose root ball does; sorted by (a, b).
    /// Requires: world_S of every body has been posed.
    void find(std::span<const Body<Dim>> bodies, std::span<const PosedTree<Dim>> world_S,
              std::vector<CandidatePair>& pairs);

  private:
    static void add_pairs(std::int32_t wall, std::span<const Body<Dim>> bodies,
                          std::span<const PosedTree<Dim>> world_S,
                          std::vector<CandidatePair>& pairs);

    void sort_along_first_axis();
    void deal_into_rows(std::span<const Body<Dim>> bodies);
    void sweep(std::size_t row, std::vector<CandidatePair>& pairs) const;
    void sort_pairs(std::size_t bodies, std::vector<CandidatePair>& pairs);

    struct Entry {
        Box<Dim> box;
        std::int32_t body = 0;
        bool is_static = false;
    };
    std::vector<Box<Dim>> boxes_;
    std::vector<std::int32_t> half_spaces_;
    std::vector<std::int32_t> order_;  ///< bodies by the low end of their box
    /// Equal strips across the second axis.
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
};

extern template class BroadPhase<2>;
extern template class BroadPhase<3>;

}  // namespace lod
