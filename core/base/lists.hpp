#pragma once

/// \file
/// Numbers of things as indices, and parts of lists.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lod {

/// A number of something, as an index into a list. Requires i >= 0.
[[nodiscard]] constexpr std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

/// A part of a list.
struct Range {
    std::int32_t first = 0;
    std::int32_t count = 0;
    friend bool operator==(const Range&, const Range&) = default;

    /// That part of a list. Requires: the list has it.
    template <class T>
    [[nodiscard]] std::span<const T> of(std::span<const T> list) const {
        return list.subspan(at(first), at(count));
    }
};

/// Makes a list `size` equal entries. Unlike assign it grows by doubling, so that a list whose size
/// wavers is rarely allocated anew.
template <class T>
void refill(std::vector<T>& list, std::size_t size, const T& value) {
    list.resize(size);
    std::fill(list.begin(), list.end(), value);
}

/// Asks for an object that will be needed soon.
template <class T>
void prefetch(const T& object) {
#if defined(__GNUC__)
    constexpr std::size_t line = 64;
    const auto* const bytes = reinterpret_cast<const char*>(&object);
    for (std::size_t i = 0; i < sizeof(T); i += line) __builtin_prefetch(bytes + i);
    __builtin_prefetch(bytes + sizeof(T) - 1);
#else
    (void)object;
#endif
}

/// Calls visit(number, place) for each number of a list, and fetch(number) some numbers before:
/// where it stands for things that lie far apart.
template <class Fetch, class Visit>
void each_fetched(std::span<const std::int32_t> list, const Fetch& fetch, const Visit& visit) {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i + ahead < list.size()) fetch(list[i + ahead]);
        visit(list[i], i);
    }
}

}  // namespace lod
