#pragma once

#include "cli/arguments/options.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace cli {

/// Prints a moment of a trace, which the options name by --seek: the bodies as the frame finds
/// them, and what happens in it; draws it where they ask for a picture. Throws lod::Error (usage)
/// where the trace has no such moment.
template <int Dim>
void show_moment(const scenes::Setup<Dim>& setup, const Options& options,
                 const scenes::Trace& trace);

}  // namespace cli
