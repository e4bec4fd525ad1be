#include "lodlab/core/contact/hulls_apart.hpp"

#include <utility>

namespace lod {
namespace {

/// More than so many lines tell few more hulls apart.
constexpr int most_lines = 3;

/// The corner that lies highest along a line, and how high.
template <int Dim>
std::pair<double, const Vector<Dim>*> highest(std::span<const Vector<Dim>> corners,
                                              const Vector<Dim>& line) {
    std::pair<double, const Vector<Dim>*> best{line.dot(corners[0]), &corners[0]};
    for (const Vector<Dim>& corner : corners.subspan(1)) {
        const double height = line.dot(corner);
        if (height > best.first) best = {height, &corner};
    }
    return best;
}

}  // namespace

template <int Dim>
bool hulls_apart(std::span<const Vector<Dim>> a, std::span<const Vector<Dim>> b,
                 const Placement<Dim>& b_in_a, Vector<Dim> line, double slack) {
    if (a.empty() || b.empty()) return false;
    const Matrix<Dim> back = b_in_a.rotation.transpose();
    for (int i = 0; i < most_lines; ++i) {
        const auto [top, corner_a] = highest<Dim>(a, line);
        const auto [bottom, corner_b] = highest<Dim>(b, Vector<Dim>(-(back * line)));
        const double gap = line.dot(b_in_a.position) - top - bottom;
        if (gap > 0 && gap * gap > slack * slack * line.squaredNorm()) return true;
        line = b_in_a.carry(*corner_b) - *corner_a;
    }
    return false;
}

#define LOD_INSTANTIATE(Dim)                                                                   \
    template bool hulls_apart<Dim>(std::span<const Vector<Dim>>, std::span<const Vector<Dim>>, \
                                   const Placement<Dim>&, Vector<Dim>, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
