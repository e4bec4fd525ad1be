#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/tree/traversal.hpp"

namespace lod {

/// Which pairs go to their entry levels where there is no time for all.
///
/// Keeps its storage: a warm call allocates nothing.
class Entries {
  public:
    /// Marks as by_roots all fronts of pairs that meet but the `most` of the largest weight, ties
    /// by number; with no weights, but the first ones. Takes linear time.
    void choose(std::uint64_t most, std::span<const double> weights, std::span<ListedFront> fronts);

  private:
    std::vector<std::int32_t> meeting_;
};

}  // namespace lod
