#pragma once

/// \file
/// The policies of scheduling: which pair's next level comes first.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/tree/body.hpp"

namespace lod {

/// Which pair's next level is made first. Ties go to the pair of lower body numbers.
enum class Priority {
    level_order,    ///< level by level, all pairs one level before any goes to the next (Hubbard)
    closing_speed,  ///< the same; within a level faster approach of the two centres of mass first:
                    ///< their errors move furthest
    first_come,     ///< each pair to its end before the next one begins
    perceptual,     ///< the largest fall of the error, as an observer sees it (Viewer), a node test
    best_gain,      ///< the largest fall of the error (SphereTree::level_error) a node test
    trade,          ///< the levels of the last frame, exchanged while that gains; then best_gain
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 6> names_of(Priority) {
    return {"level_order", "closing_speed", "first_come", "perceptual", "best_gain", "trade"};
}
static_assert(names_of(Priority{}).size() == static_cast<std::size_t>(Priority::trade) + 1);

/// The policy of that name, or of the name that it had before; nothing where none has it.
template <>
[[nodiscard]] constexpr std::optional<Priority> named<Priority>(std::string_view name) {
    if (name == "in_order") return Priority::level_order;
    return listed<Priority>(name);
}

/// The next level of a candidate pair, as a policy of one's own is asked for its value.
template <int Dim>
struct LevelOffer {
    const Body<Dim>& a;
    const Body<Dim>& b;
    std::int32_t pair = 0;    ///< number of the candidate pair
    int level = 0;            ///< that would be made
    std::uint64_t tests = 0;  ///< node tests that it takes, exactly; > 0
    /// By how much less far, by estimate, the nodes of that level stand out of the leaves than
    /// those of the level before, both bodies together [m].
    double error_fall = 0;
};

/// A policy of one's own: what the level is worth. The highest comes first; of equal ones the lower
/// pair; what is no number comes last. The same offer must always get the same answer, or else no
/// frame can be played again.
template <int Dim>
using LevelValue = std::function<double(const LevelOffer<Dim>&)>;

}  // namespace lod
