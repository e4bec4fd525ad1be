#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

namespace bench {

/// Seconds of one call by the wall clock: for work that runs on several threads.
template <class Work>
double wall_seconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processor seconds of one call: what else the machine does costs it little.
template <class Work>
double seconds(Work&& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median seconds of each of several pieces of work, run in turn again and again, so that what
/// else the machine does falls on all of them alike.
template <class... Works>
std::vector<double> medians(int repeats, Works&&... works) {
    std::vector<std::vector<double>> times(sizeof...(works));
    for (int repeat = 0; repeat < repeats; ++repeat) {
        std::size_t which = 0;
        (times[which++].push_back(seconds(works)), ...);
    }
    std::vector<double> result;
    for (auto& series : times) result.push_back(median(std::move(series)));
    return result;
}

/// The same for as many as there are.
inline std::vector<double> medians_of(int repeats,
                                      const std::vector<std::function<void()>>& works) {
    std::vector<std::vector<double>> times(works.size());
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (std::size_t i = 0; i < works.size(); ++i) times[i].push_back(seconds(works[i]));
    std::vector<double> result;
    for (auto& series : times) result.push_back(median(std::move(series)));
    return result;
}

}  // namespace bench
