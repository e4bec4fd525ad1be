#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cli {

/// [x, y] or [x, y, z].
[[nodiscard]] nlohmann::ordered_json list_of(const Eigen::Ref<const Eigen::VectorXd>& vector);

/// A moment: a number in the plane, the rows of a matrix in space.
[[nodiscard]] nlohmann::ordered_json moment_of(const Eigen::Ref<const Eigen::MatrixXd>& moment);

/// "(1, 2)": the numbers as a reader wants them.
[[nodiscard]] std::string in_brackets(const Eigen::Ref<const Eigen::VectorXd>& vector,
                                      int digits = 6);

}  // namespace cli
