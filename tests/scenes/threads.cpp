#include <numeric>
#include <stdexcept>

#include "lodlab/core/tree/family_tests.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/threads/thread_pool.hpp"
#include "lodlab/scenes/trace/trace_player.hpp"
#include "tests/scenes/trace_files.hpp"

namespace {

/// Runs a crowd, by as many threads; one: none is injected.
scenes::RunOptions options_of(const scenes::Scene& scene, scenes::ThreadPool* pool) {
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(scene, scene.limits);
    options.limits = scene.limits;
    options.frames = 12;
    options.executor = pool;
    return options;
}

}  // namespace

TEST_CASE("a pool does each part once, and no worker two at a time") {
    for (const int threads : {1, 2, 5}) {
        scenes::ThreadPool pool(threads);
        REQUIRE(pool.workers() == threads);
        std::vector<int> done(1000, 0);                   // each written by one part
        std::vector<int> of_worker(lod::at(threads), 0);  // each read and written by one worker
        const auto task = [&](int part, int worker) {
            done[lod::at(part)] += worker >= 0 && worker < threads ? 1 : 100;
            ++of_worker[lod::at(worker)];
        };
        for (int repeat = 0; repeat < 20; ++repeat) pool.run(1000, lod::PartTask(task));
        pool.run(0, lod::PartTask(task));
        CHECK(done == std::vector<int>(1000, 20));
        CHECK(std::accumulate(of_worker.begin(), of_worker.end(), 0) == 20000);
    }
}

TEST_CASE("what a part throws reaches the caller, and the pool goes on") {
    scenes::ThreadPool pool(3);
    int done = 0;
    const auto one_throws = [&](int part, int) {
        if (part == 70) throw std::runtime_error("part 70");
    };
    const auto counts = [&](int part, int) {
        if (part == 0) ++done;
    };
    for (int repeat = 1; repeat <= 5; ++repeat) {
        CHECK_THROWS_WITH(pool.run(100, lod::PartTask(one_throws)), "part 70");
        pool.run(100, lod::PartTask(counts));
        CHECK(done == repeat);
    }
}

TEST_CASE("two pools may be there at once, and one within a part of the other") {
    scenes::ThreadPool outer(2);
    scenes::ThreadPool inner(3);
    std::vector<int> sums(8, 0);
    const auto inner_of = [&](int part, int) {
        std::vector<int> numbers(100, 0);
        const auto task = [&](int i, int) { numbers[lod::at(i)] = i; };
        // One part at a time: an executor belongs to one frame.
        if (part == 0) inner.run(100, lod::PartTask(task));
        sums[lod::at(part)] = std::accumulate(numbers.begin(), numbers.end(), 0);
    };
    outer.run(8, lod::PartTask(inner_of));
    CHECK(sums[0] == 4950);
}

TEST_CASE("a crowd with true shapes and sweeping runs to the same bits by any number of threads") {
    scenes::Scene scene = scenes::crowd("gas:700");
    scene.finest.level = lod::Finest::backtrack;
    scene.finest.most_pairs = 40;
    scene.sweep = true;
    const auto bodies = scenes::set_up<2>(scene).bodies;
    const scenes::Run<2> alone = scenes::run(bodies, options_of(scene, nullptr));
    CHECK(scenes::summarise(alone).exact_pairs > 100);
    for (const int threads : {2, 3}) {
        scenes::ThreadPool pool(threads);
        const scenes::Run<2> run = scenes::run(bodies, options_of(scene, &pool));
        for (std::size_t i = 0; i < alone.steps.size(); ++i) {
            CHECK(run.steps[i].state_hash == alone.steps[i].state_hash);
            CHECK(run.steps[i].record.impulses == alone.steps[i].record.impulses);
        }
    }
}

TEST_CASE("a trace by two threads and the widest instructions replays by one and plain loops") {
    scenes::Scene scene = scenes::crowd("gas:700");
    scene.limits.node_tests = 30000;
    const auto bodies = scenes::set_up<2>(scene).bodies;
    const TemporaryFolder folder;
    scenes::ThreadPool pool(2);
    const scenes::Run<2> run = scenes::run(bodies, options_of(scene, &pool));
    CHECK(scenes::summarise(run).interrupted_frames > 5);
    scenes::write_trace<2>(folder / "t.json", scene.name, bodies, run, {.key_frames = 5});
    const lod::detail::TestPath& widest = lod::detail::test_path();
    for (const lod::detail::TestPath& path : lod::detail::test_paths()) {
        lod::detail::take_path(path);
        CHECK(scenes::replay<2>(scenes::read_trace(folder / "t.json"), bodies).state_hash ==
              run.state_hash);
    }
    lod::detail::take_path(widest);
}
