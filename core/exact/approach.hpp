#pragma once

#include <limits>

#include "lodlab/core/exact/exact_shape.hpp"

namespace lod {

/// How body B moves against body A for a while: straight on, both turning evenly about fixed axes.
/// Everything in the frame that A has at the beginning, A's centre of mass the origin and at rest.
template <int Dim>
struct RelativeMotion {
    Vector<Dim> velocity = Vector<Dim>::Zero();  ///< of B's centre of mass, less A's [m/s]
    Vector<Dim> centre_b = Vector<Dim>::Zero();  ///< B's centre of mass at the beginning [m]
    Spin<Dim> spin_a = Spin<Dim>::Zero();        ///< [rad/s]
    Spin<Dim> spin_b = Spin<Dim>::Zero();
    double while_for = 0;  ///< how long it goes on so [s]

    /// The rate at which A's point at p comes nearer to B's point there along n [m/s].
    [[nodiscard]] double closing(const Vector<Dim>& p, const Vector<Dim>& n) const {
        const Vector<Dim> of_a = Space<Dim>::cross(spin_a, p);
        const Vector<Dim> of_b = velocity + Space<Dim>::cross(spin_b, p - centre_b);
        return n.dot(of_a - of_b);
    }
};

/// A time before which two convex parts surely stay further apart than `floor` [s]; infinite where
/// they never come so near. `n` is any unit vector, A to B, and better the better it separates
/// them.
///
/// The least gap along n, seen from B's frame where B's part rests, shrinks at first with the speed
/// of A's corners and then at most by the acceleration that two turning bodies can give, so the
/// bound is exact to first order: an advance by it nears the impact as Newton's method does. The
/// same holds from A's frame. The third bound takes the parts' largest speeds (Mirtich 1996).
/// Returns the latest of the three.
template <int Dim>
[[nodiscard]] double clear_time(const RelativeMotion<Dim>& motion, const ConvexPart<Dim>& a,
                                const ConvexPart<Dim>& b, const Vector<Dim>& n, double floor);

/// Finds how far two shapes can surely move: the least clear time of all pairs of their parts.
/// Conservative advancement with directions of motion, box by box (after Tang, Kim and Manocha,
/// C2A, 2009).
template <int Dim>
class ClearTime final : public PartVisitor<Dim> {
  public:
    /// `radius_a`, `radius_b`: of the balls about the centres of mass that hold the shapes [m].
    ClearTime(const RelativeMotion<Dim>& motion, double radius_a, double radius_b, double floor);

    bool skips(const ConvexPart<Dim>& a, const ConvexPart<Dim>& b, const Vector<Dim>& direction,
               double gap) const override;
    void visit(const PartPair<Dim>& pair) override;

    double time;  ///< the result, at most motion.while_for [s]

  private:
    RelativeMotion<Dim> motion_;
    double floor_;
    double fastest_;  ///< no two points near each other faster than this [m/s]
};

/// No point of A and no point of B near each other faster than this [m/s].
template <int Dim>
[[nodiscard]] double fastest_closing(const RelativeMotion<Dim>& motion, double radius_a,
                                     double radius_b);

extern template class ClearTime<2>;
extern template class ClearTime<3>;

}  // namespace lod
