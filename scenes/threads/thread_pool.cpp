#include "lodlab/scenes/threads/thread_pool.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <optional>

namespace scenes {

/// Threads of oneTBB's work for one frame alone.
class ThreadPool::Arena {
  public:
    explicit Arena(int threads) : arena_(threads) {
        // Unasked it starts no more than there are processors, and says so on stderr.
        if (threads > tbb::info::default_concurrency())
            more_.emplace(tbb::global_control::max_allowed_parallelism,
                          static_cast<std::size_t>(threads));
    }

    [[nodiscard]] int threads() const { return arena_.max_concurrency(); }

    void run(int parts, const lod::PartTask& task) {
        arena_.execute([&] {
            tbb::parallel_for(tbb::blocked_range<int>(0, parts, 1),
                              [&](const tbb::blocked_range<int>& some) {
                                  const int worker = tbb::this_task_arena::current_thread_index();
                                  for (int part = some.begin(); part < some.end(); ++part)
                                      task(part, worker);
                              });
        });
    }

  private:
    std::optional<tbb::global_control> more_;
    tbb::task_arena arena_;
};

ThreadPool::ThreadPool(int threads) : arena_(std::make_unique<Arena>(threads)) {}
ThreadPool::~ThreadPool() = default;

int ThreadPool::workers() const {
    return arena_->threads();
}

void ThreadPool::run(int parts, const lod::PartTask& task) {
    arena_->run(parts, task);
}

}  // namespace scenes
