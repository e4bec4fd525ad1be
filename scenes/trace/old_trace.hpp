#pragma once

#include <string_view>
#include <vector>

#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {

/// A trace of version 2: one JSON document, all in memory.
struct OldTrace {
    TraceHead head;
    std::vector<TraceInterval> intervals;
};

/// Reads one. Throws std::exception at anything else.
[[nodiscard]] OldTrace old_trace_from(std::string_view text);

}  // namespace scenes
