#pragma once

#include <optional>

#include "cli/arguments/options.hpp"
#include "lodlab/scenes/threads/thread_pool.hpp"

namespace cli {

/// The threads that --threads asks for.
class Threads {
  public:
    explicit Threads(const Options& options) {
        if (options.threads > 1) pool_.emplace(options.threads);
    }
    /// Nothing: the calling thread alone.
    [[nodiscard]] lod::Executor* executor() const { return pool_ ? &*pool_ : nullptr; }

  private:
    mutable std::optional<scenes::ThreadPool> pool_;
};

}  // namespace cli
