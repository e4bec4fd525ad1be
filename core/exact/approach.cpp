#include "lodlab/core/exact/approach.hpp"

#include <algorithm>
#include <cmath>

namespace lod {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The first time at which a gap that begins at `gap`, closes at `speed` and gains at most
/// `acceleration` may be 0. Requires: gap >= 0, acceleration >= 0.
double first_zero(double gap, double speed, double acceleration) {
    if (speed <= 0 && acceleration == 0) return never;
    const double root = std::sqrt(speed * speed + 2 * acceleration * gap);
    return speed > 0 ? 2 * gap / (speed + root) : (root - speed) / acceleration;
}

/// Distance of the farthest corner from a point.
template <int Dim>
double farthest(const ConvexPart<Dim>& part, const Vector<Dim>& from) {
    double squared = 0;
    for (const Vector<Dim>& p : part.corners())
        squared = std::max(squared, (p - from).squaredNorm());
    return std::sqrt(squared);
}

/// Bounds the acceleration that a point of one body can have in the frame of the other: at the
/// beginning, and how fast the bound grows as they move away from each other.
struct Turning {
    double at_first;
    double growth;

    /// `own_spin` of the point's body, `arm` of the point in it, `frame_spin` of the other body,
    /// `distance` of the point from that one's centre, `speed` of one centre against the other.
    Turning(double own_spin, double arm, double frame_spin, double distance, double speed) {
        const double fastest = speed + own_spin * arm;
        at_first = own_spin * own_spin * arm + 2 * frame_spin * fastest +
                   frame_spin * frame_spin * distance;
        growth = frame_spin * frame_spin * fastest;
    }

    /// The first time within `horizon` at which a gap that closes at `speed` may be 0. Up to a time
    /// t a growing acceleration moves no further than a constant one of at_first + growth t / 3.
    [[nodiscard]] double first_time(double gap, double speed, double horizon) const {
        const double without_growth = first_zero(gap, speed, at_first);
        if (growth == 0) return without_growth;
        const double longest = std::min(without_growth, horizon);
        return std::min(longest, first_zero(gap, speed, at_first + growth * longest / 3));
    }
};

}  // namespace

template <int Dim>
double fastest_closing(const RelativeMotion<Dim>& motion, double radius_a, double radius_b) {
    return motion.velocity.norm() + motion.spin_a.norm() * radius_a +
           motion.spin_b.norm() * radius_b;
}

template <int Dim>
double clear_time(const RelativeMotion<Dim>& motion, const ConvexPart<Dim>& a,
                  const ConvexPart<Dim>& b, const Vector<Dim>& n, double floor) {
    const double arm_a = farthest<Dim>(a, Vector<Dim>::Zero());
    const double arm_b = farthest<Dim>(b, motion.centre_b);
    double front = -never;
    double back = never;
    for (const Vector<Dim>& p : a.corners()) front = std::max(front, n.dot(p));
    for (const Vector<Dim>& q : b.corners()) back = std::min(back, n.dot(q));
    const double between = a.radius + b.radius + floor;
    if (back - front - between <= 0) return 0;

    const double speed = motion.velocity.norm();
    const double spin_a = motion.spin_a.norm();
    const double spin_b = motion.spin_b.norm();
    const Turning of_a(spin_a, arm_a, spin_b, farthest<Dim>(a, motion.centre_b), speed);
    double seen_from_b = never;
    for (const Vector<Dim>& p : a.corners())
        seen_from_b = std::min(
            seen_from_b,
            of_a.first_time(back - n.dot(p) - between, motion.closing(p, n), motion.while_for));
    const Turning of_b(spin_b, arm_b, spin_a, farthest<Dim>(b, Vector<Dim>::Zero()), speed);
    double seen_from_a = never;
    for (const Vector<Dim>& q : b.corners())
        seen_from_a = std::min(
            seen_from_a,
            of_b.first_time(n.dot(q) - front - between, motion.closing(q, n), motion.while_for));
    const double by_speed =
        first_zero(back - front - between, fastest_closing(motion, arm_a, arm_b), 0);
    return std::max({seen_from_b, seen_from_a, by_speed});
}

template <int Dim>
ClearTime<Dim>::ClearTime(const RelativeMotion<Dim>& motion, double radius_a, double radius_b,
                          double floor)
    : time(motion.while_for),
      motion_(motion),
      floor_(floor),
      fastest_(fastest_closing(motion, radius_a, radius_b)) {}

template <int Dim>
bool ClearTime<Dim>::skips(const ConvexPart<Dim>& a, const ConvexPart<Dim>& b,
                           const Vector<Dim>& direction, double gap) const {
    if (gap <= floor_) return false;
    if (gap - floor_ >= fastest_ * time) return true;
    return clear_time(motion_, a, b, direction, floor_) >= time;
}

template <int Dim>
void ClearTime<Dim>::visit(const PartPair<Dim>& pair) {
    if (pair.distance - floor_ >= fastest_ * time) return;
    double clear = 0;
    for (std::size_t k = 0; k < pair.directions && clear < time; ++k)
        clear = std::max(clear, clear_time(motion_, pair.a, pair.b, pair.direction[k], floor_));
    time = std::min(time, clear);
}

#define LOD_INSTANTIATE(Dim)                                                        \
    template double fastest_closing(const RelativeMotion<Dim>&, double, double);    \
    template double clear_time(const RelativeMotion<Dim>&, const ConvexPart<Dim>&,  \
                               const ConvexPart<Dim>&, const Vector<Dim>&, double); \
    template class ClearTime<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
