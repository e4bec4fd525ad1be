#pragma once

/// \file
/// What a frame's quota went into.

#include <cstdint>
#include <optional>

#include "lodlab/core/frame/frame_record.hpp"

namespace viz {

/// What a frame may spend: one of both, or nothing where there is no limit.
struct Quota {
    std::optional<std::uint64_t> node_tests;
    std::optional<double> milliseconds;
    /// Whether there is one.
    [[nodiscard]] bool given() const { return node_tests || milliseconds; }
};

/// The parts of a quota, in its own unit: node tests, or milliseconds. Where nothing is over,
/// levels + response + reserve + unused = quota; else levels + response = quota + overrun.
struct QuotaUse {
    double quota = 0;
    double levels = 0;    ///< all until the levels were done: finding pairs and refining them
    double response = 0;  ///< what followed: contacts, impulses, motion; node tests do not count it
    double reserve = 0;   ///< what was kept for that and not needed
    double unused = 0;
    double overrun = 0;  ///< beyond the quota
};

/// Of a frame: nothing where it had no quota, or on a clock does not tell its times.
template <int Dim>
[[nodiscard]] std::optional<QuotaUse> use_of(const lod::FrameRecord<Dim>& record,
                                             const Quota& quota);

}  // namespace viz
