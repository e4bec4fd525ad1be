#pragma once

#include <string>

namespace viz {

/// A number as a reader expects it: `digits` significant ones, a true minus sign, thin spaces
/// between thousands, powers of ten beyond 1e6 and below 1e-4. The same text on every machine.
[[nodiscard]] std::string number_text(double value, int digits = 3);

/// An exponent in raised digits: "⁻¹⁶".
[[nodiscard]] std::string superscript(int exponent);

/// The number, a space and the unit: "0.25 m".
[[nodiscard]] std::string quantity_text(double value, const std::string& unit, int digits = 3);

/// A length in the unit that suits it: "2 m", "5 cm", "3 mm", "4 km".
[[nodiscard]] std::string length_text(double metres);

/// With a fixed number of decimals, for numbers that change while one looks: "0.250".
[[nodiscard]] std::string fixed_text(double value, int decimals);

/// "1 node", "12 nodes"; "2 bodies".
[[nodiscard]] std::string count_text(long long count, const std::string& noun);

}  // namespace viz
