#include "lodlab/core/exact/time_of_impact.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/approach.hpp"
#include "lodlab/core/response/impact.hpp"

namespace lod {
namespace {

/// A piece of a body's free motion: straight on, turning evenly.
template <int Dim>
struct Piece {
    Spin<Dim> turn_rate = Spin<Dim>::Zero();  ///< [rad/s]
    double seconds = 0;                       ///< it holds for so long
};

/// The piece that begins now. A body whose spin stays as it is needs only one.
template <int Dim>
Piece<Dim> piece_from(const Body<Dim>& body, double seconds, double longest_turn) {
    if (body.is_static()) return {Spin<Dim>::Zero(), seconds};
    const double step = std::min(seconds, longest_turn);
    const double h = step / Space<Dim>::free_turn_steps(body.orientation, body.inertia,
                                                        body.inverse_inertia, body.spin, step);
    const auto [turn, spin] =
        Space<Dim>::free_turn(body.orientation, body.inertia, body.inverse_inertia, body.spin, h);
    constexpr double steady = 1e-14;
    if ((spin - body.spin).norm() <= steady * body.spin.norm()) return {body.spin, seconds};
    return {turn / h, h};
}

/// Within a piece; the spin follows from the angular momentum, which stays as it is.
template <int Dim>
void move_within(Body<Dim>& body, const Piece<Dim>& piece, double seconds) {
    if (body.is_static()) return;
    body.position += seconds * body.velocity;
    const Spin<Dim> momentum = Space<Dim>::carried(body.orientation, body.inertia) * body.spin;
    body.orientation = Space<Dim>::turned(body.orientation, seconds * piece.turn_rate);
    if (piece.turn_rate != body.spin) body.spin = world_inverse_inertia(body) * momentum;
}

template <int Dim>
RelativeMotion<Dim> motion_between(const Body<Dim>& a, const Piece<Dim>& piece_a,
                                   const Body<Dim>& b, const Piece<Dim>& piece_b) {
    const Matrix<Dim> to_a = Space<Dim>::rotation(a.orientation).transpose();
    RelativeMotion<Dim> motion;
    motion.velocity = to_a * (b.velocity - a.velocity);
    motion.centre_b = to_a * (b.position - a.position);
    motion.spin_a = Space<Dim>::carried_spin(to_a, piece_a.turn_rate);
    motion.spin_b = Space<Dim>::carried_spin(to_a, piece_b.turn_rate);
    motion.while_for = std::min(piece_a.seconds, piece_b.seconds);
    return motion;
}

/// Whether a contact closes, more than rounding makes it.
template <int Dim>
bool any_approaches(const TimeOfImpact<Dim>& at, double fastest) {
    constexpr double settled = 1e-12;
    return std::any_of(at.contacts.begin(), at.contacts.end(), [&](const Contact<Dim>& contact) {
        return closing_velocity(at.a, at.b, contact) < -settled * fastest;
    });
}

template <int Dim>
void check(const Body<Dim>& a, const Body<Dim>& b, const ImpactSettings& settings) {
    const auto refuse = [](const char* why) { throw Error(ErrorKind::input_refused, why); };
    if (!a.exact || !b.exact) refuse("time of impact: a body has no exact shape; set Body::exact");
    if (!(settings.horizon >= 0) || !std::isfinite(settings.horizon))
        refuse("time of impact: the horizon must be a finite number of seconds, 0 or more");
    if (!(settings.tolerance > 0)) refuse("time of impact: the tolerance must be above 0");
    if (!(settings.longest_turn > 0)) refuse("time of impact: longest_turn must be above 0");
}

/// How far one advance looks ahead. A long look walks many pairs of parts and bounds their turning
/// badly, so at first it is no further than where nothing at all can touch. It doubles when the
/// whole of it was clear, up to where points have moved by a share of the shapes' size, and shrinks
/// when most of it was not.
class Stride {
  public:
    /// `size` of the smaller shape [m].
    explicit Stride(double size) : farthest_(0.25 * size) {}

    /// In seconds; infinite where nothing moves.
    double longest(double distance, double fastest) {
        longest_ = std::max(distance, std::min(doublings_ * distance, farthest_)) / fastest;
        return longest_;
    }
    void took(double time) {
        if (time >= longest_) doublings_ *= 2;
        if (time < longest_ / 4 && doublings_ > 1) doublings_ /= 2;
    }

  private:
    double farthest_;
    double doublings_ = 1;
    double longest_ = 0;
};

}  // namespace

template <int Dim>
TimeOfImpact<Dim> time_of_impact(const Body<Dim>& a, const Body<Dim>& b,
                                 const ImpactSettings& settings) {
    check(a, b, settings);
    TimeOfImpact<Dim> at;
    at.a = a;
    at.b = b;
    if (exactly_overlap(a, b)) {
        at.outcome = ImpactOutcome::overlapping;
        return at;
    }
    const double radius_a = a.exact->radius();
    const double radius_b = b.exact->radius();
    Stride stride(std::min(radius_a, radius_b));
    for (;; ++at.rounds) {
        const double left = settings.horizon - at.time;
        const auto piece_a = piece_from(at.a, left, settings.longest_turn);
        const auto piece_b = piece_from(at.b, left, settings.longest_turn);
        RelativeMotion<Dim> motion = motion_between(at.a, piece_a, at.b, piece_b);
        const double fastest = fastest_closing(motion, radius_a, radius_b);
        at.distance = separation(at.a, at.b).distance;
        if (at.distance <= settings.tolerance) {
            touching_contacts(at.a, at.b, at.distance + settings.tolerance, at.contacts);
            at.outcome = ImpactOutcome::touching;
            if (any_approaches(at, fastest)) return at;
            at.contacts.clear();
        }
        at.outcome = ImpactOutcome::never;
        if (left <= 0) return at;
        if (at.rounds >= settings.most_rounds) {
            at.outcome = ImpactOutcome::cap_reached;
            return at;
        }
        // What is left of the gap after the advance, so that the next direction is known.
        const double floor = 0.5 * std::min(at.distance, settings.tolerance);
        motion.while_for = std::min(motion.while_for, stride.longest(at.distance, fastest));
        ClearTime<Dim> clear(motion, radius_a, radius_b, floor);
        at.a.exact->visit_pairs(*at.b.exact, seen_from(placement(at.a), placement(at.b)), clear);
        stride.took(clear.time);
        move_within(at.a, piece_a, clear.time);
        move_within(at.b, piece_b, clear.time);
        at.time = clear.time >= left ? settings.horizon : at.time + clear.time;
    }
}

template <int Dim>
Body<Dim> moved_freely(const Body<Dim>& body, double seconds, double longest_turn) {
    Body<Dim> moved = body;
    for (double left = seconds; left > 0;) {
        const Piece<Dim> piece = piece_from(moved, left, longest_turn);
        const double step = std::min(left, piece.seconds);
        move_within(moved, piece, step);
        left = step < left ? left - step : 0;
    }
    return moved;
}

#define LOD_INSTANTIATE(Dim)                                                      \
    template TimeOfImpact<Dim> time_of_impact(const Body<Dim>&, const Body<Dim>&, \
                                              const ImpactSettings&);             \
    template Body<Dim> moved_freely(const Body<Dim>&, double, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
