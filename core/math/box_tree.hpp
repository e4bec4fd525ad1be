#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/math/box.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// A tree over many boxes of any sizes, to find those that meet another one.
template <int Dim>
class BoxTree {
  public:
    /// Requires: no empty box.
    explicit BoxTree(std::span<const Box<Dim>> boxes) { build(boxes); }

    /// The tree of other boxes instead. Allocates only where there were never as many.
    /// Requires: no empty box.
    void build(std::span<const Box<Dim>> boxes);

    /// Makes a box hold another one, too.
    void grow(std::size_t number, const Box<Dim>& box);

    struct Node {
        Box<Dim> box;
        std::size_t number = 0;  ///< of a leaf's box
        std::size_t second = 0;  ///< child of an inner node, whose first one follows it; 0: a leaf
    };

    /// Calls visit(i) for every box that meets this one, always in the same order.
    template <class Visit>
    void each_meeting(const Box<Dim>& box, const Visit& visit) {
        (void)walk(box, steps_, [&](std::size_t i) {
            visit(i);
            return false;
        });
    }

    /// Whether test(i) holds for some box that meets this one; asks no further where it does.
    template <class Test>
    [[nodiscard]] bool any_meeting(const Box<Dim>& box, const Test& test) const {
        std::uint64_t steps = 0;
        return walk(box, steps, test);
    }

    /// How many boxes each_meeting and grow have looked at, in all.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

    /// The root first, parents before their children; none without boxes.
    [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }

  private:
    static constexpr std::size_t deepest = 128;  ///< twice the halvings of what an index can count

    void build(std::span<const Box<Dim>> boxes, std::span<std::size_t> chosen);

    template <class Test>
    bool walk(const Box<Dim>& box, std::uint64_t& steps, const Test& test) const {
        if (nodes_.empty()) return false;
        std::array<std::size_t, deepest> open;
        std::size_t count = 0;
        open[count++] = 0;
        while (count > 0) {
            const std::size_t place = open[--count];
            const Node& node = nodes_[place];
            ++steps;
            if (!node.box.meets(box)) continue;
            if (node.second == 0) {
                if (test(node.number)) return true;
                continue;
            }
            open[count++] = node.second;
            open[count++] = place + 1;
        }
        return false;
    }

    std::vector<Node> nodes_;
    std::vector<std::size_t> chosen_;  ///< numbers of boxes in the order of the leaves
    std::vector<std::size_t> rank_;    ///< of each box: its place in that order
    std::uint64_t steps_ = 0;
};

/// Boxes of balls, by some units of rounding wider: where two balls overlap, their boxes meet.
template <int Dim>
[[nodiscard]] std::vector<Box<Dim>> boxes_of(std::span<const Sphere<Dim>> balls);

extern template class BoxTree<2>;
extern template class BoxTree<3>;

}  // namespace lod
