#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lodlab/core/broad/body_box.hpp"
#include "lodlab/core/broad/candidate_pair.hpp"
#include "lodlab/core/math/box_tree.hpp"

namespace lod {

/// What stands still: its boxes in a tree that is built once. A body that is much larger than those
/// that move is there as the boxes of its nodes at a coarse level, for the root ball of a wall
/// covers the room; where none of a level's nodes meets the ball that holds another body, the two
/// are proved apart. One of like size is there as its root ball.
template <int Dim>
class StaticBodies {
  public:
    /// A body's boxes are those of the first level at which no node with children is so many times
    /// as large as the largest root ball that moves ...
    static constexpr double much_larger = 4;
    /// ... and never of a level of more nodes.
    static constexpr int most_nodes = 64;

    /// Takes over these bodies. Builds the tree anew only where one of them has come, gone, moved
    /// or taken another tree, or where `largest`, the radius of the largest root ball that moves
    /// [m], is another. Requires: each has been posed and is no half-space.
    void update(std::span<const std::int32_t> numbers, std::span<const Body<Dim>> bodies,
                std::span<const PosedTree<Dim>> world_S, double largest);

    /// Appends the pairs of a body that moves with those whose root's box and one of whose nodes'
    /// boxes meets its own, in no order.
    void find(const BodyBox<Dim>& mover, std::vector<CandidatePair>& pairs);

    /// How many boxes `find` has looked at, in all.
    [[nodiscard]] std::uint64_t steps() const { return boxes_.steps(); }
    /// How often the tree has been built.
    [[nodiscard]] int built() const { return built_; }

  private:
    struct Standing {
        std::int32_t body = 0;
        std::shared_ptr<const SphereTree<Dim>> tree;
        Matrix<Dim> rotation = Matrix<Dim>::Identity();
        Vector<Dim> position = Vector<Dim>::Zero();
        Box<Dim> root;
        std::uint64_t met_by = 0;  ///< the last find() that met it
    };

    [[nodiscard]] bool stand_as_before(std::span<const std::int32_t> numbers,
                                       std::span<const Body<Dim>> bodies,
                                       std::span<const PosedTree<Dim>> world_S) const;
    void add(std::int32_t body, std::span<const Body<Dim>> bodies);

    double largest_ = 0;
    std::vector<Standing> standing_;
    std::vector<Box<Dim>> node_boxes_;
    std::vector<std::size_t> owner_;  ///< of each: into standing_
    BoxTree<Dim> boxes_{std::span<const Box<Dim>>()};
    PosedTree<Dim> posed_;
    std::uint64_t finds_ = 0;
    int built_ = 0;
};

extern template class StaticBodies<2>;
extern template class StaticBodies<3>;

}  // namespace lod
