#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

namespace lessons::alarms {

using Vec = lod::Vector<2>;

/// An L and a star with trees of that depth, and what is exactly true of them.
struct Bodies {
    explicit Bodies(int depth);

    lod2d::Shape letter_shape;
    lod2d::Shape star_shape;
    viz::Actor<2> letter;
    viz::Actor<2> star;
    std::vector<double> letter_out;  ///< of each level: how far its circles stand out [m]
    std::vector<double> star_out;

    /// How wide a gap circles of a level can reach over [m].
    [[nodiscard]] double reach(std::size_t level) const {
        return letter_out[level] + star_out[level];
    }
    void place_star(const Vec& position, double angle);
    [[nodiscard]] std::vector<lod::Front> traverse() const {
        return lod::traverse_levels<2>(letter.body, star.body);
    }
    /// Of the outlines where they stand; the distance is 0 where they touch.
    [[nodiscard]] lod2d::ClosestPoints closest() const;
};

constexpr double first_angle = 0.3;  ///< of the star as it moves in [rad]

/// The star stops so near that level 2 may still reach over the gap, and level 3 may not.
[[nodiscard]] Bodies near_miss(Bodies bodies);
/// Of many angles of the star, that at which leaves overlap over the widest gap.
[[nodiscard]] Bodies false_collision(const Bodies& bodies);
/// The star has a corner within the L.
[[nodiscard]] Bodies overlapping(Bodies bodies);

/// Random placements of the star, each asked of the trees at every level, and exactly (count.cpp).
struct Counts {
    int touching = 0;
    int apart = 0;
    int misses = 0;                 ///< touching, and called apart at some level
    std::vector<int> false_alarms;  ///< of each level: apart, and not called so
    int false_collisions = 0;       ///< apart, and leaves overlap
    double widest = 0;              ///< of these [m]
    int over_reach = 0;             ///< circles that overlap over a gap wider than their reach
    int risen = 0;                  ///< levels with a false alarm that the one before had not
};

[[nodiscard]] Counts count_alarms(Bodies bodies, int placements);

/// The star is dropped on the L: where and how it lies.
void drop(Bodies& bodies, lod::Random& random);

/// The second half of the lesson: what is counted (count.cpp).
void give_counts(Lesson& lesson, const Bodies& bodies, const Bodies& deeper);

}  // namespace lessons::alarms
