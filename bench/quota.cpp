// Whether a frame's quota on the clock is kept, in crowds.
// Usage: bench_quota [MILLISECONDS [CROWD ...]]   1; implode:1000 implode:5000 rain:1000 rain:5000
// The clock is the thread's own processor time. Frames in which the operating system took the
// processor away (ru_nivcsw) are counted apart. Beside all frames stand those that the quota cut:
// the others take what they need, which is less.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/thread_clock.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"

namespace {

constexpr int frames = 300;

double at(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Frames {
    std::vector<double> microseconds;  ///< of each that kept the processor
    std::vector<double> cut;           ///< of them, those that the quota cut
    int preempted = 0;
    int interrupted = 0;
    double levels = 0;  ///< of pairs that were not told apart, in all frames
    double pairs = 0;
    double meeting = 0;   ///< pairs whose root balls meet
    double by_roots = 0;  ///< those of them that touched as these do
    int ended = 0;        ///< frames whose contacts or response the clock ended
};

/// The frames of a run, each within the quota; without one (0), as long as they take.
template <int Dim>
Frames run(std::vector<lod::Body<Dim>> bodies, const lod::FrameSettings& settings,
           std::chrono::nanoseconds quota) {
    const bench::ThreadClock clock;
    lod::FrameStorage<Dim> storage;
    Frames result;
    for (int frame = 0; frame < frames; ++frame) {
        const long before = bench::preemptions();
        const auto start = clock.now();
        lod::Budget budget = quota.count() > 0
                                 ? lod::Budget::deadline(clock, quota, scenes::time_of_a_node_pair)
                                 : lod::Budget::unlimited();
        const auto& record = lod::advance<Dim>(bodies, settings, budget, storage);
        const auto taken = clock.now() - start;
        result.interrupted += record.interrupted() ? 1 : 0;
        const lod::LevelsReached reached = record.levels_reached();
        result.levels += reached.mean * static_cast<double>(reached.pairs);
        result.pairs += static_cast<double>(reached.pairs);
        result.meeting += static_cast<double>(storage.fronts.meeting);
        result.by_roots += static_cast<double>(record.spending.levels.by_roots);
        result.ended += record.cut && (record.cut->modelled || record.cut->rounds) ? 1 : 0;
        if (bench::preemptions() != before) {
            ++result.preempted;
        } else if (frame > 0) {  // the first one allocates
            result.microseconds.push_back(1e-3 * static_cast<double>(taken.count()));
            if (record.interrupted()) result.cut.push_back(result.microseconds.back());
        }
    }
    return result;
}

template <int Dim>
void measure(const scenes::Scene& scene, const std::string& spec, double milliseconds) {
    const scenes::Setup<Dim> crowd = scenes::set_up<Dim>(scene);
    const lod::FrameSettings settings = scenes::frame_settings(scene, {});
    const std::chrono::nanoseconds quota(static_cast<std::int64_t>(1e6 * milliseconds));
    for (const auto limit : {std::chrono::nanoseconds(0), quota}) {
        const Frames found = run<Dim>(crowd.bodies, settings, limit);
        std::vector<double> overrun;
        for (const double taken : found.microseconds)
            overrun.push_back(std::max(0.0, taken - 1e3 * milliseconds));
        const double median = at(found.microseconds, 0.5);
        const double most = at(found.microseconds, 1);
        std::printf("%-14s %-10s median %9.1f us, most %9.1f (x %.2f)", spec.c_str(),
                    limit.count() == 0 ? "no quota" : "quota", median, most, most / median);
        if (limit.count() > 0)
            std::printf(
                ", overrun median %.2f us, 99 %% %.2f, most %.2f; cut %d of %d, median %.1f, most "
                "x %.2f; %.0f %% by roots, %d ended",
                at(overrun, 0.5), at(overrun, 0.99), at(overrun, 1), found.interrupted, frames,
                at(found.cut, 0.5), at(found.cut, 1) / std::max(1.0, at(found.cut, 0.5)),
                100 * found.by_roots / std::max(1.0, found.meeting), found.ended);
        std::printf("; level %.2f; %d preempted\n", found.levels / std::max(1.0, found.pairs),
                    found.preempted);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const double milliseconds = argc > 1 ? std::atof(argv[1]) : 1;
    std::vector<std::string> specs(argv + std::min(argc, 2), argv + argc);
    if (specs.empty()) specs = {"implode:1000", "implode:5000", "rain:1000", "rain:5000"};
    for (const std::string& spec : specs) {
        const scenes::Scene scene = scenes::crowd(spec);
        if (scene.dim == 2)
            measure<2>(scene, spec, milliseconds);
        else
            measure<3>(scene, spec, milliseconds);
    }
}
