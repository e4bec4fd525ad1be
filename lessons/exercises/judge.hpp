#pragma once

#include <span>
#include <string>
#include <vector>

#include "lessons/exercises/attempt.hpp"
#include "lessons/exercises/exercise.hpp"

namespace exercises {

/// What is to be said of an attempt.
struct Judgement {
    bool passes = false;
    std::size_t cases = 0;
    std::size_t wrong = 0;           ///< cases that were answered, and wrongly
    std::vector<int> mistakes;       ///< recognised ones: indices into Words::mistakes
    std::string verdict;             ///< what became of it, without a name and a full stop
    std::vector<std::string> lines;  ///< why, at most three or four
};

/// Whether two answers are the same, up to rounding; nan is as nan.
[[nodiscard]] bool same_answer(const Numbers& a, const Numbers& b);

/// A mistake is recognised by what the function answers: its answers are those of the reference
/// solution with that mistake in it, or with two. Failing that, one that explains every case in
/// which it differs from the truth, and at least half of the wrong answers.
[[nodiscard]] Judgement judge(const Exercise& exercise, std::span<const Case> cases,
                              const Attempt& attempt);

}  // namespace exercises
