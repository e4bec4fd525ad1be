#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/lists.hpp"

namespace lod {

/// The numbers of the pairs that each body is in. Keeps its storage.
class PairsOfBodies {
  public:
    /// By counting: `each` calls what it is given with every body of a pair, and that pair.
    template <class Each>
    void list(std::size_t bodies, const Each& each) {
        refill(begin_, bodies + 1, 0);
        each([&](std::int32_t body, std::int32_t) { ++begin_[at(body) + 1]; });
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        pairs_.resize(at(begin_.back()));
        each([&](std::int32_t body, std::int32_t pair) { pairs_[at(begin_[at(body)]++)] = pair; });
        // Every begin has moved on to its end, the next one's begin.
        std::shift_right(begin_.begin(), begin_.end(), 1);
        begin_.front() = 0;
    }
    /// Of one body, in the order of their numbers.
    [[nodiscard]] std::span<const std::int32_t> of(std::int32_t body) const {
        const std::int32_t first = begin_[at(body)];
        return std::span(pairs_).subspan(at(first), at(begin_[at(body) + 1] - first));
    }

  private:
    std::vector<std::int32_t> begin_;
    std::vector<std::int32_t> pairs_;
};

}  // namespace lod
