#pragma once

#include <cstdint>
#include <vector>

#include "lodlab/core/budget.hpp"
#include "lodlab/core/posed_tree.hpp"

namespace lod {

/// A node of body A's tree and a node of body B's tree that overlap.
struct NodePair {
    std::int32_t a = 0;
    std::int32_t b = 0;
    friend bool operator==(const NodePair&, const NodePair&) = default;
};

/// What a finished level says of two bodies (section 3).
enum class Verdict {
    apart,           ///< no nodes overlap: proof that the bodies do not touch
    possible,        ///< nodes overlap, none of them leaf with leaf
    true_collision,  ///< leaves overlap
};

/// The overlapping node pairs of one body pair at its last finished level.
struct Front {
    int level = -1;  ///< -1 before the roots were tested
    Verdict verdict = Verdict::possible;
    bool finest = false;  ///< no node pair has children left to test
    std::vector<NodePair> pairs;
    std::uint64_t tests = 0;  ///< node tests spent on this pair, an unfinished level's included

    void clear();
};

enum class Refinement {
    finished,     ///< the front stands one level deeper
    interrupted,  ///< the budget ended within the level; the front is as it was
};

/// Level 0: the distance test of the two roots.
template <int Dim>
void test_roots(const PosedTree<Dim>& a, const PosedTree<Dim>& b, Front& front);

/// Tests the next level of one body pair: all children of every overlapping node pair, a leaf
/// against the other side's children, two leaves carried on untested. Stops between any two node
/// tests when the budget ends, and then leaves nothing behind but the count of tests. A level that
/// finds more contacts than the budget can still resolve counts as interrupted, too: the contacts
/// of `front` are taken to be reserved already (Budget::reserve_contacts). `scratch` is storage
/// that the caller keeps. Requires: front.level >= 0 and not front.finest.
template <int Dim>
[[nodiscard]] Refinement refine(PosedTree<Dim>& a, PosedTree<Dim>& b, Budget& budget, Front& front,
                                std::vector<NodePair>& scratch);

/// Every level of one body pair, from the roots to the finest (or to `deepest`), for pictures,
/// lessons and oracles: entry k is the front at level k.
template <int Dim>
[[nodiscard]] std::vector<Front> traverse_levels(const Body<Dim>& a, const Body<Dim>& b,
                                                 int deepest = 1000);

}  // namespace lod
