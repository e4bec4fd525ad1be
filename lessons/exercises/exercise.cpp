#include "lessons/exercises/exercise.hpp"

namespace exercises {

const Exercise* find_exercise(const std::string& word) {
    for (const Exercise& exercise : all())
        if (exercise.words.name == word || std::to_string(exercise.number) == word)
            return &exercise;
    return nullptr;
}

std::vector<Case> cases_of(const Exercise& exercise) {
    std::vector<Case> cases;
    for (Numbers& numbers : exercise.task.edges()) cases.push_back({std::move(numbers), 0});
    for (std::uint64_t seed = 1; seed <= random_seeds; ++seed) {
        lod::Random random(seed);
        for (int i = 0; i < cases_of_a_seed; ++i)
            cases.push_back({exercise.task.random(random), seed});
    }
    return cases;
}

}  // namespace exercises
