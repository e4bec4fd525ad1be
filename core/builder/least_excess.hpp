#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lodlab/core/builder/protrusion.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"

namespace lod {

/// How far the walk to the least excess goes.
struct ExcessWalk {
    double step = 0;        ///< the first one's length [m], > 0
    double least_step = 0;  ///< it ends where a shorter one would be taken [m], > 0
    double most_radius = std::numeric_limits<double>::infinity();  ///< of the ball [m]
    /// It ends where the excess is no more [m]: 0 where standing out by nothing is good enough.
    double enough = -std::numeric_limits<double>::infinity();
};

namespace detail {

/// The ways to the sides and the corners of a square or cube, unit vectors: four and four in the
/// plane, six and eight in space.
template <int Dim>
auto compass() {
    constexpr int corners = 1 << Dim;
    std::array<Vector<Dim>, 2 * Dim + corners> ways;
    for (int d = 0; d < Dim; ++d) {
        ways[static_cast<std::size_t>(d)] = Vector<Dim>::Unit(d);
        ways[static_cast<std::size_t>(Dim + d)] = -Vector<Dim>::Unit(d);
    }
    for (int i = 0; i < corners; ++i) {
        const int corner = i ^ i >> 1;  // neighbours follow each other (Gray's code)
        Vector<Dim> way;
        for (int d = 0; d < Dim; ++d)
            way[d] = std::sqrt(1.0 / Dim) * ((corner >> d & 1) != 0 ? -1 : 1);
        ways[static_cast<std::size_t>(2 * Dim + i)] = way;
    }
    return ways;
}

/// The signed distance where it is below the limit; anything from the limit up elsewhere.
template <int Dim, DistanceFrom<Dim> Distance>
double signed_distance_below(const Distance& shape, const Vector<Dim>& x, double limit) {
    if constexpr (requires { shape.signed_distance_below(x, limit); })
        return shape.signed_distance_below(x, limit);
    else
        return shape.signed_distance(x);
}

}  // namespace detail

/// What a ball about x that holds the points stands out by at most [m]: its radius, the distance of
/// the farthest point, less the depth of x in the shape.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] double excess(const Distance& shape, std::span<const Vector<Dim>> points,
                            const Vector<Dim>& x) {
    return farthest_distance<Dim>(x, points) + shape.signed_distance(x);
}

/// A place near `best` where the excess is least: compass search, the ways to the sides and corners
/// of a cube from the best place so far; a step that finds nothing is halved.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] Vector<Dim> least_excess_near(const Distance& shape,
                                            std::span<const Vector<Dim>> points, Vector<Dim> best,
                                            ExcessWalk walk) {
    static const auto ways = detail::compass<Dim>();
    const auto radius_at = [&](const Vector<Dim>& x) { return farthest_distance<Dim>(x, points); };
    double least = excess<Dim>(shape, points, best);
    double depth = radius_at(best) - least;
    // A step changes the excess by at most twice its length.
    while (walk.step > (std::max)(walk.least_step, 0.005 * least) && least > walk.enough) {
        Vector<Dim> next = best;
        for (const Vector<Dim>& way : ways) {
            const Vector<Dim> x = best + walk.step * way;
            // Depth changes by no more than one moves.
            const double radius = radius_at(x);
            if (radius > walk.most_radius || radius - depth - walk.step >= least) continue;
            const double value =
                radius + detail::signed_distance_below<Dim>(shape, x, least - radius);
            if (value >= least) continue;
            least = value;
            next = x;
        }
        if (next == best) {
            walk.step /= 2;
        } else {
            best = next;
            depth = radius_at(best) - least;
        }
    }
    return best;
}

}  // namespace lod
