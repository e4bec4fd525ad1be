#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "lodlab/core/base/executor.hpp"

namespace lodtest {

/// Does the parts on the calling thread in an order that is none, each by any of its workers: what
/// threads might do, the same each time.
class ShuffledExecutor final : public lod::Executor {
  public:
    explicit ShuffledExecutor(int workers) : workers_(workers) {}
    [[nodiscard]] int workers() const override { return workers_; }
    void run(int parts, const lod::PartTask& task) override {
        constexpr int prime = 7919;
        const int stride = parts % prime == 0 ? 1 : prime;
        for (int i = 0; i < parts; ++i) {
            const int part = static_cast<int>((std::int64_t{i} * stride + parts / 2) % parts);
            state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
            task(part, static_cast<int>((state_ >> 33) % static_cast<unsigned>(workers_)));
        }
        parts_ += parts;
    }
    /// From now on the same again.
    void restart() { state_ = first_state; }
    /// Done so far.
    [[nodiscard]] int parts() const { return parts_; }

  private:
    int workers_;
    int parts_ = 0;
    static constexpr std::uint64_t first_state = 7;
    std::uint64_t state_ = first_state;
};

/// Threads of the standard library, new ones for each task.
class ThreadedExecutor final : public lod::Executor {
  public:
    explicit ThreadedExecutor(int workers) : workers_(workers) {}
    [[nodiscard]] int workers() const override { return workers_; }
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
        std::vector<std::thread> threads;
        for (int worker = 1; worker < workers_; ++worker) threads.emplace_back(work, worker);
        work(0);
        for (std::thread& thread : threads) thread.join();
        if (thrown) std::rethrow_exception(thrown);
    }

  private:
    int workers_;
};

}  // namespace lodtest
