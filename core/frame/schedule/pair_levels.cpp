#include <algorithm>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/frame/schedule.hpp"

namespace lod {

template <int Dim>
int entry_level(const PosedTree<Dim>& a, const PosedTree<Dim>& b, bool by_hulls) {
    // Nothing of a half-space fits into a hollow.
    if (a.is_half_space() || b.is_half_space()) return 0;
    if (!by_hulls || !a.tree().has_hulls() || !b.tree().has_hulls()) return 0;
    return std::max(a.tree().hulls.entry_level, b.tree().hulls.entry_level);
}

template <int Dim>
std::uint64_t next_level_tests(const SphereTree<Dim>& a, const SphereTree<Dim>& b,
                               std::span<const NodePair> front) {
    std::uint64_t tests = 0;
    for (const NodePair& pair : front) {
        const std::int32_t children_a = a.child_count[at(pair.a)];
        const std::int32_t children_b = b.child_count[at(pair.b)];
        if (children_a == 0 && children_b == 0) continue;
        tests += static_cast<std::uint64_t>(std::max(children_a, 1)) *
                 static_cast<std::uint64_t>(std::max(children_b, 1));
    }
    return tests;
}

#define LOD_INSTANTIATE(Dim)                                                                \
    template int entry_level(const PosedTree<Dim>&, const PosedTree<Dim>&, bool);           \
    template std::uint64_t next_level_tests(const SphereTree<Dim>&, const SphereTree<Dim>&, \
                                            std::span<const NodePair>);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
