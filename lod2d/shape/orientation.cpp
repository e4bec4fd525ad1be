#include "lodlab/lod2d/shape/orientation.hpp"

#include <algorithm>
#include <cmath>

namespace lod2d {
namespace {

/// A sum kept without rounding, as parts that do not overlap, smallest first.
class ExactSum {
  public:
    void add(double value) {
        int kept = 0;
        for (int i = 0; i < count_; ++i) {
            const double sum = value + part_[i];
            const double shifted = sum - value;
            const double error = (value - (sum - shifted)) + (part_[i] - shifted);
            if (error != 0) part_[kept++] = error;
            value = sum;
        }
        if (value != 0 || kept == 0) part_[kept++] = value;
        count_ = kept;
    }

    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    [[nodiscard]] int sign() const {
        const double largest = part_[count_ - 1];
        return (largest > 0) - (largest < 0);
    }

  private:
    double part_[16] = {0};
    int count_ = 1;
};

int exact_orientation(const Point& a, const Point& b, const Point& c) {
    ExactSum sum;
    sum.add_product(a.x(), b.y());
    sum.add_product(-a.x(), c.y());
    sum.add_product(-c.x(), b.y());
    sum.add_product(-a.y(), b.x());
    sum.add_product(a.y(), c.x());
    sum.add_product(c.y(), b.x());
    return sum.sign();
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right;
    constexpr double filter = 3.3306690738754716e-16;  // (3 + 16 u) u with u = 2^-53
    if (std::abs(determinant) > filter * (std::abs(left) + std::abs(right)))
        return determinant > 0 ? 1 : -1;
    return exact_orientation(a, b, c);
}

bool on_segment(const Point& a, const Point& b, const Point& c) {
    return std::min(a.x(), b.x()) <= c.x() && c.x() <= std::max(a.x(), b.x()) &&
           std::min(a.y(), b.y()) <= c.y() && c.y() <= std::max(a.y(), b.y()) &&
           orientation(a, b, c) == 0;
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int side_c = orientation(a, b, c);
    const int side_d = orientation(a, b, d);
    const int side_a = orientation(c, d, a);
    const int side_b = orientation(c, d, b);
    if (side_c * side_d < 0 && side_a * side_b < 0) return true;
    return (side_c == 0 && on_segment(a, b, c)) || (side_d == 0 && on_segment(a, b, d)) ||
           (side_a == 0 && on_segment(c, d, a)) || (side_b == 0 && on_segment(c, d, b));
}

}  // namespace lod2d
