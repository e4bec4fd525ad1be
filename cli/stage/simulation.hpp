#pragma once

#include <cstdint>
#include <optional>

#include "cli/arguments/options.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace cli {

/// What is left of a simulation whose frames were added up as they came.
template <int Dim>
struct Simulation {
    scenes::Run<Dim> run;  ///< its steps only where there is something to draw
    scenes::Summary summary;
    std::int64_t first_frame = 0;  ///< where it began; above 0 where it went on from a trace
    std::int64_t frames = 0;       ///< that it ran
};

/// Runs a staged scene as the options say, with a progress bar: under its limits, from the trace
/// that is played again, or on from the end of the trace that is continued (`earlier`). Writes the
/// trace that they ask for as it goes.
template <int Dim>
[[nodiscard]] Simulation<Dim> simulated(const scenes::Setup<Dim>& setup, const Options& options,
                                        const std::optional<scenes::Trace>& earlier);

}  // namespace cli
