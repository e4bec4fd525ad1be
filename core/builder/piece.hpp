#pragma once

/// \file
/// What a builder must know of a part of a shape, whether of the plane or of space.

#include <concepts>
#include <span>
#include <utility>
#include <vector>

#include "lodlab/core/math/half_space.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// What a piece knows of its convex hull.
template <int Dim>
struct HullHints {
    std::vector<Vector<Dim>> corners;  ///< those of the piece's vertices that lie outermost
    std::vector<Vector<Dim>> normals;  ///< of the hull's faces, as far as they are known; unit
};

/// A part of a shape that a node of its tree owns, as the plane (clipped polygons) and space
/// (clipped triangles) supply it. A ball holds the piece exactly where it holds its vertices.
template <class Piece, int Dim>
concept PieceOf = std::copyable<Piece> &&
    requires(const Piece piece, std::span<const HalfSpace<Dim>> cell, const Sphere<Dim> ball) {
    /// What of the piece lies in every half-space of the cell.
    { piece.within(cell) } -> std::same_as<Piece>;
    /// Their convex hull holds the piece. None: the piece is empty.
    { piece.vertices() } -> std::convertible_to<std::span<const Vector<Dim>>>;
    /// Area or volume, at least.
    { piece.measure() } -> std::convertible_to<double>;
    /// Integral of the outward unit normal over the shape's surface in this piece.
    { piece.surface_normal() } -> std::convertible_to<Vector<Dim>>;
    /// Length or area of that surface.
    { piece.surface_measure() } -> std::convertible_to<double>;
    /// A part of the piece that the ball holds, as large as can cheaply be found (all of it, where
    /// the ball holds all of it), and an upper bound of the measure of the rest.
    { piece.held_by(ball) } -> std::same_as<std::pair<Piece, double>>;
    { piece.hull_hints() } -> std::same_as<HullHints<Dim>>;
};

/// The part of a piece in the power cell of each ball.
template <int Dim, PieceOf<Dim> Piece>
[[nodiscard]] std::vector<Piece> split(const Piece& piece, std::span<const Sphere<Dim>> balls);

/// Mean outward unit normal of the surface in the piece; zero where it has none.
template <int Dim, PieceOf<Dim> Piece>
[[nodiscard]] Vector<Dim> mean_normal(const Piece& piece) {
    const double surface = piece.surface_measure();
    if (surface <= 0) return Vector<Dim>::Zero();
    return piece.surface_normal() / surface;
}

}  // namespace lod

#include "lodlab/core/math/power_diagram.hpp"

namespace lod {

template <int Dim, PieceOf<Dim> Piece>
std::vector<Piece> split(const Piece& piece, std::span<const Sphere<Dim>> balls) {
    std::vector<Piece> parts;
    parts.reserve(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        parts.push_back(piece.within(power_cell<Dim>(balls, i)));
    return parts;
}

}  // namespace lod
