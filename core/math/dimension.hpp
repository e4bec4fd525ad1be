#pragma once

/// \file
/// All that differs between the plane and space, in one place: the types of vectors, spins,
/// orientations and inertia for `Dim` 2 and 3.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "lodlab/core/math/linear.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod {

/// Everything that separates the plane from space. No other file may test Dim.
/// SI units, radians, double precision.
template <int Dim>
struct Space {
    static_assert(Dim == 2 || Dim == 3);
    static constexpr int spin_size = Dim == 2 ? 1 : 3;

    /// A point, velocity or force.
    using Vector = FixedMatrix<Dim, 1>;
    /// A linear map, such as a rotation.
    using Matrix = FixedMatrix<Dim, Dim>;
    using Spin = FixedMatrix<spin_size, 1>;             ///< angular velocity [rad/s], torque, ...
    using Inertia = FixedMatrix<spin_size, spin_size>;  ///< [kg m^2]
    /// Body frame to world frame: an angle [rad] in the plane, a unit quaternion in space.
    using Orientation = std::conditional_t<Dim == 2, double, Quaternion>;

    /// Velocity that spin gives to a point at arm r from the centre of mass: w x r.
    static Vector cross(const Spin& spin, const Vector& r) {
        if constexpr (Dim == 2)
            return spin[0] * Vector(-r.y(), r.x());
        else
            return spin.cross(r);
    }

    /// Moment of a force or impulse f at arm r: r x f.
    static Spin moment(const Vector& r, const Vector& f) {
        if constexpr (Dim == 2)
            return Spin::Constant(r.x() * f.y() - r.y() * f.x());
        else
            return r.cross(f);
    }

    /// Normal of a boundary's edge or triangle, outward where its corners run anticlockwise; as
    /// long as the edge, or twice the triangle's area.
    static Vector facet_normal(const std::array<Vector, Dim>& corner) {
        if constexpr (Dim == 2) {
            const Vector along = corner[1] - corner[0];
            return Vector(along.y(), -along.x());
        } else {
            return (corner[1] - corner[0]).cross(corner[2] - corner[0]);
        }
    }

    /// Whether a facet's last corner is joined to its first: a polygon's is, a segment's is not.
    static constexpr bool facets_close = Dim == 3;

    /// The same, of any number of corners: a segment's length, or twice a flat polygon's area.
    static Vector area_vector(std::span<const Vector> corners) {
        if constexpr (Dim == 2) {
            return facet_normal({corners.front(), corners.back()});
        } else {
            Vector area = Vector::Zero();
            for (std::size_t i = 1; i + 1 < corners.size(); ++i)
                area += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
            return area;
        }
    }

    /// The corners of a piece of the plane (or line) across a unit normal about a point of it.
    static std::array<Vector, 2 * Dim - 2> patch(const Vector& foot, const Vector& normal,
                                                 double reach) {
        if constexpr (Dim == 2) {
            const Vector u(-normal.y(), normal.x());
            return {foot - reach * u, foot + reach * u};
        } else {
            const Vector u = normal.unitOrthogonal();
            const Vector v = normal.cross(u);
            return {foot - reach * u - reach * v, foot + reach * u - reach * v,
                    foot + reach * u + reach * v, foot - reach * u + reach * v};
        }
    }

    /// Where the border of a facet with this outward normal ends at the edge that runs `along`: in
    /// space across the edge and in the plane of the facet, in the plane along the segment. Points
    /// outwards where corners run anticlockwise seen from the normal's tip.
    static Vector side_normal(const Vector& along, const Vector& normal) {
        if constexpr (Dim == 2)
            return along;
        else
            return along.cross(normal);
    }

    /// Body frame and world frame have the same axes.
    static Orientation unturned() {
        if constexpr (Dim == 2)
            return 0.0;
        else
            return Quaternion::Identity();
    }

    /// The matrix that takes a vector from the body frame to the world frame.
    static Matrix rotation(const Orientation& orientation) {
        if constexpr (Dim == 2) {
            const SineCosine of = sine_cosine(orientation);
            return Matrix(of.cosine, -of.sine, of.sine, of.cosine);
        } else {
            return orientation.toRotationMatrix();
        }
    }

    /// The same of many orientations, to the same bits. Requires: as many matrices.
    static void rotations(std::span<const Orientation> orientations, std::span<Matrix> matrices) {
        constexpr std::size_t some = 32;
        if constexpr (Dim == 2) {
            std::array<SineCosine, some> of;
            for (std::size_t begin = 0; begin < orientations.size(); begin += some) {
                const std::size_t count = (std::min)(some, orientations.size() - begin);
                sine_cosine(orientations.subspan(begin, count), std::span(of).first(count));
                for (std::size_t i = 0; i < count; ++i)
                    matrices[begin + i] =
                        Matrix(of[i].cosine, -of[i].sine, of[i].sine, of[i].cosine);
            }
        } else {
            for (std::size_t i = 0; i < orientations.size(); ++i)
                matrices[i] = rotation(orientations[i]);
        }
    }

    /// An orientation after turning by the vector `turn` [rad], given in the world frame.
    static Orientation turned(const Orientation& orientation, const Spin& turn) {
        if constexpr (Dim == 2) {
            return wrapped_angle(orientation + turn[0]);
        } else {
            const double angle = turn.norm();
            if (angle == 0) return orientation;
            const SineCosine half = sine_cosine(angle / 2);
            const Vector axis = (half.sine / angle) * turn;
            const Quaternion by(half.cosine, axis.x(), axis.y(), axis.z());
            return (by * orientation).normalized();
        }
    }

    /// An inertia, or its inverse, carried from the body frame to the world frame: R I R^T.
    static Inertia carried(const Orientation& orientation, const Inertia& inertia) {
        if constexpr (Dim == 2) {
            return inertia;
        } else {
            const Matrix R = rotation(orientation);
            return R * inertia * R.transpose();
        }
    }

    /// A spin seen from the other frame: from the body frame to the world frame by the rotation,
    /// and back by its transpose.
    static Spin carried_spin(const Matrix& rotation, const Spin& spin) {
        if constexpr (Dim == 2)
            return spin;
        else
            return rotation * spin;
    }

    /// Into how many steps free_turn must be split so that its iteration settles (it contracts by a
    /// factor of 4 a round); at most 1000.
    static int free_turn_steps(const Orientation& orientation, const Inertia& inertia,
                               const Inertia& inverse_inertia, const Spin& spin, double h) {
        if constexpr (Dim == 2) {
            return 1;
        } else {
            constexpr double most_steps = 1000;
            const Spin momentum = inertia * (rotation(orientation).transpose() * spin);
            const double turn = h * inverse_inertia.norm() * momentum.norm();
            return turn > 0.5 ? static_cast<int>((std::min)(std::ceil(2 * turn), most_steps)) : 1;
        }
    }

    /// The rotation of free motion over h seconds: the turn in the world frame [rad] and the spin
    /// after it. See core/frame/integrate.hpp for the method in space.
    struct FreeTurn {
        Spin turn;
        Spin spin;
    };
    /// Turns a body that nothing acts on for h seconds.
    static FreeTurn free_turn(const Orientation& orientation, const Inertia& inertia,
                              const Inertia& inverse_inertia, const Spin& spin, double h) {
        if constexpr (Dim == 2) {
            return {h * spin, spin};
        } else {
            constexpr int most_rounds = 60;
            const Matrix turned = rotation(orientation);
            const Spin momentum = inertia * (turned.transpose() * spin);  // body frame
            Spin middle = inverse_inertia * momentum;
            double change_before = std::numeric_limits<double>::infinity();
            for (int round = 0; round < most_rounds; ++round) {
                const Spin next = rotated(-h * middle, momentum);
                const Spin better = inverse_inertia * (0.5 * (momentum + next));
                const double change = (better - middle).cwiseAbs().maxCoeff();
                middle = better;
                // Settled, or down to rounding, where it shrinks no further.
                if (change == 0 || change >= change_before) break;
                change_before = change;
            }
            // Q(h * middle) takes the momentum along: it stays put in the world frame.
            const Spin next = rotated(-h * middle, momentum);
            const Spin turn = h * (turned * middle);
            const Spin spin_after = rotated(turn, Spin(turned * (inverse_inertia * next)));
            return {turn, spin_after};
        }
    }

  private:
    /// v turned by the rotation vector `turn` (Rodrigues).
    static Vector rotated(const Spin& turn, const Vector& v) requires(Dim == 3) {
        const double angle = turn.norm();
        if (angle == 0) return v;
        const SineCosine of = sine_cosine(angle);
        const Vector axis = turn / angle;
        return of.cosine * v + of.sine * axis.cross(v) + (1 - of.cosine) * axis.dot(v) * axis;
    }
};

/// A point, velocity or force: two numbers in the plane, three in space.
template <int Dim>
using Vector = typename Space<Dim>::Vector;
/// A linear map, such as a rotation.
template <int Dim>
using Matrix = typename Space<Dim>::Matrix;
/// Angular velocity, torque and the like: one number in the plane, three in space.
template <int Dim>
using Spin = typename Space<Dim>::Spin;
/// Moments of inertia: one number in the plane, a matrix in space.
template <int Dim>
using Inertia = typename Space<Dim>::Inertia;
/// Body frame to world frame: an angle [rad] in the plane, a unit quaternion in space.
template <int Dim>
using Orientation = typename Space<Dim>::Orientation;

}  // namespace lod
