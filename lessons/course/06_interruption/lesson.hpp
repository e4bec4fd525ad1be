#pragma once

#include <array>

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/frame/frame.hpp"

namespace lessons::interruption {

/// What a pair's level came to.
enum class End {
    done,
    lost,     ///< the clock ended within it
    left_out  ///< it was not begun, for it would not have fitted
};

/// A level of a pair, on the axis of the frame's tests.
struct Turn {
    int pair = 0;  ///< 0 or 1
    int level = 0;
    std::uint64_t begin = 0;  ///< tests of the frame before it
    std::uint64_t tests = 0;  ///< that it took, or would have
    End end = End::done;
};

/// Tests of each level, of each pair.
using Costs = std::array<std::vector<std::uint64_t>, 2>;

/// What ends the frame.
enum class Stop {
    clock,   ///< after so many tests, unannounced
    counted  ///< so many tests, known from the start
};

/// A frame by the rule: which turns it takes (turns.cpp).
[[nodiscard]] std::vector<Turn> turns_of(const Costs& costs, lod::Priority order, Stop stop,
                                         std::uint64_t quota);

/// The last finished level of each pair.
[[nodiscard]] std::array<int, 2> finished(const std::vector<Turn>& turns);

/// A row for each pair, a block for each level, over the tests of the frame; `quota` 0: no line.
[[nodiscard]] viz::Panel chart(const std::vector<Turn>& turns, std::uint64_t most,
                               std::uint64_t quota);

constexpr int depth = 3;

/// Two bodies, and every level of their traversal.
struct Pair {
    viz::Actor<2> a;
    viz::Actor<2> b;
    std::vector<lod::Front> levels;
    bool touch = false;

    [[nodiscard]] std::vector<std::uint64_t> costs() const {
        std::vector<std::uint64_t> tests;
        std::uint64_t before = 0;
        for (const lod::Front& front : levels) {
            tests.push_back(front.tests - before);
            before = front.tests;
        }
        return tests;
    }
};

/// Pair 1 touches, pair 2 nearly does (scene.cpp).
struct Scene {
    Scene();
    std::array<Pair, 2> pairs;
    Costs costs;

    [[nodiscard]] std::uint64_t tests() const {
        return pairs[0].levels.back().tests + pairs[1].levels.back().tests;
    }
    [[nodiscard]] std::vector<lod::Body<2>> bodies() const {
        return {pairs[0].a.body, pairs[0].b.body, pairs[1].a.body, pairs[1].b.body};
    }
};

/// One frame of the program itself: the last finished level of each pair, and what it says.
[[nodiscard]] std::vector<lod::PairRecord> detect(const Scene& scene, lod::Priority order,
                                                  lod::Budget budget);
/// The same, by turns, as if a clock had ended the frame after so many tests.
[[nodiscard]] std::vector<lod::PairRecord> detect_until(const Scene& scene, std::uint64_t tests);

/// The level that was cut, as far as it was done, and whole (part.cpp).
void give_part(Lesson& lesson, const Pair& pair, const Turn& cut);

}  // namespace lessons::interruption
