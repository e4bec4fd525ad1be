#include "lodlab/core/builder/seeds.hpp"

#include <algorithm>

#include "lodlab/core/math/solvers.hpp"

namespace lod {
namespace {

template <int Dim>
Vector<Dim> mean_of(std::span<const Vector<Dim>> points) {
    Vector<Dim> sum = Vector<Dim>::Zero();
    for (const Vector<Dim>& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

}  // namespace

template <int Dim>
std::vector<Sphere<Dim>> far_apart(std::span<const Vector<Dim>> points, int count) {
    std::vector<Sphere<Dim>> seeds;
    if (points.empty()) return seeds;
    const Vector<Dim> mean = mean_of<Dim>(points);
    std::vector<double> gap;  // squared distance to the nearest seed so far
    for (const Vector<Dim>& p : points) gap.push_back((p - mean).squaredNorm());
    while (static_cast<int>(seeds.size()) < count) {
        const auto farthest = std::max_element(gap.begin(), gap.end());
        if (*farthest == 0 && !seeds.empty()) break;
        const Vector<Dim> seed = points[static_cast<std::size_t>(farthest - gap.begin())];
        seeds.push_back({seed, 0});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double to_seed = (points[i] - seed).squaredNorm();
            gap[i] = seeds.size() == 1 ? to_seed : std::min(gap[i], to_seed);
        }
    }
    return seeds;
}

template <int Dim>
std::vector<Sphere<Dim>> along_longest_axis(std::span<const Vector<Dim>> points, int count) {
    if (points.empty()) return {};
    const Vector<Dim> mean = mean_of<Dim>(points);
    Matrix<Dim> spread = Matrix<Dim>::Zero();
    for (const Vector<Dim>& p : points) spread += (p - mean) * (p - mean).transpose();
    const Vector<Dim> axis = principal_axis<Dim>(spread);
    double low = 0;
    double high = 0;
    for (const Vector<Dim>& p : points) {
        low = std::min(low, axis.dot(p - mean));
        high = std::max(high, axis.dot(p - mean));
    }
    std::vector<Sphere<Dim>> seeds;
    for (int i = 0; i < count; ++i)
        seeds.push_back({mean + (low + (high - low) * (i + 0.5) / count) * axis, 0});
    return seeds;
}

template std::vector<Sphere<2>> far_apart<2>(std::span<const Vector<2>>, int);
template std::vector<Sphere<3>> far_apart<3>(std::span<const Vector<3>>, int);
template std::vector<Sphere<2>> along_longest_axis<2>(std::span<const Vector<2>>, int);
template std::vector<Sphere<3>> along_longest_axis<3>(std::span<const Vector<3>>, int);

}  // namespace lod
