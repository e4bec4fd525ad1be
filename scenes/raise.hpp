#pragma once

#include <algorithm>

namespace scenes {

/// Multiplies a limit by a factor >= 1, up to what every count can hold.
template <class Limit>
void raise(Limit& limit, double factor) {
    constexpr double most = 9e18;
    limit = static_cast<Limit>((std::min)(static_cast<double>(limit) * factor, most));
}

}  // namespace scenes
