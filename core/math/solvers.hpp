#pragma once

#include <optional>
#include <string>

#include "lodlab/core/math/linear.hpp"

/// Small systems of linear equations, solved by Eigen, which only solvers.cpp sees.
namespace lod {

/// Whether a symmetric matrix is positive definite; false where a number is not finite.
template <int Size>
[[nodiscard]] bool is_positive_definite(const FixedMatrix<Size, Size>& matrix);

/// Requires a matrix that has an inverse.
template <int Size>
[[nodiscard]] FixedMatrix<Size, Size> inverse(const FixedMatrix<Size, Size>& matrix);

/// Unit vector of the direction in which a symmetric matrix stretches most; its sign means nothing.
template <int Dim>
[[nodiscard]] FixedMatrix<Dim, 1> principal_axis(const FixedMatrix<Dim, Dim>& matrix);

/// The point equally far from the origin and from the ends of `count` arms, nearest to the origin;
/// nothing where the arms are linearly dependent. Requires 1 <= count <= Dim.
template <int Dim>
[[nodiscard]] std::optional<FixedMatrix<Dim, 1>> equidistant(const FixedMatrix<Dim, 1>* arms,
                                                             int count);

/// The release of Eigen that these were compiled with: "3.4.0". Others have given the same bits,
/// and what is kept for later says which it was made with all the same.
[[nodiscard]] std::string solvers_release();

}  // namespace lod
