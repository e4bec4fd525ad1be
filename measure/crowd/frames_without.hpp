#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/frame/frame.hpp"

namespace measure::detail {

/// A frame of a run without a quota: what it began with and ended with.
template <int Dim>
struct FrameWithout {
    std::vector<lod::Body<Dim>> before;
    std::vector<lod::Body<Dim>> after;
    const lod::FrameRecord<Dim>* record = nullptr;
    std::span<const lod::CandidatePair> candidates;
    double done = 0;  ///< share of the run, with it
};

/// A run without a quota.
template <int Dim>
struct RunWithout {
    std::span<const lod::Body<Dim>> bodies;  ///< at the start
    lod::FrameSettings settings;
    std::int64_t frames = 1;
    lod::Executor* executor = nullptr;
};

/// Calls take(frame) for each frame without a quota. Returns the most tests that one needs.
template <int Dim, class Take>
std::uint64_t run_without(const RunWithout<Dim>& run, const Take& take) {
    FrameWithout<Dim> frame;
    frame.after.assign(run.bodies.begin(), run.bodies.end());
    lod::FrameStorage<Dim> storage;
    storage.executor = run.executor;
    std::uint64_t dearest = 0;
    for (std::int64_t i = 0; i < run.frames; ++i) {
        lod::check_interrupted();
        frame.before = frame.after;
        lod::Budget budget = lod::Budget::unlimited();
        frame.record = &lod::advance<Dim>(frame.after, run.settings, budget, storage);
        frame.candidates = storage.candidates;
        frame.done = static_cast<double>(i + 1) / static_cast<double>(run.frames);
        dearest = (std::max)(dearest, frame.record->tests);
        take(frame);
    }
    return dearest;
}

}  // namespace measure::detail
