#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lessons {

/// A number as a reader typed it.
struct TypedNumber {
    std::vector<double>
        values;        ///< its readings, the likeliest first ("1,380" has two); empty: none
    std::string unit;  ///< what follows it, signs written plainly: "m/s2"
};

/// Reads "0.418", "0,418 N s", "−3 cm", "24 180", "1,380.5", "4/3 m", "2e-3". What is no finite
/// number has no value.
[[nodiscard]] TypedNumber read_number(std::string_view typed);

/// A unit in other words, as read_number writes it: "m²/s" -> "m2/s", "N s" -> "ns".
[[nodiscard]] std::string plain_unit(std::string_view unit);

/// What a unit measures and how large it is: "cm" is a length of 0.01. An unknown one measures
/// nothing.
struct UnitSize {
    std::string_view measures;
    double size = 1;
};

/// Of a unit as read_number writes it; none, and %, are of a share.
[[nodiscard]] UnitSize size_of(std::string_view plain_unit);

}  // namespace lessons
