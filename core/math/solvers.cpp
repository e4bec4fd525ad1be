// The one file of the library that is compiled with Eigen. Its Eigen has a name of its own, since a
// program's Eigen may be set up in another way (alignment, allocator, instruction set, release),
// and the linker would keep one version of each function for both. Nothing here may use fused or
// approximate instructions.
#define Eigen lodlab_eigen
#define EIGEN_DONT_VECTORIZE
#define EIGEN_FAST_MATH 0
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "lodlab/core/math/solvers.hpp"

namespace lod {
namespace {

template <int Rows, int Cols>
Eigen::Matrix<double, Rows, Cols> inside(const FixedMatrix<Rows, Cols>& matrix) {
    return Eigen::Map<const Eigen::Matrix<double, Rows, Cols>>(matrix.data());
}

template <int Rows, int Cols>
FixedMatrix<Rows, Cols> outside(const Eigen::Matrix<double, Rows, Cols>& matrix) {
    FixedMatrix<Rows, Cols> result;
    std::copy_n(matrix.data(), Rows * Cols, result.data());
    return result;
}

template <int Size>
auto eigenvectors_of(const Eigen::Matrix<double, Size, Size>& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>>(symmetric)
        .eigenvectors()
        .eval();
}

/// The same numbers: two rows are tridiagonal as they are, and Eigen's general way to get there
/// takes longer to compile than the rest of this file.
Eigen::Matrix2d eigenvectors_of(const Eigen::Matrix2d& symmetric) {
    double scale = symmetric.cwiseAbs().maxCoeff();
    if (scale == 0) scale = 1;
    const Eigen::Vector2d diagonal(symmetric(0, 0) / scale, symmetric(1, 1) / scale);
    const Eigen::Matrix<double, 1, 1> below(symmetric(1, 0) / scale);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    return solver.computeFromTridiagonal(diagonal, below).eigenvectors();
}

}  // namespace

template <int Size>
bool is_positive_definite(const FixedMatrix<Size, Size>& matrix) {
    return matrix.allFinite() && inside(matrix).llt().info() == Eigen::Success;
}

template <int Size>
FixedMatrix<Size, Size> inverse(const FixedMatrix<Size, Size>& matrix) {
    const Eigen::Matrix<double, Size, Size> result = inside(matrix).inverse();
    return outside(result);
}

template <int Dim>
FixedMatrix<Dim, 1> principal_axis(const FixedMatrix<Dim, Dim>& matrix) {
    const Eigen::Matrix<double, Dim, 1> axis = eigenvectors_of(inside(matrix)).col(Dim - 1);
    return outside(axis);
}

template <int Dim>
std::optional<FixedMatrix<Dim, 1>> equidistant(const FixedMatrix<Dim, 1>* arms, int count) {
    using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Dim, Dim>;
    using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Dim, 1>;
    Gram gram(count, count);
    Column squares(count);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) gram(i, j) = 2 * arms[i].dot(arms[j]);
        squares[i] = arms[i].squaredNorm();
    }
    const Eigen::FullPivLU<Gram> factors(gram);
    if (!factors.isInvertible()) return std::nullopt;
    const Column share = factors.solve(squares);
    auto offset = FixedMatrix<Dim, 1>::Zero();
    for (int i = 0; i < count; ++i) offset += share[i] * arms[i];
    return offset;
}

std::string solvers_release() {
    return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
           std::to_string(EIGEN_MINOR_VERSION);
}

#define LOD_INSTANTIATE(Dim)                                                   \
    template FixedMatrix<Dim, 1> principal_axis(const FixedMatrix<Dim, Dim>&); \
    template std::optional<FixedMatrix<Dim, 1>> equidistant(const FixedMatrix<Dim, 1>*, int);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

template bool is_positive_definite(const FixedMatrix<1, 1>&);
template bool is_positive_definite(const FixedMatrix<3, 3>&);
template FixedMatrix<1, 1> inverse(const FixedMatrix<1, 1>&);
template FixedMatrix<3, 3> inverse(const FixedMatrix<3, 3>&);

}  // namespace lod
