#pragma once

#include <functional>
#include <string_view>

#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {

/// The bytes of a trace, for another that goes on where it ends.
class TraceCopy {
  public:
    /// Requires: the trace outlives it. Throws lod::Error (input refused) where it is of version 2.
    explicit TraceCopy(const Trace& trace);
    /// Gives away what stands before the end, checked, each key frame with what follows it.
    /// `begin` is told of the number of each key frame before it is given.
    void give(const std::function<void(std::int64_t key_frame)>& begin,
              const std::function<void(std::string_view text)>& write) const;

  private:
    const Trace& trace_;
};

}  // namespace scenes
