#pragma once

/// \file
/// Two bodies that are near enough to be looked at.

#include <cstddef>
#include <cstdint>

namespace lod {

/// Two bodies that the broad phase could not tell apart; a < b.
struct CandidatePair {
    std::int32_t a = 0;
    std::int32_t b = 0;
    friend bool operator==(const CandidatePair&, const CandidatePair&) = default;
};

/// No frame takes more pairs: each needs some 200 bytes, and 4,096 bodies at one place make as
/// many.
inline constexpr std::size_t most_candidates = std::size_t{1} << 23;

/// Throws lod::Error, limit exceeded, where a list of pairs has grown beyond most_candidates.
void check_candidates(std::size_t pairs);

}  // namespace lod
