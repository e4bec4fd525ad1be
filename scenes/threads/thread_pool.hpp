#pragma once

/// \file
/// Threads for the parts of a frame: an executor on oneTBB.

#include <memory>

#include "lodlab/core/base/executor.hpp"

namespace scenes {

/// So many threads at most, the calling one among them, that share out the parts of a task. They
/// are oneTBB's, which has one for each processor, more where a pool asks for more, and lends them
/// to whoever has work.
class ThreadPool final : public lod::Executor {
  public:
    /// No pool is larger.
    static constexpr int most_threads = 256;

    /// Requires: 1 <= threads <= most_threads.
    explicit ThreadPool(int threads);
    ~ThreadPool() override;

    [[nodiscard]] int workers() const override;
    void run(int parts, const lod::PartTask& task) override;

  private:
    class Arena;
    std::unique_ptr<Arena> arena_;
};

}  // namespace scenes
