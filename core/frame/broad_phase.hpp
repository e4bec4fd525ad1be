#pragma once

/// \file
/// Which pairs of bodies are near enough to be looked at.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/broad/box_grid.hpp"
#include "lodlab/core/broad/static_bodies.hpp"
#include "lodlab/core/tree/posed_tree.hpp"

namespace lod {

/// Finds the pairs of bodies that are near, anew in every frame. What moves lies in a grid
/// (BoxGrid), what stands still in a tree that is built once (StaticBodies), and a half-space is
/// compared with each body that moves.
///
/// Bodies of like size that move cost linear time in their number and that of the pairs, for they
/// cannot crowd without meeting: in a row, a sheet or a cube, moving or jumping, however far some
/// of them are. Sizes from 1 to 1,000 cost two to four times as much. Static bodies add log n for
/// each body that moves, and n log n in a frame in which one of them comes, goes, moves or takes
/// another tree. It costs more only where heaps of bodies overlap beside others, of another size,
/// that do not meet them. No step depends on the frames before, but for the static bodies' tree.
/// Allocates nothing once the number of bodies and pairs has been met before.
template <int Dim>
class BroadPhase {
  public:
    /// Finds every pair of bodies, not both static, whose root balls' boxes meet; with a static
    /// body much larger than those that move (StaticBodies) only where a box of its nodes at a
    /// coarse level meets the root ball's box, too; with a half-space every body whose root ball
    /// does; sorted by (a, b). What is not found is proved apart, rounding included; but a body
    /// that is further than 1e300 m away, or nowhere, meets none. `executor`: whose threads compare
    /// boxes. Throws lod::Error, limit exceeded, beyond most_candidates. Requires: world_S of every
    /// body has been posed.
    void find(std::span<const Body<Dim>> bodies, std::span<const PosedTree<Dim>> world_S,
              std::vector<CandidatePair>& pairs, Executor* executor = nullptr);
    /// How many comparisons of boxes and half-spaces the last `find` took; without those that build
    /// the tree of static bodies, and without the sorting of cells and pairs.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    void sort_out(std::span<const Body<Dim>> bodies, std::span<const PosedTree<Dim>> world_S);
    void add_half_spaces(std::span<const PosedTree<Dim>> world_S, Executor* executor,
                         std::vector<CandidatePair>& pairs);
    void meet_half_spaces(std::span<const BodyBox<Dim>> movers,
                          std::span<const PosedTree<Dim>> world_S,
                          std::vector<CandidatePair>& pairs) const;
    void sort_pairs(std::size_t bodies, std::vector<CandidatePair>& pairs);

    std::vector<BodyBox<Dim>> movers_;
    double largest_ = 0;  ///< radius of a root ball that moves [m]
    std::vector<std::int32_t> half_spaces_;
    std::vector<std::vector<CandidatePair>> at_half_spaces_;  ///< one list a worker
    std::vector<std::int32_t> static_;
    BoxGrid<Dim> grid_;
    StaticBodies<Dim> static_bodies_;
    std::vector<std::int32_t> begin_;  ///< of each body: where the pairs begin whose first it is
    std::vector<CandidatePair> unsorted_;
    std::uint64_t steps_ = 0;
};

extern template class BroadPhase<2>;
extern template class BroadPhase<3>;

}  // namespace lod
