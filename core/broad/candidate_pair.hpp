#pragma once

/// \file
/// Two bodies that are near enough to be looked at.

#include <cstdint>

namespace lod {

/// Two bodies that the broad phase could not tell apart; a < b.
struct CandidatePair {
    std::int32_t a = 0;
    std::int32_t b = 0;
    friend bool operator==(const CandidatePair&, const CandidatePair&) = default;
};

}  // namespace lod
