// Every exercise as a student would have it checked, compiled and asked all cases: the starter must
// fail, the reference solution pass, and each foreseen mistake get the reply that names it.
//     bench_exercises [THREADS]      prints a line an exercise; exits 1 where one does not hold
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "lessons/exercises/judge.hpp"
#include "lessons/exercises/workshop.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// One file that a student may have written, and what must be said of it.
struct Trial {
    const exercises::Exercise* exercise;
    std::string code;
    bool passes;
    std::vector<int> mistakes;
    std::string name;
    double seconds = 0;
    std::string wrong{};  ///< what was said instead
};

std::vector<Trial> trials() {
    std::vector<Trial> trials;
    for (const exercises::Exercise& exercise : exercises::all()) {
        trials.push_back({&exercise, exercises::starter_file(exercise), false, {}, "starter"});
        for (const exercises::Variant& variant : exercise.variants) {
            if (variant.mistakes.size() > 1) continue;
            const bool right = variant.mistakes.empty();
            const auto& mistakes = exercise.words.mistakes;
            trials.push_back(
                {&exercise, exercises::code_with(exercise.words, variant.mistakes), right,
                 variant.mistakes,
                 right ? "solution"
                       : mistakes[static_cast<std::size_t>(variant.mistakes.front())].name});
        }
    }
    return trials;
}

void run(Trial& trial) {
    const Clock::time_point begin = Clock::now();
    const std::vector<exercises::Case> cases = exercises::cases_of(*trial.exercise);
    const exercises::Judgement found = exercises::judge(
        *trial.exercise, cases, exercises::attempt(*trial.exercise, trial.code, cases, "."));
    trial.seconds = seconds_since(begin);
    const bool as_it_should = found.passes == trial.passes && (found.wrong > 0) == !trial.passes &&
                              (trial.name == "starter" || found.mistakes == trial.mistakes);
    if (as_it_should) return;
    trial.wrong = found.verdict;
    for (const std::string& line : found.lines) trial.wrong += "\n        " + line;
}

bool report(const std::vector<Trial>& trials) {
    bool good = true;
    for (const exercises::Exercise& exercise : exercises::all()) {
        int count = 0;
        double seconds = 0;
        for (const Trial& trial : trials) {
            if (trial.exercise != &exercise) continue;
            ++count;
            seconds += trial.seconds;
            if (trial.wrong.empty()) continue;
            good = false;
            std::printf("    %s, %s: %s\n", exercise.words.name.c_str(), trial.name.c_str(),
                        trial.wrong.c_str());
        }
        std::printf("%-16s %2d mistakes, %.2f s a check\n", exercise.words.name.c_str(), count - 2,
                    seconds / count);
    }
    return good;
}

}  // namespace

int main(int count, char** words) {
    const int threads = count > 1 ? std::atoi(words[1]) : 2;
    const Clock::time_point begin = Clock::now();
    std::vector<Trial> all = trials();
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> workers;
    for (int i = 0; i < threads; ++i)
        workers.emplace_back([&] {
            for (std::size_t at = next++; at < all.size(); at = next++) run(all[at]);
        });
    for (std::thread& worker : workers) worker.join();
    const bool good = report(all);
    std::printf("%zu files in %.1f s on %d threads: %s\n", all.size(), seconds_since(begin),
                threads, good ? "each as it should be" : "NOT all as they should be");
    return good ? 0 : 1;
}
