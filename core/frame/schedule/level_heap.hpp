#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lod {

/// The next level of a pair.
struct WaitingLevel {
    double value = 0;
    std::int32_t tier = 0;  ///< lower ones first, whatever the value
    std::int32_t pair = 0;
    std::uint64_t tests = 0;
};

/// Levels that wait: the lowest tier first, in it the largest value, ties by the pair's number.
/// Keeps its storage.
class LevelHeap {
  public:
    void clear();
    /// Appends one; before the next pop, all must be put in order.
    void append(const WaitingLevel& waiting);
    void put_in_order();
    void push(const WaitingLevel& waiting);
    [[nodiscard]] WaitingLevel pop();
    [[nodiscard]] bool empty() const { return heap_.empty(); }
    [[nodiscard]] std::size_t size() const { return heap_.size(); }
    /// No level that waits takes fewer tests.
    [[nodiscard]] std::uint64_t least_tests() const;

  private:
    static bool comes_later(const WaitingLevel& x, const WaitingLevel& y);

    std::vector<WaitingLevel> heap_;
    std::array<std::int32_t, 65> of_size_{};  ///< by the bits of their tests
};

}  // namespace lod
