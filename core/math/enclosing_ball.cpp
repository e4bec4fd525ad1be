#include "lodlab/core/math/enclosing_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lodlab/core/math/solvers.hpp"

namespace lod {
namespace {

/// At most Dim + 2 points: a basis and the newcomer.
template <int Dim>
struct SupportSet {
    std::array<Vector<Dim>, Dim + 2> point;
    int count = 0;
};

/// The least ball with the points of the subset (bits of `chosen`) on its surface; nothing where
/// they are affinely dependent.
template <int Dim>
std::optional<Sphere<Dim>> ball_through(const SupportSet<Dim>& support, unsigned chosen) {
    std::array<Vector<Dim>, Dim> arms;
    int count = -1;
    Sphere<Dim> ball;
    for (int i = 0; i < support.count; ++i) {
        if ((chosen >> i & 1U) == 0) continue;
        const Vector<Dim>& p = support.point[static_cast<std::size_t>(i)];
        if (count < 0)
            ball.centre = p;
        else
            arms[static_cast<std::size_t>(count)] = p - ball.centre;
        ++count;
    }
    if (count < 1) return ball;
    const std::optional<Vector<Dim>> offset = equidistant<Dim>(arms.data(), count);
    if (!offset) return std::nullopt;
    ball.centre += *offset;
    ball.radius = offset->norm();
    return ball;
}

/// The least of the balls through a subset that hold all points of the set; keeps that subset.
template <int Dim>
std::optional<Sphere<Dim>> best_subset(SupportSet<Dim>& support) {
    std::optional<Sphere<Dim>> best;
    unsigned best_chosen = 0;
    const unsigned newcomer = 1U << (support.count - 1);
    for (unsigned chosen = newcomer; chosen < 2 * newcomer; ++chosen) {
        if (__builtin_popcount(chosen) > Dim + 1) continue;
        auto ball = ball_through<Dim>(support, chosen);
        if (!ball || !ball->centre.allFinite()) continue;
        double farthest = 0;
        for (int i = 0; i < support.count; ++i)
            farthest = std::max(farthest,
                                (support.point[static_cast<std::size_t>(i)] - ball->centre).norm());
        if (farthest > ball->radius * (1 + 1e-13) || (best && farthest >= best->radius)) continue;
        ball->radius = farthest;
        best = ball;
        best_chosen = chosen;
    }
    if (!best) return std::nullopt;
    SupportSet<Dim> kept;
    for (int i = 0; i < support.count; ++i)
        if (best_chosen >> i & 1U)
            kept.point[static_cast<std::size_t>(kept.count++)] =
                support.point[static_cast<std::size_t>(i)];
    support = kept;
    return best;
}

}  // namespace

template <int Dim>
double farthest_distance(const Vector<Dim>& centre, std::span<const Vector<Dim>> points) {
    double square = 0;
    for (const Vector<Dim>& p : points) square = std::max(square, (p - centre).squaredNorm());
    return std::sqrt(square);
}

template <int Dim>
Sphere<Dim> enclosing_ball(std::span<const Vector<Dim>> points) {
    if (points.empty()) return {};
    constexpr int most_rounds = 1000;  // each round's ball is larger; 30 were the most seen
    Sphere<Dim> ball{points[0], 0};
    SupportSet<Dim> basis;
    basis.point[0] = points[0];
    basis.count = 1;
    for (int round = 0; round < most_rounds; ++round) {
        const auto away = [&](const Vector<Dim>& p) { return (p - ball.centre).squaredNorm(); };
        const auto farthest =
            std::max_element(points.begin(), points.end(),
                             [&](const auto& p, const auto& q) { return away(p) < away(q); });
        if (std::sqrt(away(*farthest)) <= ball.radius * (1 + 1e-14)) break;
        basis.point[static_cast<std::size_t>(basis.count++)] = *farthest;
        const auto next = best_subset<Dim>(basis);
        if (!next || next->radius <= ball.radius) break;  // as good as rounding allows
        ball = *next;
    }
    ball.radius = farthest_distance<Dim>(ball.centre, points);
    return ball;
}

template double farthest_distance<2>(const Vector<2>&, std::span<const Vector<2>>);
template double farthest_distance<3>(const Vector<3>&, std::span<const Vector<3>>);
template Sphere<2> enclosing_ball<2>(std::span<const Vector<2>>);
template Sphere<3> enclosing_ball<3>(std::span<const Vector<3>>);

}  // namespace lod
