#include "lodlab/core/tree/traversal.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/tree/family_tests.hpp"

namespace lod {

NodePair* FrontList::room_for(std::size_t more) {
    if (room_.size() >= used_ + more) return room_.data() + used_;
    if (used_ + more > most)
        throw Error(ErrorKind::limit_exceeded,
                    "more than " + std::to_string(most) +
                        " pairs of nodes overlap at once, more than a frame takes; give it a quota "
                        "or a level, or move the bodies apart");
    room_.resize(std::max(used_ + more, std::min(most, 2 * room_.size())));
    return room_.data() + used_;
}

void FrontList::replace(ListedFront& front, std::size_t begin) {
    const auto first = static_cast<std::size_t>(front.pairs.first);
    const std::size_t count = used_ - begin;
    if (first + static_cast<std::size_t>(front.pairs.count) == begin) {
        std::copy_n(room_.begin() + static_cast<std::ptrdiff_t>(begin), count,
                    room_.begin() + static_cast<std::ptrdiff_t>(first));
        begin = first;
        used_ = first + count;
    }
    front.pairs = {static_cast<std::int32_t>(begin), static_cast<std::int32_t>(count)};
}

namespace {

/// Between two questions to the budget at most so many tests are done.
constexpr std::int32_t most_between_questions = 512;
/// Where there is no question, so many tests of one pair of families; each may need room in a list.
constexpr std::int32_t most_at_once = 4096;

void conclude(ListedFront& front, bool any_leaf_pair, bool any_children) {
    ++front.level;
    front.finest = !any_children;
    if (front.pairs.count == 0)
        front.verdict = Verdict::apart;
    else
        front.verdict = any_leaf_pair ? Verdict::true_collision : Verdict::possible;
}

/// The distance test of a half-space and a ball.
template <int Dim>
bool meets_border(const HalfSpace<Dim>& half_space, const Sphere<Dim>& ball, double slack) {
    return half_space.side(ball.centre) <= ball.radius + 2 * slack;
}

/// One level in the making, or one after the other of the same two bodies.
template <int Dim>
class Level {
  public:
    /// What is found is appended to the list. `reserved`: node pairs of the front that the budget
    /// reserves already.
    Level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, Budget* budget, FrontList& list,
          std::size_t reserved)
        : a_(a),
          b_(b),
          budget_(budget != nullptr && budget->is_unlimited() ? nullptr : budget),
          list_(list),
          reserved_(reserved) {}

    /// Makes what is found from now on another level, behind all that the list holds.
    void begin_next() {
        begin_ = list_.size();
        tests_ = 0;
        eldest_a_ = detail::FamilyPair::none;
        eldest_b_ = detail::FamilyPair::none;
    }

    /// All of the level, or false where the budget ended before it was done. By number: the list
    /// may move while it grows.
    bool expand_all(const ListedFront& front) {
        const bool done = a_.is_half_space() || b_.is_half_space() ? expand_border(front)
                                                                   : expand_families(front);
        return done && (budget_ == nullptr || budget_->keeps_level(more_pairs()));
    }

    /// Whether all that was tested were leaves, for only leaves come after the last node with
    /// children, the parent of the last node.
    [[nodiscard]] bool only_leaves() const {
        return eldest_a_ > a_.tree().parent.back() && eldest_b_ > b_.tree().parent.back();
    }
    /// Where in the list it begins.
    [[nodiscard]] std::size_t begin() const { return begin_; }
    /// Node tests done.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }

  private:
    using Families = detail::FamilyTests<Dim>;

    [[nodiscard]] std::uint64_t more_pairs() const {
        const std::size_t found = list_.size() - begin_;
        return found > reserved_ ? found - reserved_ : 0;
    }

    /// Asks the budget for so many tests. Returns false when it ended.
    bool pay(std::int32_t wanted) {
        const auto asked = static_cast<std::uint64_t>(wanted);
        const bool is_free = wanted == 0 || budget_ == nullptr;
        const std::uint64_t granted = is_free ? asked : budget_->grant(asked, more_pairs());
        tests_ += granted;
        return granted == asked;
    }

    [[nodiscard]] NodePair pair_of(const ListedFront& front, std::size_t i) const {
        return list_.pairs_of(front)[i];
    }

    /// A half-space, the only node of one tree, against the other's nodes.
    bool expand_border(const ListedFront& front) {
        const PosedTree<Dim>& many = a_.is_half_space() ? b_ : a_;
        const HalfSpace<Dim> border = a_.is_half_space() ? a_.half_space() : b_.half_space();
        const double slack = a_.rounding() + b_.rounding();
        for (std::size_t i = 0; i < list_.pairs_of(front).size(); ++i) {
            const NodePair pair = pair_of(front, i);
            const std::int32_t parent = a_.is_half_space() ? pair.b : pair.a;
            const std::int32_t count = many.tree().child_count[static_cast<std::size_t>(parent)];
            const std::int32_t first = many.tree().first_child[static_cast<std::size_t>(parent)];
            if (!pay(count)) return false;
            std::int32_t& eldest = a_.is_half_space() ? eldest_b_ : eldest_a_;
            if (count > 0) eldest = std::min(eldest, first);
            NodePair* out = list_.room_for(static_cast<std::size_t>(count) + 1);
            std::size_t n = 0;
            if (count == 0) out[n++] = pair;
            for (std::int32_t node = first; node < first + count; ++node) {
                out[n] = a_.is_half_space() ? NodePair{0, node} : NodePair{node, 0};
                n += meets_border(border, many.sphere(node), slack);
            }
            list_.take(n);
        }
        return true;
    }

    bool expand_families(const ListedFront& front) {
        const bool unlimited = budget_ == nullptr;
        const auto count = static_cast<std::size_t>(front.pairs.count);
        for (std::size_t i = 0; i < count;) {
            std::size_t some = std::min(count - i, pairs_at_once);
            if (!unlimited) {
                const auto [small, wanted] = next_few(list_.pairs_of(front).subspan(i, some));
                if (small > 0 && !pay(wanted)) return false;
                some = std::max<std::size_t>(small, 1);
            }
            NodePair* const out =
                list_.room_for(some * detail::room_of_small + detail::room_beyond);
            const detail::FamiliesTested done =
                kernel_.of_pairs(families_, list_.pairs_of(front).data() + i, some, out);
            note(done);
            if (unlimited) tests_ += done.tests;
            i += done.node_pairs;
            if (done.node_pairs < some && !test_large(pair_of(front, i++))) return false;
        }
        return true;
    }

    /// How many of the next pairs have small families and, all together, no more tests than are
    /// done between two questions; and these tests.
    std::pair<std::size_t, std::int32_t> next_few(std::span<const NodePair> pairs) const {
        std::int32_t tests = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const detail::FamilyPair next = families_.families_of(pairs[i]);
            const std::int32_t more = next.count_a * next.count_b;
            if (std::max(next.count_a, next.count_b) > detail::small_family ||
                tests + more > most_between_questions)
                return {i, tests};
            tests += more;
        }
        return {pairs.size(), tests};
    }

    void note(const detail::FamiliesTested& done) {
        list_.take(done.found);
        eldest_a_ = std::min(eldest_a_, done.eldest_a);
        eldest_b_ = std::min(eldest_b_, done.eldest_b);
    }

    /// Families that are not small, part by part, in the order of their node pairs. Returns false
    /// where the budget ended.
    bool test_large(const NodePair& nodes) {
        const std::int32_t most = budget_ == nullptr ? most_at_once : most_between_questions;
        const detail::FamilyPair pair = families_.families_of(nodes);
        const bool whole = pair.count_b <= most && pair.count_a <= most / pair.count_b;
        const std::int32_t rows = whole ? pair.count_a : pair.count_b == 1 ? most : 1;
        for (std::int32_t i = 0; i < pair.count_a; i += rows)
            for (std::int32_t k = 0; k < pair.count_b; k += most) {
                detail::FamilyPair part = pair;
                part.at_a += i;
                part.at_b += k;
                part.first_a += i;
                part.first_b += k;
                part.count_a = std::min(rows, pair.count_a - i);
                part.count_b = std::min(most, pair.count_b - k);
                const std::int32_t wanted = part.count_a * part.count_b;
                if (!pay(wanted)) return false;
                NodePair* const out =
                    list_.room_for(static_cast<std::size_t>(wanted) + detail::room_beyond);
                note({1, kernel_.of_families(families_, part, out), 0, part.eldest_a(),
                      part.eldest_b()});
            }
        return true;
    }

    /// So many node pairs are tested before there must be more room in the list.
    static constexpr std::size_t pairs_at_once = 64;

    const PosedTree<Dim>& a_;
    const PosedTree<Dim>& b_;
    Budget* const budget_;  ///< nothing: without a limit
    FrontList& list_;
    const std::size_t reserved_;
    std::size_t begin_ = list_.size();
    std::uint64_t tests_ = 0;
    const Families families_{a_, b_};
    const detail::FamilyKernel<Dim>& kernel_ =
        families_.serves() ? detail::test_path().kernel<Dim>() : detail::double_kernel<Dim>();
    std::int32_t eldest_a_ =
        detail::FamilyPair::none;  ///< least node tested that may have children
    std::int32_t eldest_b_ = detail::FamilyPair::none;
};

template <int Dim>
bool roots_meet(const PosedTree<Dim>& a, const PosedTree<Dim>& b) {
    const double slack = a.rounding() + b.rounding();
    if (a.is_half_space()) return meets_border(a.half_space(), b.root(), slack);
    if (b.is_half_space()) return meets_border(b.half_space(), a.root(), slack);
    Sphere<Dim> root_a = a.root();
    root_a.radius += slack;
    return overlap(root_a, b.root());
}

}  // namespace

template <int Dim>
void test_roots(const PosedTree<Dim>& a, const PosedTree<Dim>& b, ListedFront& front,
                FrontList& list) {
    front = {};
    front.tests = 1;
    front.pairs.first = static_cast<std::int32_t>(list.size());
    if (roots_meet(a, b)) {
        *list.room_for(1) = {0, 0};
        list.take(1);
        front.pairs.count = 1;
    }
    const bool leaves = a.tree().is_leaf(0) && b.tree().is_leaf(0);
    conclude(front, leaves, front.pairs.count > 0 && !leaves);
}

namespace {

/// Makes a level that is done the front's.
template <int Dim>
void finish(const PosedTree<Dim>& a, const PosedTree<Dim>& b, const Level<Dim>& level,
            ListedFront& front, FrontList& list) {
    list.replace(front, level.begin());
    if (level.only_leaves()) return conclude(front, front.pairs.count > 0, false);
    bool any_leaf_pair = false;
    bool any_children = false;
    for (const NodePair& pair : list.pairs_of(front)) {
        const bool leaves = a.tree().is_leaf(pair.a) && b.tree().is_leaf(pair.b);
        any_leaf_pair |= leaves;
        any_children |= !leaves;
    }
    conclude(front, any_leaf_pair, any_children);
}

}  // namespace

template <int Dim>
Refinement refine(const PosedTree<Dim>& a, const PosedTree<Dim>& b, Budget& budget,
                  ListedFront& front, FrontList& list) {
    Level<Dim> level(a, b, &budget, list, static_cast<std::size_t>(front.pairs.count));
    const bool done = level.expand_all(front);
    front.tests += level.tests();
    if (budget.is_unlimited()) budget.spend(level.tests());
    if (!done) {
        list.shorten(level.begin());
        return Refinement::interrupted;
    }
    finish(a, b, level, front, list);
    return Refinement::finished;
}

template <int Dim>
std::uint64_t refine_to(const PosedTree<Dim>& a, const PosedTree<Dim>& b, int last,
                        ListedFront& front, FrontList& list) {
    if (front.finest || front.level >= last) return 0;
    Level<Dim> level(a, b, nullptr, list, 0);
    for (;;) {
        static_cast<void>(level.expand_all(front));
        front.tests += level.tests();
        finish(a, b, level, front, list);
        if (front.finest || front.level >= last) return level.tests();
        level.begin_next();
    }
}

template <int Dim>
std::vector<Front> traverse_levels(const Body<Dim>& a, const Body<Dim>& b, int deepest) {
    PosedTree<Dim> world_a;
    PosedTree<Dim> world_b;
    world_a.pose(a);
    world_b.pose(b);
    Budget budget = Budget::unlimited();
    FrontList list;
    ListedFront front;
    test_roots(world_a, world_b, front, list);
    std::vector<Front> levels{list.front(front)};
    while (!front.finest && front.level < deepest) {
        if (refine(world_a, world_b, budget, front, list) == Refinement::interrupted) break;
        levels.push_back(list.front(front));
    }
    return levels;
}

namespace {

/// Whether any of these pairs leads to one so many levels further down: the first pairs to their
/// end before the others.
template <int Dim>
bool lead_down(Level<Dim>& level, FrontList& list, const Range& pairs, int levels) {
    if (levels <= 0) return pairs.count > 0;
    /// A family of one would leave most of what the kernel does at once undone.
    constexpr std::int32_t together = 4;
    for (std::int32_t done = 0; done < pairs.count; done += together) {
        const auto begin = static_cast<std::int32_t>(list.size());
        ListedFront some;
        some.pairs = {pairs.first + done, std::min(together, pairs.count - done)};
        static_cast<void>(level.expand_all(some));
        const Range found{begin, static_cast<std::int32_t>(list.size()) - begin};
        if (lead_down(level, list, found, levels - 1)) return true;
        list.shorten(static_cast<std::size_t>(begin));
    }
    return false;
}

}  // namespace

template <int Dim>
bool overlap_at(const PosedTree<Dim>& a, const PosedTree<Dim>& b, int level, FrontList& room) {
    const std::size_t before = room.size();
    ListedFront front;
    test_roots(a, b, front, room);
    Level<Dim> deeper(a, b, nullptr, room, 0);
    const int deepest = std::max(a.tree().levels(), b.tree().levels()) - 1;
    const bool found = lead_down(deeper, room, front.pairs, std::min(level, deepest));
    room.shorten(before);
    return found;
}

#define LOD_INSTANTIATE(Dim)                                                              \
    template void test_roots(const PosedTree<Dim>&, const PosedTree<Dim>&, ListedFront&,  \
                             FrontList&);                                                 \
    template Refinement refine(const PosedTree<Dim>&, const PosedTree<Dim>&, Budget&,     \
                               ListedFront&, FrontList&);                                 \
    template std::uint64_t refine_to(const PosedTree<Dim>&, const PosedTree<Dim>&, int,   \
                                     ListedFront&, FrontList&);                           \
    template std::vector<Front> traverse_levels(const Body<Dim>&, const Body<Dim>&, int); \
    template bool overlap_at(const PosedTree<Dim>&, const PosedTree<Dim>&, int, FrontList&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
