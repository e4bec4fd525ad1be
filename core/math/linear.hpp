#pragma once

/// \file
/// Vectors, matrices and quaternions of fixed size, called as Eigen's are, with one layout and one
/// order of sums.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include "lodlab/core/base/bits.hpp"

/// Vectors, matrices and quaternions of the method: of fixed size, plain rows of doubles with the
/// alignment of a double. Their layout follows from the types alone, and every sum is taken in the
/// order in which it is written, so that neither a compiler's flags nor an instruction set nor a
/// library's release changes a size or a bit. core/math/eigen.hpp takes them to Eigen's and back.
namespace lod {

/// Rows x Cols doubles, by columns; a column vector where Cols is 1. As a built-in array, it holds
/// no set value until one is given.
template <int Rows, int Cols>
struct FixedMatrix {
    static_assert(Rows > 0 && Cols > 0);
    static constexpr bool is_vector = Cols == 1;

    double entry[Rows * Cols];  ///< (row, column) stands at row + Rows * column

    FixedMatrix() = default;

    /// From its numbers as they are read: row by row.
    template <class... Number>
    requires(sizeof...(Number) == Rows * Cols && sizeof...(Number) > 1 &&
             (std::convertible_to<Number, double> && ...)) LOD_INLINE
        constexpr FixedMatrix(Number... number) {  // NOLINT: a list of numbers is a vector
        const double by_rows[] = {static_cast<double>(number)...};
        for (int r = 0; r < Rows; ++r)
            for (int c = 0; c < Cols; ++c) (*this)(r, c) = by_rows[r * Cols + c];
    }

    /// As Eigen's of the same name.
    /// @{
    LOD_INLINE static constexpr FixedMatrix Constant(double value) {
        FixedMatrix m;
        for (double& number : m.entry) number = value;
        return m;
    }
    LOD_INLINE static constexpr FixedMatrix Zero() { return Constant(0); }
    LOD_INLINE static constexpr FixedMatrix Identity() requires(Rows == Cols) {
        FixedMatrix m = Zero();
        for (int i = 0; i < Rows; ++i) m(i, i) = 1;
        return m;
    }
    LOD_INLINE static constexpr FixedMatrix Unit(int axis) requires(is_vector) {
        FixedMatrix m = Zero();
        m.entry[axis] = 1;
        return m;
    }
    LOD_INLINE static constexpr FixedMatrix UnitX() { return Unit(0); }
    LOD_INLINE static constexpr FixedMatrix UnitY() { return Unit(1); }
    LOD_INLINE static constexpr FixedMatrix UnitZ() { return Unit(2); }
    /// @}

    /// As Eigen's of the same name.
    /// @{
    [[nodiscard]] LOD_INLINE static constexpr int size() { return Rows * Cols; }
    [[nodiscard]] LOD_INLINE static constexpr int rows() { return Rows; }
    [[nodiscard]] LOD_INLINE static constexpr int cols() { return Cols; }

    template <std::integral Index>
    [[nodiscard]] LOD_INLINE constexpr double& operator[](Index i) requires(is_vector) {
        return entry[i];
    }
    template <std::integral Index>
    [[nodiscard]] LOD_INLINE constexpr const double& operator[](Index i) const requires(is_vector) {
        return entry[i];
    }
    [[nodiscard]] LOD_INLINE constexpr double& operator()(int r, int c) {
        return entry[r + Rows * c];
    }
    [[nodiscard]] LOD_INLINE constexpr const double& operator()(int r, int c) const {
        return entry[r + Rows * c];
    }
    [[nodiscard]] LOD_INLINE constexpr double& x() { return at<0>(*this); }
    [[nodiscard]] LOD_INLINE constexpr double& y() { return at<1>(*this); }
    [[nodiscard]] LOD_INLINE constexpr double& z() { return at<2>(*this); }
    [[nodiscard]] LOD_INLINE constexpr const double& x() const { return at<0>(*this); }
    [[nodiscard]] LOD_INLINE constexpr const double& y() const { return at<1>(*this); }
    [[nodiscard]] LOD_INLINE constexpr const double& z() const { return at<2>(*this); }
    [[nodiscard]] LOD_INLINE constexpr double* data() { return entry; }
    [[nodiscard]] LOD_INLINE constexpr const double* data() const { return entry; }
    [[nodiscard]] LOD_INLINE constexpr double* begin() { return entry; }
    [[nodiscard]] LOD_INLINE constexpr double* end() { return entry + Rows * Cols; }
    [[nodiscard]] LOD_INLINE constexpr const double* begin() const { return entry; }
    [[nodiscard]] LOD_INLINE constexpr const double* end() const { return entry + Rows * Cols; }

    LOD_INLINE constexpr void setZero() { *this = Zero(); }
    /// @}

    /// Number by number.
    /// @{
    LOD_INLINE constexpr FixedMatrix& operator+=(const FixedMatrix& b) {
        for (int i = 0; i < Rows * Cols; ++i) entry[i] += b.entry[i];
        return *this;
    }
    LOD_INLINE constexpr FixedMatrix& operator-=(const FixedMatrix& b) {
        for (int i = 0; i < Rows * Cols; ++i) entry[i] -= b.entry[i];
        return *this;
    }
    LOD_INLINE constexpr FixedMatrix& operator*=(double s) {
        for (double& number : entry) number *= s;
        return *this;
    }
    LOD_INLINE constexpr FixedMatrix& operator/=(double s) {
        for (double& number : entry) number /= s;
        return *this;
    }
    LOD_INLINE friend constexpr FixedMatrix operator+(FixedMatrix a, const FixedMatrix& b) {
        return a += b;
    }
    LOD_INLINE friend constexpr FixedMatrix operator-(FixedMatrix a, const FixedMatrix& b) {
        return a -= b;
    }
    LOD_INLINE friend constexpr FixedMatrix operator-(FixedMatrix a) {
        for (double& number : a.entry) number = -number;
        return a;
    }
    LOD_INLINE friend constexpr FixedMatrix operator*(FixedMatrix a, double s) { return a *= s; }
    LOD_INLINE friend constexpr FixedMatrix operator*(double s, FixedMatrix a) { return a *= s; }
    LOD_INLINE friend constexpr FixedMatrix operator/(FixedMatrix a, double s) { return a /= s; }
    LOD_INLINE friend constexpr bool operator==(const FixedMatrix& a, const FixedMatrix& b) {
        for (int i = 0; i < Rows * Cols; ++i)
            if (a.entry[i] != b.entry[i]) return false;
        return true;
    }
    /// @}

    /// As Eigen's of the same name; set_col sets a column.
    /// @{
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<Cols, Rows> transpose() const {
        FixedMatrix<Cols, Rows> m;
        for (int r = 0; r < Rows; ++r)
            for (int c = 0; c < Cols; ++c) m(c, r) = (*this)(r, c);
        return m;
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<Rows, 1> col(int c) const {
        FixedMatrix<Rows, 1> v;
        for (int r = 0; r < Rows; ++r) v.entry[r] = (*this)(r, c);
        return v;
    }
    LOD_INLINE constexpr void set_col(int c, const FixedMatrix<Rows, 1>& v) {
        for (int r = 0; r < Rows; ++r) (*this)(r, c) = v.entry[r];
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<Rows, 1> diagonal() const
        requires(Rows == Cols) {
        FixedMatrix<Rows, 1> v;
        for (int r = 0; r < Rows; ++r) v.entry[r] = (*this)(r, r);
        return v;
    }
    /// @}
    /// The square matrix with this vector on its diagonal.
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<Rows, Rows> asDiagonal() const
        requires(is_vector) {
        FixedMatrix<Rows, Rows> m = FixedMatrix<Rows, Rows>::Zero();
        for (int i = 0; i < Rows; ++i) m(i, i) = entry[i];
        return m;
    }

    /// As Eigen's of the same name.
    /// @{
    [[nodiscard]] LOD_INLINE constexpr double dot(const FixedMatrix& b) const requires(is_vector) {
        double sum = entry[0] * b.entry[0];
        for (int i = 1; i < Rows; ++i) sum += entry[i] * b.entry[i];
        return sum;
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cross(const FixedMatrix& b) const
        requires(Rows == 3 && is_vector) {
        return {y() * b.z() - z() * b.y(), z() * b.x() - x() * b.z(), x() * b.y() - y() * b.x()};
    }
    /// @}
    /// A unit vector across this one. Requires that it is not zero.
    [[nodiscard]] LOD_INLINE FixedMatrix unitOrthogonal() const requires(Rows == 3 && is_vector) {
        const double most_along_z = 1e-12 * std::abs(z());
        return std::abs(x()) > most_along_z || std::abs(y()) > most_along_z
                   ? FixedMatrix(-y(), x(), 0).normalized()
                   : FixedMatrix(0, -z(), y()).normalized();
    }
    /// As Eigen's of the same name, in the order in which the numbers stand.
    /// @{
    [[nodiscard]] LOD_INLINE constexpr double sum() const {
        double total = entry[0];
        for (int i = 1; i < Rows * Cols; ++i) total += entry[i];
        return total;
    }
    [[nodiscard]] LOD_INLINE constexpr double trace() const requires(Rows == Cols) {
        return diagonal().sum();
    }
    [[nodiscard]] LOD_INLINE constexpr double squaredNorm() const {
        double total = entry[0] * entry[0];
        for (int i = 1; i < Rows * Cols; ++i) total += entry[i] * entry[i];
        return total;
    }
    [[nodiscard]] LOD_INLINE double norm() const { return std::sqrt(squaredNorm()); }
    /// @}
    /// Of length 1; itself where it has no length.
    [[nodiscard]] LOD_INLINE FixedMatrix normalized() const {
        const double square = squaredNorm();
        return square > 0 ? *this / std::sqrt(square) : *this;
    }
    /// Makes it normalized().
    LOD_INLINE void normalize() { *this = normalized(); }
    /// The norm, also where the squares of its numbers overflow or underflow.
    [[nodiscard]] LOD_INLINE double stableNorm() const {
        const double most = cwiseAbs().maxCoeff();
        if (!(most > 0) || !std::isfinite(most)) return most == 0 ? 0 : norm();
        constexpr double largest = (std::numeric_limits<double>::max)();
        if (1 / most > largest) return (*this * largest).norm() / largest;  // subnormal numbers
        return most * (*this * (1 / most)).norm();
    }
    /// As normalized(), also where the squares of its numbers overflow or underflow.
    [[nodiscard]] LOD_INLINE FixedMatrix stableNormalized() const {
        const double most = cwiseAbs().maxCoeff();
        const double square = (*this / most).squaredNorm();
        return square > 0 ? *this / (std::sqrt(square) * most) : *this;
    }

    /// As Eigen's of the same name.
    /// @{
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseAbs() const {
        FixedMatrix m = *this;
        for (double& number : m.entry) number = std::abs(number);
        return m;
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseMin(const FixedMatrix& b) const {
        FixedMatrix m;
        for (int i = 0; i < Rows * Cols; ++i) m.entry[i] = least_of(entry[i], b.entry[i]);
        return m;
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseMax(const FixedMatrix& b) const {
        FixedMatrix m;
        for (int i = 0; i < Rows * Cols; ++i) m.entry[i] = most_of(entry[i], b.entry[i]);
        return m;
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseMin(double b) const {
        return cwiseMin(Constant(b));
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseMax(double b) const {
        return cwiseMax(Constant(b));
    }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix cwiseProduct(const FixedMatrix& b) const {
        FixedMatrix m;
        for (int i = 0; i < Rows * Cols; ++i) m.entry[i] = entry[i] * b.entry[i];
        return m;
    }
    /// @}
    /// Each rounded to the nearest whole number, halves away from 0.
    [[nodiscard]] LOD_INLINE FixedMatrix cwiseRound() const {
        FixedMatrix m = *this;
        for (double& number : m.entry) number = std::round(number);
        return m;
    }
    /// Whether each number is no more than the other's at its place.
    [[nodiscard]] LOD_INLINE constexpr bool all_at_most(const FixedMatrix& b) const {
        for (int i = 0; i < Rows * Cols; ++i)
            if (!(entry[i] <= b.entry[i])) return false;
        return true;
    }
    /// Whether any number is less than the other's at its place.
    [[nodiscard]] LOD_INLINE constexpr bool any_below(const FixedMatrix& b) const {
        for (int i = 0; i < Rows * Cols; ++i)
            if (entry[i] < b.entry[i]) return true;
        return false;
    }
    /// The largest number.
    [[nodiscard]] LOD_INLINE constexpr double maxCoeff() const {
        double most = entry[0];
        for (int i = 1; i < Rows * Cols; ++i) most = most_of(most, entry[i]);
        return most;
    }
    /// Where the largest number stands, the first of equal ones.
    [[nodiscard]] LOD_INLINE constexpr int most_place() const requires(is_vector) {
        int place = 0;
        for (int i = 1; i < Rows; ++i)
            if (entry[i] > entry[place]) place = i;
        return place;
    }
    /// Whether no number is infinite or none.
    [[nodiscard]] LOD_INLINE bool allFinite() const {
        for (const double number : entry)
            if (!std::isfinite(number)) return false;
        return true;
    }
    /// Whether no number is further from 0 than `most`.
    [[nodiscard]] LOD_INLINE constexpr bool isZero(double most = 1e-12) const {
        for (const double number : entry)
            if (!(std::abs(number) <= most)) return false;
        return true;
    }
    /// Whether the difference is no longer than `share` of the shorter of the two.
    [[nodiscard]] LOD_INLINE constexpr bool isApprox(const FixedMatrix& b,
                                                     double share = 1e-12) const {
        return (*this - b).squaredNorm() <=
               share * share * least_of(squaredNorm(), b.squaredNorm());
    }

  private:
    template <int Place, class Self>
    LOD_INLINE static constexpr auto& at(Self& self) {
        static_assert(is_vector && Place < Rows);
        return self.entry[Place];
    }
    LOD_INLINE static constexpr double least_of(double a, double b) { return b < a ? b : a; }
    LOD_INLINE static constexpr double most_of(double a, double b) { return a < b ? b : a; }
};

/// The product; every entry is summed in the order of the row.
template <int Rows, int Middle, int Cols>
[[nodiscard]] LOD_INLINE constexpr FixedMatrix<Rows, Cols> operator*(
    const FixedMatrix<Rows, Middle>& a, const FixedMatrix<Middle, Cols>& b) {
    FixedMatrix<Rows, Cols> product;
    for (int c = 0; c < Cols; ++c)
        for (int r = 0; r < Rows; ++r) {
            double sum = a(r, 0) * b(0, c);
            for (int k = 1; k < Middle; ++k) sum += a(r, k) * b(k, c);
            product(r, c) = sum;
        }
    return product;
}

/// A quaternion; a rotation where its norm is 1. Stored as x, y, z, w.
class Quaternion {
  public:
    Quaternion() = default;
    /// As Eigen's of the same name; of_coeffs takes what coeffs() gives.
    /// @{
    LOD_INLINE constexpr Quaternion(double w, double x, double y, double z) : q_{x, y, z, w} {}
    LOD_INLINE static constexpr Quaternion Identity() { return {1, 0, 0, 0}; }
    LOD_INLINE static constexpr Quaternion of_coeffs(const FixedMatrix<4, 1>& xyzw) {
        return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
    }

    [[nodiscard]] LOD_INLINE constexpr const double& x() const { return q_[0]; }
    [[nodiscard]] LOD_INLINE constexpr const double& y() const { return q_[1]; }
    [[nodiscard]] LOD_INLINE constexpr const double& z() const { return q_[2]; }
    [[nodiscard]] LOD_INLINE constexpr const double& w() const { return q_[3]; }
    [[nodiscard]] LOD_INLINE constexpr const FixedMatrix<4, 1>& coeffs() const { return q_; }
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<3, 1> vec() const { return {x(), y(), z()}; }

    [[nodiscard]] LOD_INLINE constexpr double dot(const Quaternion& b) const {
        return q_.dot(b.q_);
    }
    [[nodiscard]] LOD_INLINE double norm() const { return q_.norm(); }
    [[nodiscard]] LOD_INLINE Quaternion normalized() const { return of_coeffs(q_.normalized()); }
    [[nodiscard]] LOD_INLINE constexpr Quaternion conjugate() const {
        return {w(), -x(), -y(), -z()};
    }
    LOD_INLINE friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
        return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
                a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
                a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
                a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x()};
    }
    LOD_INLINE friend constexpr bool operator==(const Quaternion& a, const Quaternion& b) {
        return a.q_ == b.q_;
    }
    /// @}

    /// Requires a norm of 1.
    [[nodiscard]] LOD_INLINE constexpr FixedMatrix<3, 3> toRotationMatrix() const {
        const double tx = 2 * x();
        const double ty = 2 * y();
        const double tz = 2 * z();
        const double twx = tx * w();
        const double twy = ty * w();
        const double twz = tz * w();
        const double txx = tx * x();
        const double txy = ty * x();
        const double txz = tz * x();
        const double tyy = ty * y();
        const double tyz = tz * y();
        const double tzz = tz * z();
        return {1 - (tyy + tzz), txy - twz,       txz + twy,  //
                txy + twz,       1 - (txx + tzz), tyz - twx,  //
                txz - twy,       tyz + twx,       1 - (txx + tyy)};
    }

  private:
    FixedMatrix<4, 1> q_;
};

}  // namespace lod
