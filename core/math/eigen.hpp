#pragma once

/// \file
/// lodlab's vectors as Eigen's and back, for programs that compute with Eigen. It alone needs
/// Eigen, so <lodlab/core.hpp> is without it.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "lodlab/core/math/linear.hpp"

/// lodlab's vectors as Eigen's and back, for programs that compute with Eigen. The library itself
/// never sees the Eigen of a program: whatever its settings and release are, nothing changes here.
namespace lod {

/// The same numbers as Eigen's.
template <int Rows, int Cols>
[[nodiscard]] LOD_INLINE auto to_eigen(const FixedMatrix<Rows, Cols>& matrix) {
    Eigen::Matrix<double, Rows, Cols> result;
    for (int r = 0; r < Rows; ++r)
        for (int c = 0; c < Cols; ++c) result(r, c) = matrix(r, c);
    return result;
}

/// The same rotation as Eigen's.
[[nodiscard]] LOD_INLINE auto to_eigen(const Quaternion& q) {
    return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z());
}

/// Of any expression whose size is known when it is compiled.
template <class Expression>
[[nodiscard]] LOD_INLINE auto from_eigen(const Eigen::MatrixBase<Expression>& expression) {
    constexpr int rows = Expression::RowsAtCompileTime;
    constexpr int cols = Expression::ColsAtCompileTime;
    static_assert(rows > 0 && cols > 0, "lodlab's vectors have a fixed size");
    const Eigen::Matrix<double, rows, cols> values = expression;
    FixedMatrix<rows, cols> result;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < cols; ++c) result(r, c) = values(r, c);
    return result;
}

/// Of a quaternion of doubles.
template <class Expression>
[[nodiscard]] LOD_INLINE Quaternion
from_eigen(const Eigen::QuaternionBase<Expression>& quaternion) {
    return {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
}

}  // namespace lod
