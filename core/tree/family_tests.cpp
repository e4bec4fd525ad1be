#include "lodlab/core/tree/family_tests.hpp"

#include <algorithm>
#include <atomic>

namespace lod::detail {
namespace {

/// Sizes whose squares, and the squares of whose rounding, single precision holds [m].
constexpr double least_size = 0x1p-32;
constexpr double most_size = 0x1p32;
/// Bound of all rounding of a test in single precision, in parts of the size: in units of
/// u = 2^-24, the carried centre 4 of the shift and 11 of B's extent, A's centre 1, the sum of the
/// radii 4, the squares and their sums 16 of the reach.
constexpr double single_rounding = 0x1p-19;

}  // namespace

template <int Dim>
FamilyTests<Dim>::FamilyTests(const PosedTree<Dim>& a, const PosedTree<Dim>& b)
    : a_(a), b_(b), slack_(a.rounding() + b.rounding()) {
    const auto copied = [](const SphereTree<Dim>& tree) {
        return tree.single.size() ==
               static_cast<std::size_t>(tree.size()) * (Dim + 1) + SphereTree<Dim>::single_room;
    };
    const auto [turn, shift] = seen_from(a.placement(), b.placement());
    const double size = shift.norm() + a.tree().extent + b.tree().extent;
    serves_ = size >= least_size && size <= most_size && copied(a.tree()) && copied(b.tree());
    if (!serves_) return;
    for (int row = 0; row < Dim; ++row) {
        shift_[row] = static_cast<float>(shift[row]);
        for (int column = 0; column < Dim; ++column)
            turn_[row * Dim + column] = static_cast<float>(turn(row, column));
    }
    // The slack bounds the rounding of the test in double precision, and that of turn and shift.
    const double rounding = single_rounding * size + 3 * slack_;
    reach_ = static_cast<float>(slack_ + rounding);
    doubt_ = static_cast<float>(4.001 * rounding);
}

template <int Dim>
bool FamilyTests<Dim>::meet_exactly(std::int32_t a, std::int32_t b, bool leaf_b) const {
    const Sphere<Dim> ball_a = a_.sphere(a);
    const Sphere<Dim> ball_b = b_.sphere(b);
    double squared = 0;
    for (int axis = 0; axis < Dim; ++axis) {
        const double between = ball_b.centre[axis] - ball_a.centre[axis];
        squared += between * between;
    }
    const double reach = leaf_b ? ball_a.radius + (ball_b.radius + slack_)
                                : ball_b.radius + (ball_a.radius + slack_);
    return squared <= reach * reach;
}

template <int Dim>
FamilyPair FamilyTests<Dim>::with_leaf(const NodePair& nodes) const {
    struct Family {
        std::ptrdiff_t at;
        std::int32_t first;
        std::int32_t count;
        std::int32_t stride;
    };
    const auto family = [](const SphereTree<Dim>& tree, std::int32_t node) -> Family {
        const auto n = static_cast<std::size_t>(node);
        const std::int32_t count = tree.child_count[n];
        if (count > 0) {
            const std::int32_t first = tree.first_child[n];
            return {std::ptrdiff_t{first} * (Dim + 1), first, count, count};
        }
        const std::int32_t parent = tree.parent[n];
        if (parent < 0) return {0, 0, 1, 1};
        const std::int32_t eldest = tree.first_child[static_cast<std::size_t>(parent)];
        return {std::ptrdiff_t{eldest} * (Dim + 1) + (node - eldest), node, 1,
                tree.child_count[static_cast<std::size_t>(parent)]};
    };
    const Family a = family(a_.tree(), nodes.a);
    const Family b = family(b_.tree(), nodes.b);
    FamilyPair pair{};
    pair.at_a = a.at;
    pair.at_b = b.at;
    pair.first_a = a.first;
    pair.first_b = b.first;
    pair.stride_a = a.stride;
    pair.stride_b = b.stride;
    pair.leaf_a = a_.tree().is_leaf(nodes.a);
    pair.leaf_b = b_.tree().is_leaf(nodes.b);
    if (pair.leaf_a && pair.leaf_b) return pair;
    pair.count_a = a.count;
    pair.count_b = b.count;
    return pair;
}

namespace {

template <int Dim>
std::size_t families_in_double(const FamilyTests<Dim>& tests, const FamilyPair& pair,
                               NodePair* out) {
    NodePair* const begin = out;
    if (pair.count_a == 0) *out++ = {pair.first_a, pair.first_b};
    for (std::int32_t a = pair.first_a; a < pair.first_a + pair.count_a; ++a)
        for (std::int32_t b = pair.first_b; b < pair.first_b + pair.count_b; ++b) {
            *out = {a, b};
            out += tests.meet_exactly(a, b, pair.leaf_b);
        }
    return static_cast<std::size_t>(out - begin);
}

template <int Dim>
FamiliesTested pairs_in_double(const FamilyTests<Dim>& tests, const NodePair* pairs,
                               std::size_t count, NodePair* out) {
    FamiliesTested done;
    for (; done.node_pairs < count; ++done.node_pairs) {
        const FamilyPair pair = tests.families_of(pairs[done.node_pairs]);
        if (std::max(pair.count_a, pair.count_b) > small_family) break;
        done.found += families_in_double(tests, pair, out + done.found);
        done.tests += static_cast<std::uint64_t>(pair.count_a * pair.count_b);
        done.eldest_a = std::min(done.eldest_a, pair.eldest_a());
        done.eldest_b = std::min(done.eldest_b, pair.eldest_b());
    }
    return done;
}

std::atomic<const TestPath*>& taken() {
    static std::atomic<const TestPath*> path = &test_paths().front();
    return path;
}

}  // namespace

template <int Dim>
const FamilyKernel<Dim>& double_kernel() {
    static constexpr FamilyKernel<Dim> kernel{pairs_in_double<Dim>, families_in_double<Dim>};
    return kernel;
}

const std::vector<TestPath>& test_paths() {
    static const std::vector<TestPath> paths = compiled_paths();
    return paths;
}

const TestPath& test_path() {
    return *taken().load(std::memory_order_relaxed);
}

void take_path(const TestPath& path) {
    taken().store(&path, std::memory_order_relaxed);
}

#define LOD_INSTANTIATE(Dim)         \
    template class FamilyTests<Dim>; \
    template const FamilyKernel<Dim>& double_kernel();
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod::detail
