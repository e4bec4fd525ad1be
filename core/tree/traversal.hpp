#pragma once

/// \file
/// Two trees against each other, level by level, interruptible between any two node tests: the
/// heart of the method.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/names.hpp"
#include "lodlab/core/tree/budget.hpp"
#include "lodlab/core/tree/posed_tree.hpp"

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
/// Their words in messages and results.
[[nodiscard]] constexpr std::array<std::string_view, 3> names_of(Verdict) {
    return {"apart", "possible", "true"};
}
static_assert(names_of(Verdict{}).size() == static_cast<std::size_t>(Verdict::true_collision) + 1);

/// How far one body pair was refined.
struct FrontState {
    int level = -1;  ///< the last finished one; -1 before the roots were tested
    Verdict verdict = Verdict::possible;
    bool finest = false;      ///< no node pair has children left to test
    std::uint64_t tests = 0;  ///< node tests spent on this pair, an unfinished level's included
};

/// The overlapping node pairs of one body pair at its last finished level.
struct Front : FrontState {
    std::vector<NodePair> pairs;
};

/// The same, its pairs being a part of a list that holds those of many fronts.
struct ListedFront : FrontState {
    Range pairs;            ///< into FrontList::pairs
    std::int32_t list = 0;  ///< of several: which one
    bool by_roots = false;  ///< its bodies touch as their root balls do
};

/// The node pairs of many fronts in one list, whatever their number and sizes: a crowd that moves
/// allocates only where it needs more room than ever before.
class FrontList {
  public:
    /// Forgets all fronts.
    void clear() { used_ = 0; }
    /// The node pairs of one of them.
    [[nodiscard]] std::span<const NodePair> pairs_of(const ListedFront& front) const {
        return front.pairs.of(std::span<const NodePair>(room_));
    }

    /// One of them with a list of its own.
    [[nodiscard]] Front front(const ListedFront& listed) const {
        const auto pairs = pairs_of(listed);
        return {listed, {pairs.begin(), pairs.end()}};
    }

    /// Room for `more` pairs behind the last one; what is written there counts once it is taken.
    /// Throws Error (limit exceeded) where that makes more than `most`.
    [[nodiscard]] NodePair* room_for(std::size_t more);
    /// Makes that many of the pairs written last count.
    void take(std::size_t count) { used_ += count; }
    /// Pairs of all fronts.
    [[nodiscard]] std::size_t size() const { return used_; }
    /// Node pairs of a frame, at most: 2 GB.
    static constexpr std::size_t most = std::size_t{1} << 28;
    /// Forgets all from there on.
    void shorten(std::size_t size) { used_ = size; }
    /// Makes what lies from `begin` on a front's pairs. Where its old ones lie right before them,
    /// they are overwritten.
    void replace(ListedFront& front, std::size_t begin);

  private:
    std::vector<NodePair> room_;
    std::size_t used_ = 0;
};

/// How a try to refine by one level ended.
enum class Refinement {
    finished,     ///< the front stands one level deeper
    interrupted,  ///< the budget ended within the level; the front is as it was
};

/// Level 0: the distance test of the two roots. Appends to the list.
template <int Dim>
void test_roots(const PosedTree<Dim>& a, const PosedTree<Dim>& b, ListedFront& front,
                FrontList& list);

/// Tests the next level of one body pair: all children of every overlapping node pair, a leaf
/// against the other side's children, two leaves carried on untested. Stops between any two node
/// tests when the budget ends, and then leaves nothing behind but the count of tests. A level that
/// finds more node pairs than the budget can still pay for counts as interrupted, too: those of
/// `front` are taken to be reserved already (Budget::reserve). Requires: front.level >= 0 and not
/// front.finest.
template <int Dim>
[[nodiscard]] Refinement refine(const PosedTree<Dim>& a, const PosedTree<Dim>& b, Budget& budget,
                                ListedFront& front, FrontList& list);

/// The same level after level, without a limit, up to `last` or to the finest. Returns the node
/// tests of the last one that was made; 0 where there was none to make.
template <int Dim>
std::uint64_t refine_to(const PosedTree<Dim>& a, const PosedTree<Dim>& b, int last,
                        ListedFront& front, FrontList& list);

/// Whether any nodes of two bodies' trees overlap at a level, deeper ones counting as the deepest:
/// the verdict of refine's front there, `apart` or not, but by the first pair that is found. `room`
/// is left as it was.
template <int Dim>
[[nodiscard]] bool overlap_at(const PosedTree<Dim>& a, const PosedTree<Dim>& b, int level,
                              FrontList& room);

/// Every level of one body pair, from the roots to the finest (or to `deepest`), for pictures,
/// lessons and oracles: entry k is the front at level k.
template <int Dim>
[[nodiscard]] std::vector<Front> traverse_levels(const Body<Dim>& a, const Body<Dim>& b,
                                                 int deepest = 1000);

}  // namespace lod
