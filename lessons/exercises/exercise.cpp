#include "lessons/exercises/exercise.hpp"

#include "lessons/exercises/embedded.hpp"

namespace exercises {
namespace {

Exercise exercise_of(const Embedded& embedded, int number) {
    Exercise exercise{number, read_words(embedded.path, embedded.markdown), embedded.task(), {}};
    for (std::vector<int>& mistakes : mixtures_of(exercise.words))
        exercise.variants.push_back(
            {std::move(mistakes), embedded.answers[exercise.variants.size()]});
    return exercise;
}

std::vector<Exercise> all_exercises() {
    std::vector<Exercise> exercises;
    for (const Embedded& embedded : all_embedded())
        exercises.push_back(exercise_of(embedded, static_cast<int>(exercises.size()) + 1));
    return exercises;
}

}  // namespace

const std::vector<Exercise>& all() {
    static const std::vector<Exercise> exercises = all_exercises();
    return exercises;
}

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
