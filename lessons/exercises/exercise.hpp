#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lessons/exercises/words.hpp"
#include "lodlab/core/base/random.hpp"

namespace exercises {

/// A case or an answer as the row of its numbers (lessons/exercises/wire.hpp).
using Numbers = std::vector<double>;

/// What the code of an exercise gives: questions to the student's function, and the right answers,
/// found in another way than the reference solution finds them. A case may have more numbers than
/// the function takes, for `truth` alone.
struct Task {
    std::vector<Numbers> (*edges)() = nullptr;
    Numbers (*random)(lod::Random&) = nullptr;  ///< one case
    Numbers (*truth)(const Numbers& asked) = nullptr;
};

/// The reference solution with some of its lines replaced: with none, one or two mistakes.
struct Variant {
    std::vector<int> mistakes;  ///< indices into Words::mistakes
    Numbers (*answer)(const Numbers& asked) = nullptr;
};

/// An exercise: a function that the student completes.
struct Exercise {
    int number = 0;  ///< 1 and up
    Words words;
    Task task;
    std::vector<Variant> variants;  ///< the solution first, then each mistake, then pairs of them
};

/// Every exercise, in order.
[[nodiscard]] const std::vector<Exercise>& all();

/// By its number or its name; nothing where there is none.
[[nodiscard]] const Exercise* find_exercise(const std::string& word);

/// A question to a student's function.
struct Case {
    Numbers numbers;
    std::uint64_t seed = 0;  ///< of a random one; 0: an edge case
};

constexpr std::uint64_t random_seeds = 100;
constexpr int cases_of_a_seed = 4;

/// The edge cases, then those of the seeds 1 to 100.
[[nodiscard]] std::vector<Case> cases_of(const Exercise& exercise);

}  // namespace exercises
