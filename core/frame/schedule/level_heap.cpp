#include "lodlab/core/frame/schedule/level_heap.hpp"

#include <algorithm>

namespace lod {
namespace {

/// How many binary digits a number has.
std::size_t digits(std::uint64_t number) {
    std::size_t count = 0;
    for (; number > 0; number >>= 1) ++count;
    return count;
}

}  // namespace

bool LevelHeap::comes_later(const WaitingLevel& x, const WaitingLevel& y) {
    if (x.tier != y.tier) return x.tier > y.tier;
    return x.value != y.value ? x.value < y.value : x.pair > y.pair;
}

void LevelHeap::clear() {
    heap_.clear();
    of_size_.fill(0);
}

void LevelHeap::append(const WaitingLevel& waiting) {
    heap_.push_back(waiting);
    ++of_size_[digits(waiting.tests)];
}

void LevelHeap::put_in_order() {
    std::make_heap(heap_.begin(), heap_.end(), comes_later);
}

void LevelHeap::push(const WaitingLevel& waiting) {
    append(waiting);
    std::push_heap(heap_.begin(), heap_.end(), comes_later);
}

WaitingLevel LevelHeap::pop() {
    std::pop_heap(heap_.begin(), heap_.end(), comes_later);
    const WaitingLevel next = heap_.back();
    heap_.pop_back();
    --of_size_[digits(next.tests)];
    return next;
}

std::uint64_t LevelHeap::least_tests() const {
    for (std::size_t size = 1; size < of_size_.size(); ++size)
        if (of_size_[size] > 0) return std::uint64_t{1} << (size - 1);
    return 0;
}

}  // namespace lod
