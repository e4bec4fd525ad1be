#pragma once

/// \file
/// How far a union of balls stands out of a shape, between two bounds.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <queue>
#include <span>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// Distances from a shape, as the plane and space supply them [m].
template <class Distance, int Dim>
concept DistanceFrom = requires(const Distance shape, const Vector<Dim> p) {
    { shape.distance(p) } -> std::convertible_to<double>;            ///< to the shape; 0 inside
    { shape.signed_distance(p) } -> std::convertible_to<double>;     ///< to its surface; < 0 inside
    { shape.nearest(p).point } -> std::convertible_to<Vector<Dim>>;  ///< of its surface
};

/// How far a union of balls stands out of a shape: the largest distance of a point of it to the
/// shape. The true value lies in [least, most].
template <int Dim>
struct Protrusion {
    double least = 0;
    double most = 0;
    Vector<Dim> at = Vector<Dim>::Zero();  ///< a point of the union whose distance is `least`
};

/// What a ball at most stands out by [m], 0 or more: its radius less the depth of its centre. Exact
/// unless the ball reaches over a pocket or a hole of the shape.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] double protrusion_bound(const Distance& shape, const Sphere<Dim>& ball) {
    return (std::max)(0.0, ball.radius + shape.signed_distance(ball.centre));
}

namespace detail {

template <int Dim, DistanceFrom<Dim> Distance>
class ProtrusionSearch {
  public:
    ProtrusionSearch(const Distance& shape, std::span<const Sphere<Dim>> balls)
        : shape_(shape), balls_(balls), depth_(balls.size()) {}

    Protrusion<Dim> run(double tolerance, int most_queries) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            depth_[i] = -shape_.signed_distance(balls_[i].centre);
            cells_.push({(std::max)(0.0, balls_[i].radius - depth_[i]), balls_[i].centre, 0, i});
        }
        while (!cells_.empty() && cells_.top().most > found_.least + tolerance &&
               queries_ < most_queries) {
            const Cell cell = cells_.top();
            cells_.pop();
            if (cell.half == 0)
                open(cell.ball);
            else
                divide(cell);
            if (queries_ % 1024 == 0) check_interrupted();
        }
        found_.most = found_.least;
        if (!cells_.empty()) found_.most = (std::max)(found_.least, cells_.top().most);
        return found_;
    }

  private:
    /// A cube that may hold the point of a ball that is farthest from the shape.
    struct Cell {
        double most;  ///< no point of the ball in the cell is farther from the shape
        Vector<Dim> centre;
        double half;  ///< of a side; 0: the whole ball, not looked into so far
        std::size_t ball;
        bool operator<(const Cell& other) const { return most < other.most; }
    };

    /// A ball without pockets in reach stands out most beyond its nearest surface point.
    void open(std::size_t ball) {
        const Sphere<Dim>& b = balls_[ball];
        const Vector<Dim> nearest = shape_.nearest(b.centre).point;
        const Vector<Dim> out = depth_[ball] >= 0 ? nearest - b.centre : b.centre - nearest;
        if (out.norm() > 0) distance_at(b.centre + b.radius * out.stableNormalized(), found_.least);
        add(b.centre, b.radius, ball, b.radius - depth_[ball]);
    }

    void divide(const Cell& cell) {
        const double half = cell.half / 2;
        for (int corner = 0; corner < 1 << Dim; ++corner) {
            Vector<Dim> centre = cell.centre;
            for (int d = 0; d < Dim; ++d) centre[d] += (corner >> d & 1) != 0 ? half : -half;
            add(centre, half, cell.ball, cell.most);
        }
    }

    void add(const Vector<Dim>& centre, double half, std::size_t ball, double most) {
        const Sphere<Dim>& b = balls_[ball];
        const double corner = half * std::sqrt(static_cast<double>(Dim));
        const Vector<Dim> arm = centre - b.centre;
        const double off = arm.norm();
        if (off - corner > b.radius) return;
        most = (std::min)(most, off + corner - depth_[ball]);
        if (most <= found_.least) return;
        // Projecting on the ball moves no point of the ball away from the cell's centre.
        const Vector<Dim> probe =
            off <= b.radius ? centre : Vector<Dim>(b.centre + (b.radius / off) * arm);
        most = (std::min)(most, distance_at(probe, found_.least - corner) + corner);
        if (most > found_.least) cells_.push({most, centre, half, ball});
    }

    /// The distance where it is more than the floor; anything up to the floor elsewhere.
    double distance_at(const Vector<Dim>& p, double floor) {
        ++queries_;
        const double distance = distance_above(p, floor);
        if (distance > found_.least) {
            found_.least = distance;
            found_.at = p;
        }
        return distance;
    }

    [[nodiscard]] double distance_above(const Vector<Dim>& p, double floor) const {
        if constexpr (requires { shape_.distance_above(p, floor); })
            return shape_.distance_above(p, floor);
        else
            return shape_.distance(p);
    }

    const Distance& shape_;
    std::span<const Sphere<Dim>> balls_;
    std::vector<double> depth_;  ///< of each centre in the shape, negative outside
    std::priority_queue<Cell> cells_;
    Protrusion<Dim> found_;
    int queries_ = 0;
};

}  // namespace detail

/// Branch and bound over cubes: distance to the shape changes by no more than one moves. Ends when
/// most - least is within the tolerance [m], > 0, or after so many queries.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] Protrusion<Dim> find_protrusion(const Distance& shape,
                                              std::span<const Sphere<Dim>> balls, double tolerance,
                                              int most_queries = 2'000'000) {
    return detail::ProtrusionSearch<Dim, Distance>(shape, balls).run(tolerance, most_queries);
}

/// How far one ball stands out [m], from above, within a twentieth: the bound where that is no more
/// than four times `spare` [m], > 0; else by a search of at most so many queries.
template <int Dim, DistanceFrom<Dim> Distance>
[[nodiscard]] double protrusion_from_above(const Distance& shape, const Sphere<Dim>& ball,
                                           double spare, int most_queries) {
    const double bound = protrusion_bound<Dim>(shape, ball);
    if (bound <= 4 * spare) return bound;
    return find_protrusion<Dim>(shape, std::span(&ball, 1), bound / 20, most_queries).most;
}

}  // namespace lod
