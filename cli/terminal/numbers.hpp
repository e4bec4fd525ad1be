#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "lodlab/core/math/linear.hpp"

namespace cli {

/// [x, y] or [x, y, z].
[[nodiscard]] nlohmann::ordered_json list_of(std::span<const double> vector);

/// A moment: a number in the plane, the rows of a matrix in space.
template <int Size>
[[nodiscard]] nlohmann::ordered_json moment_of(const lod::FixedMatrix<Size, Size>& moment);

/// "(1, 2)": the numbers as a reader wants them.
[[nodiscard]] std::string in_brackets(std::span<const double> vector, int digits = 6);

}  // namespace cli
