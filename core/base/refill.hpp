#pragma once

#include <algorithm>
#include <vector>

namespace lod {

/// Makes a list `size` equal entries. Unlike assign it grows by doubling, so that a list whose size
/// wavers is rarely allocated anew.
template <class T>
void refill(std::vector<T>& list, std::size_t size, const T& value) {
    list.resize(size);
    std::fill(list.begin(), list.end(), value);
}

}  // namespace lod
