#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/box.hpp"
#include "lodlab/core/posed_tree.hpp"

namespace lod {

/// Two bodies that the broad phase could not tell apart; a < b.
struct CandidatePair {
    std::int32_t a = 0;
    std::int32_t b = 0;
    friend bool operator==(const CandidatePair&, const CandidatePair&) = default;
};

/// Sweep and prune: sorts the boxes of the root balls along the first axis, keeping the order from
/// frame to frame, so that a slowly moving scene costs about linear time. Allocates nothing once
/// the number of bodies and pairs has been met before.
template <int Dim>
class BroadPhase {
  public:
    /// Finds every pair of bodies, not both static, whose root balls' boxes meet, sorted by (a, b).
    /// Requires: world_S of every body has been posed.
    void find(std::span<const Body<Dim>> bodies, std::span<const PosedTree<Dim>> world_S,
              std::vector<CandidatePair>& pairs);

  private:
    std::vector<Box<Dim>> boxes_;
    std::vector<std::int32_t> order_;  ///< bodies by the low end of their box
};

extern template class BroadPhase<2>;
extern template class BroadPhase<3>;

}  // namespace lod
