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

/// So many candidate pairs a frame takes at most: some 200 bytes each, 900 MB. That many have 2,900
/// bodies at one place, or 50,000 of which each is near 160 others.
inline constexpr std::size_t most_candidates = std::size_t{1} << 22;

/// Throws Error, limit exceeded, where `candidates` are more.
void check_candidates(std::size_t candidates);

}  // namespace lod
