// Is a quota on a clock kept where a crowd falls to one place, and what does the scheduler cost?
// Usage: bench_scheduler [BODIES [MILLISECONDS [FRAMES [POLICY]]]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "bench/thread_clock.hpp"
#include "bench/timing.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace {

constexpr double time_step = 1.0 / 60;

/// Stars, gears and Ls on a square that all fly towards its middle.
std::vector<lod::Body<2>> implosion(int count) {
    std::vector<lod2d::Shape> shapes;
    std::vector<std::shared_ptr<const lod::SphereTree<2>>> trees;
    for (const char* spec : {"star:5", "gear:9", "L"}) {
        shapes.push_back(lod2d::generate(spec));
        trees.push_back(std::make_shared<const lod::SphereTree<2>>(
            lod2d::build_tree(shapes.back(), {.branching = 4, .depth = 4})));
    }
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    lod::Random random(11);
    std::vector<lod::Body<2>> bodies;
    for (int i = 0; i < count; ++i) {
        const std::size_t kind = static_cast<std::size_t>(i) % 3;
        lod::Body<2> body;
        lod::set_mass(body, shapes[kind].area,
                      lod::Inertia<2>::Constant(shapes[kind].second_moment));
        body.tree = trees[kind];
        body.position = {(i % columns + 0.5 - 0.5 * columns) * 1.6,
                         (i / columns + 0.5 - 0.5 * columns) * 1.6};
        body.orientation = random.next(0, 6);
        body.velocity = -4 * body.position.normalized() +
                        lod::Vector<2>(random.next(-0.3, 0.3), random.next(-0.3, 0.3));
        body.spin[0] = random.next(-4, 4);
        bodies.push_back(body);
    }
    return bodies;
}

double at_share(std::vector<double> numbers, double share) {
    if (numbers.empty()) return 0;
    std::sort(numbers.begin(), numbers.end());
    return numbers[static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1))];
}

struct Figures {
    std::vector<double> overrun;      ///< [us], of frames that were not preempted; negative: left
    std::vector<double> with_room;    ///< the same where the entry levels take less than 80 %
    std::vector<double> frame;        ///< [us]
    std::vector<double> least_frame;  ///< [us], of the same bodies to their entry level alone
    double levels = 0;
    double skipped = 0;
    double dropped = 0;
    double level_sum = 0;  ///< reached by pairs that collide
    double colliding = 0;
    int cut = 0;
    int preempted = 0;
};

Figures run(int count, double milliseconds, int frames, lod::FrameSettings settings) {
    const bench::ThreadClock clock;
    std::vector<lod::Body<2>> bodies = implosion(count);
    lod::FrameStorage<2> storage;
    lod::FrameStorage<2> other;
    Figures figures;
    settings.time_step = time_step;
    const auto quota = std::chrono::nanoseconds(static_cast<std::int64_t>(1e6 * milliseconds));
    const auto elapsed = [&](std::chrono::nanoseconds from) {
        return 1e-3 * static_cast<double>((clock.now() - from).count());
    };
    for (int frame = 0; frame < frames; ++frame) {
        std::vector<lod::Body<2>> copy = bodies;
        auto begin = clock.now();
        lod::Budget none = lod::Budget::node_tests(0);
        lod::advance<2>(copy, settings, none, other);
        figures.least_frame.push_back(elapsed(begin));
        const long before = bench::preemptions();
        begin = clock.now();
        lod::Budget budget = lod::Budget::deadline(clock, quota, std::chrono::nanoseconds(250));
        const auto& record = lod::advance<2>(bodies, settings, budget, storage);
        const double taken = elapsed(begin);
        figures.levels += static_cast<double>(record.spending.levels.finished);
        figures.skipped += static_cast<double>(record.spending.levels.skipped);
        figures.dropped += static_cast<double>(record.spending.levels.dropped);
        figures.cut += record.interrupted() ? 1 : 0;
        const lod::LevelsReached reached = record.levels_reached();
        figures.level_sum += reached.mean * static_cast<double>(reached.pairs);
        figures.colliding += static_cast<double>(reached.pairs);
        if (bench::preemptions() != before) {
            ++figures.preempted;
            continue;
        }
        figures.frame.push_back(taken);
        figures.overrun.push_back(taken - 1e3 * milliseconds);
        if (figures.least_frame.back() < 0.8e3 * milliseconds)
            figures.with_room.push_back(taken - 1e3 * milliseconds);
    }
    return figures;
}

void print(const Figures& figures, const std::string& policy, int frames) {
    std::printf(
        "%-13s overrun [us] median %.1f p99 %.1f max %.1f, with room p99 %.1f; frame median %.0f "
        "max %.0f; least frame "
        "median %.0f max %.0f; levels %.0f skipped %.0f dropped %.1f a frame, colliding pairs at "
        "%.2f in "
        "the mean; %d of %d frames cut, %d preempted\n",
        policy.c_str(), at_share(figures.overrun, 0.5), at_share(figures.overrun, 0.99),
        at_share(figures.overrun, 1), at_share(figures.with_room, 0.99),
        at_share(figures.frame, 0.5), at_share(figures.frame, 1),
        at_share(figures.least_frame, 0.5), at_share(figures.least_frame, 1),
        figures.levels / frames, figures.skipped / frames, figures.dropped / frames,
        figures.level_sum / std::max(1.0, figures.colliding), figures.cut, frames,
        figures.preempted);
}

/// What a level costs beside its tests: the same levels at once and by the heap, nodes carried
/// before.
void measure_heap(int count) {
    std::vector<lod::Body<2>> dense = implosion(count);
    for (lod::Body<2>& body : dense) body.position *= 0.55;
    lod::FrameStorage<2> storage;
    lod::Budget unlimited = lod::Budget::unlimited();
    lod::detect<2>(dense, {.contact_model = lod::ContactModel::node_normal}, unlimited, storage);
    const bench::ThreadClock clock;
    const auto time = [&](lod::Priority priority, lod::Budget budget) {
        const auto begin = clock.now();
        storage.scheduler.refine_all({dense, storage.candidates, storage.world_S, {}, priority, {}},
                                     budget, storage.fronts);
        return static_cast<double>((clock.now() - begin).count());
    };
    for (const lod::Priority priority : lod::choices<lod::Priority>()) {
        std::vector<double> at_once;
        std::vector<double> counted;
        std::vector<double> timed;
        for (int repeat = 0; repeat < 41; ++repeat) {
            at_once.push_back(time(priority, lod::Budget::unlimited()));
            counted.push_back(time(priority, lod::Budget::node_tests(1ULL << 40)));
            timed.push_back(time(priority, lod::Budget::deadline(clock, std::chrono::hours(1))));
        }
        const auto levels = static_cast<double>(storage.scheduler.counts().finished);
        const double once = bench::median(at_once);
        std::printf(
            "%-13s %zu pairs, %.0f levels: %.0f ns a level at once, by the heap %.0f more "
            "by count, %.0f on a clock\n",
            std::string(lod::name_of(priority)).c_str(), storage.candidates.size(), levels,
            once / levels, (bench::median(counted) - once) / levels,
            (bench::median(timed) - once) / levels);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
    const double milliseconds = argc > 2 ? std::atof(argv[2]) : 1;
    const int frames = argc > 3 ? std::atoi(argv[3]) : 400;
    for (const lod::Priority priority : lod::choices<lod::Priority>()) {
        const std::string name(lod::name_of(priority));
        if (argc > 4 && name != argv[4]) continue;
        print(run(count, milliseconds, frames, {.priority = priority}), name, frames);
    }
    if (argc <= 4)
        print(run(count, milliseconds, frames, {.organisation = lod::Organisation::stored}),
              "stored", frames);
    if (argc <= 4) measure_heap(count);
}
