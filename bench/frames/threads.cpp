// What a frame of a crowd takes by one thread, none injected, and by several.
// Usage: bench_threads [THREADS [FRAMES [CROWD ...]]]   2; 60; gas:1000 gas:5000
// Frames of all are run in turn, the bits of each compared. Times are the wall's, least and median,
// for that is what threads are for: nothing else should run.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/thread_clock.hpp"
#include "bench/timing.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/threads/thread_pool.hpp"

namespace {

constexpr int warm_up = 20;  ///< frames that are not counted

/// Does the parts on the calling thread, and measures what they take.
class Measuring final : public lod::Executor {
  public:
    explicit Measuring(int workers) : workers_(workers) {}
    [[nodiscard]] int workers() const override { return workers_; }
    void run(int parts, const lod::PartTask& task) override {
        const auto start = clock_.now();
        for (int part = 0; part < parts; ++part) task(part, part % workers_);
        taken_ += clock_.now() - start;
    }
    /// Processor time so far [s], of the parts.
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(taken_).count(); }

  private:
    int workers_;
    bench::ThreadClock clock_;
    std::chrono::nanoseconds taken_{};
};

/// One of the runs.
template <int Dim>
struct Run {
    int threads = 0;  ///< 0: no executor
    std::vector<lod::Body<Dim>> bodies;
    lod::FrameStorage<Dim> storage = {};
    std::vector<double> seconds = {};
};

double processor_seconds() {
    return std::chrono::duration<double>(bench::ThreadClock().now()).count();
}

/// How the processor time of frames divides: medians of what is done in parts and of the rest.
template <int Dim>
void divide(const std::vector<lod::Body<Dim>>& start, const lod::FrameSettings& settings,
            int threads, int frames) {
    Measuring measuring(threads);
    Run<Dim> plain{0, start};
    Run<Dim> parted{threads, start};
    parted.storage.executor = &measuring;
    std::vector<double> in_parts;
    for (int frame = 0; frame < warm_up + frames; ++frame)
        for (Run<Dim>* run : {&plain, &parted}) {
            const double before = measuring.seconds();
            const double begin = processor_seconds();
            lod::Budget budget = lod::Budget::unlimited();
            lod::advance<Dim>(run->bodies, settings, budget, run->storage);
            if (frame < warm_up) continue;
            run->seconds.push_back(processor_seconds() - begin);
            if (run == &parted) in_parts.push_back(measuring.seconds() - before);
        }
    const double whole = bench::median(plain.seconds);
    const double parts = bench::median(in_parts);
    const double rest = bench::median(parted.seconds) - parts;
    std::printf(
        "  processor time of a frame %.3f ms; cut into parts %.3f ms, of it in parts %.3f; "
        "so %d threads: at best x %.2f\n",
        1e3 * whole, 1e3 * (parts + rest), 1e3 * parts, threads, whole / (rest + parts / threads));
}

template <int Dim>
void measure(const scenes::Scene& scene, const std::string& spec, int threads, int frames) {
    const scenes::Setup<Dim> crowd = scenes::set_up<Dim>(scene);
    lod::FrameSettings settings = scenes::frame_settings(scene, {});
    settings.time_step = 1.0 / 60;
    scenes::ThreadPool pool(threads);
    std::vector<Run<Dim>> runs;
    runs.push_back({0, crowd.bodies});
    runs.push_back({threads, crowd.bodies});
    runs.back().storage.executor = &pool;
    for (int frame = 0; frame < warm_up + frames; ++frame)
        for (Run<Dim>& run : runs) {
            const double seconds = bench::wall_seconds([&] {
                lod::Budget budget = lod::Budget::unlimited();
                lod::advance<Dim>(run.bodies, settings, budget, run.storage);
            });
            if (frame >= warm_up) run.seconds.push_back(seconds);
        }
    const auto least = [](const Run<Dim>& run) {
        return *std::min_element(run.seconds.begin(), run.seconds.end());
    };
    const auto hash = [](const Run<Dim>& run) { return lod::state_hash<Dim>(run.bodies); };
    for (const Run<Dim>& run : runs)
        std::printf("%-12s %d threads: least %8.3f ms (x %.2f), median %8.3f ms (x %.2f), %s\n",
                    spec.c_str(), std::max(1, run.threads), 1e3 * least(run),
                    least(runs[0]) / least(run), 1e3 * bench::median(run.seconds),
                    bench::median(runs[0].seconds) / bench::median(run.seconds),
                    hash(run) == hash(runs[0]) ? "the same bits" : "OTHER BITS");
    divide<Dim>(crowd.bodies, settings, threads, frames);
}

}  // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
    std::vector<std::string> specs(argv + std::min(argc, 3), argv + argc);
    if (specs.empty()) specs = {"gas:1000", "gas:5000"};
    for (const std::string& spec : specs) {
        const scenes::Scene scene = scenes::crowd(spec);
        if (scene.dim == 2)
            measure<2>(scene, spec, threads, frames);
        else
            measure<3>(scene, spec, threads, frames);
    }
}
