#pragma once

/// \file
/// What a quota of node tests costs: frames of a crowd under it, against the same frames without.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lodlab/core/frame/frame.hpp"

namespace measure {

/// A crowd and the quotas that its frames are tried under.
template <int Dim>
struct QuotaPlan {
    std::span<const lod::Body<Dim>> bodies;  ///< at the start
    lod::FrameSettings settings;             ///< its priority is not used
    std::int64_t frames = 1;
    std::vector<double> shares;  ///< quotas, as shares of the tests that the dearest frame needs
    std::vector<lod::Priority> priorities;
    lod::Executor* executor = nullptr;             ///< whose threads do frames; it changes no bit
    std::function<void(double share)> progress{};  ///< called after every frame with the share done
};

/// A crowd under one quota in one order of priority, over all frames.
struct QuotaOutcome {
    std::uint64_t quota = 0;  ///< node tests a frame
    /// Sum over frames and bodies of |m (dv - dv_ref)| over that of |m dv_ref|, dv what the
    /// impulses of a frame change: 0 where every impulse is right, 1 where there are none.
    double error = 0;
    /// The same with each body weighted by its attention (body_attention): the error where the
    /// observer of settings.viewer looks.
    double attended_error = 0;
    double level = 0;  ///< mean last finished level of the pairs that are not apart
    double cut = 0;    ///< share of the frames that the quota cut short
};

/// Priority by priority, share by share.
struct QuotaOutcomes {
    std::uint64_t dearest = 0;  ///< node tests of the frame that needs most
    std::vector<std::vector<QuotaOutcome>> of_priority;
};

/// Runs the crowd without a quota, and does each of its frames again under every quota from the
/// same state, so that errors are those of one frame and never of a run that has gone another way.
template <int Dim>
[[nodiscard]] QuotaOutcomes try_quotas(const QuotaPlan<Dim>& plan);

/// The attention of each body: the most that one of its pairs has (lod::Attention, what
/// Priority::perceptual goes by); 0 where it has no pair. Requires: the pairs' bodies are there.
template <int Dim>
[[nodiscard]] std::vector<double> body_attention(const lod::Viewer& viewer,
                                                 std::span<const lod::Body<Dim>> bodies,
                                                 std::span<const lod::CandidatePair> pairs);

}  // namespace measure
