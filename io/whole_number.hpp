#pragma once

#include <limits>
#include <stdexcept>
#include <type_traits>

namespace io {

/// A whole number of a JSON text that fits. Throws std::invalid_argument for anything else: 3.0 and
/// 1e30 are none.
template <class Whole, class Json>
[[nodiscard]] Whole whole_number(const Json& json) {
    using Limits = std::numeric_limits<Whole>;
    if (json.is_number_unsigned()) {
        const auto number = json.template get<typename Json::number_unsigned_t>();
        if (number <= static_cast<std::make_unsigned_t<Whole>>((Limits::max)()))
            return static_cast<Whole>(number);
    } else if (json.is_number_integer()) {  // below 0
        const auto number = json.template get<typename Json::number_integer_t>();
        if (std::is_signed_v<Whole> && number >= static_cast<long long>((Limits::min)()))
            return static_cast<Whole>(number);
    }
    throw std::invalid_argument(json.dump() + " is no whole number that fits");
}

}  // namespace io
