// A frame on threads of one's own: an executor hands the parts of a frame to whatever pool a
// program has. Which it is, and how many threads, changes no bit.
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <lodlab/core/base/executor.hpp>
#include <lodlab/core/frame/frame.hpp>
#include <lodlab/core/frame/state_hash.hpp>
#include <lodlab/scenes/crowd/crowds.hpp>
#include <lodlab/scenes/setup.hpp>

// Two threads that are new each time; a program has a pool that keeps its own.
class TwoThreads : public lod::Executor {
  public:
    int workers() const override { return 2; }
    void run(int parts, const lod::PartTask& task) override {
        std::atomic<int> next{0};
        std::exception_ptr thrown;
        std::mutex throwing;
        const auto work = [&](int worker) {
            try {
                for (int part = next++; part < parts; part = next++) task(part, worker);
            } catch (...) {
                const std::lock_guard lock(throwing);
                thrown = std::current_exception();
            }
        };
        std::thread other(work, 1);
        work(0);
        other.join();
        if (thrown) std::rethrow_exception(thrown);
    }
};

int main() {
    TwoThreads threads;
    std::uint64_t hashes[2];
    for (int run = 0; run < 2; ++run) {
        std::vector<lod::Body<2>> bodies = scenes::set_up<2>(scenes::crowd("gas:300")).bodies;
        lod::FrameStorage<2> storage;
        if (run == 1) storage.executor = &threads;
        for (int frame = 0; frame < 60; ++frame) {
            lod::Budget budget = lod::Budget::unlimited();
            lod::advance<2>(bodies, {}, budget, storage);
        }
        hashes[run] = lod::state_hash<2>(bodies);
        std::printf("%d thread%s: %016llx\n", run + 1, run == 0 ? "" : "s",
                    static_cast<unsigned long long>(hashes[run]));
    }
    std::printf("%s\n", hashes[0] == hashes[1] ? "the same bits" : "other bits");
    return hashes[0] == hashes[1] ? 0 : 1;
}
