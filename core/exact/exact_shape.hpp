#pragma once

/// \file
/// The true shape of a body, asked after the leaves of its tree: distance, overlap, exact contacts.

#include <array>
#include <span>
#include <vector>

#include "lodlab/core/contact/contact.hpp"
#include "lodlab/core/tree/placement.hpp"

namespace lod {

/// A part of a shape's boundary: an edge of a polygon, a triangle of a mesh.
template <int Dim>
using Facet = std::array<Vector<Dim>, Dim>;

/// The convex hull of a few points, grown by a radius: a facet, a box about many facets, a ball.
template <int Dim>
struct ConvexPart {
    static constexpr std::size_t most_corners = std::size_t{1} << Dim;

    std::array<Vector<Dim>, most_corners> corner;
    std::size_t count = 0;
    double radius = 0;  ///< >= 0 [m]

    /// The points whose hull it is.
    [[nodiscard]] std::span<const Vector<Dim>> corners() const {
        return std::span(corner).first(count);
    }
};

/// A facet as a convex part.
template <int Dim>
[[nodiscard]] ConvexPart<Dim> part_of(const Facet<Dim>& facet) {
    ConvexPart<Dim> part;
    for (const Vector<Dim>& corner : facet) part.corner[part.count++] = corner;
    return part;
}

/// Where a part of A and a part of B are nearest to each other. Frame of A, metres.
template <int Dim>
struct PartPair {
    /// A corner over a facet, or an edge over an edge: the two feet of the shortest way.
    struct Feet {
        Vector<Dim> on_a;
        Vector<Dim> on_b;
    };
    static constexpr std::size_t most_directions = 6;
    static constexpr std::size_t most_feet = 15;  ///< 6 corners, 9 pairs of sides of two triangles

    ConvexPart<Dim> a;
    ConvexPart<Dim> b;
    Feet nearest;
    double distance = 0;  ///< 0 when the parts share a point
    /// Unit directions, A to B, that may separate the parts: normals of facets first, the shortest
    /// way last.
    std::array<Vector<Dim>, most_directions> direction;
    std::size_t directions = 0;
    std::size_t firm_directions =
        0;  ///< so many, the first, come from facets: rounding spares them
    /// Every feet no longer apart than the visitor's feet_within.
    std::array<Feet, most_feet> feet;
    std::size_t feet_count = 0;

    /// One more direction that may separate the parts. Requires: room for it.
    void add_direction(const Vector<Dim>& unit) { direction[directions++] = unit; }
};

/// What walks the parts of two shapes.
template <int Dim>
class PartVisitor {
  public:
    virtual ~PartVisitor() = default;
    /// Whether nothing within these two hulls matters. They are apart by `gap` > 0 at least along
    /// the unit vector `direction`, A to B. Frame of A.
    [[nodiscard]] virtual bool skips(const ConvexPart<Dim>& a, const ConvexPart<Dim>& b,
                                     const Vector<Dim>& direction, double gap) const = 0;
    /// Called for every pair of parts that is not skipped.
    virtual void visit(const PartPair<Dim>& pair) = 0;
    /// Whether no other pair can matter: the walk may end.
    [[nodiscard]] virtual bool is_done() const { return false; }

    double feet_within = -1;  ///< how far apart feet are listed [m]; below 0: none are
};

/// The true shape of a body: what the finest level of detail asks, after the leaves of its tree
/// (section 3, "polygon tests are reserved as the finest level of detail"). Body frame; immutable;
/// several threads may ask one at once.
template <int Dim>
class ExactShape {
  public:
    virtual ~ExactShape() = default;

    /// Of the ball about the origin, the centre of mass, that holds the shape [m].
    [[nodiscard]] virtual double radius() const = 0;
    /// Of all that the shape is (BitHash).
    [[nodiscard]] virtual std::uint64_t hash() const = 0;
    /// A point of each closed piece of the boundary: a shape whose boundary meets no other boundary
    /// lies inside another shape exactly if one of these does.
    [[nodiscard]] virtual std::span<const Vector<Dim>> witnesses() const = 0;
    /// Whether the closed shape holds the point.
    [[nodiscard]] virtual bool holds(const Vector<Dim>& p) const = 0;
    /// Walks the pairs of parts of this shape (A) and another (B), near ones first where that is
    /// cheap, without those that the visitor skips. Throws Error (input refused) when the other
    /// shape is of another kind.
    virtual void visit_pairs(const ExactShape& b, const Placement<Dim>& b_in_a,
                             PartVisitor<Dim>& visitor) const = 0;
    /// Reduces points of one contact, all with the normal `normal`, to the corners of their convex
    /// hull seen along it: what the rest can push, these can. Points within `tolerance` [m] of the
    /// hull of the others are dropped.
    virtual void keep_corners(const Vector<Dim>& normal, double tolerance,
                              std::vector<Contact<Dim>>& contacts) const = 0;
};

/// The shortest way between two bodies' exact shapes. World frame.
template <int Dim>
struct Separation {
    Vector<Dim> on_a = Vector<Dim>::Zero();
    Vector<Dim> on_b = Vector<Dim>::Zero();
    double distance = 0;  ///< 0 when the boundaries share a point [m]
};

/// Between the boundaries of two bodies. Requires: body.exact of both.
template <int Dim>
[[nodiscard]] Separation<Dim> separation(const Body<Dim>& a, const Body<Dim>& b);

/// Whether two bodies' exact shapes share a point. Requires: body.exact of both.
template <int Dim>
[[nodiscard]] bool exactly_overlap(const Body<Dim>& a, const Body<Dim>& b);

/// The contacts of two bodies that are apart by less than `reach` [m]: one for a corner on a face
/// or two edges that cross; where faces meet, the corners of what they share (the end points of a
/// segment in the plane, the corners of a polygon in space). `depth` is minus the gap. The normal
/// is that of the face where there is one. Contacts with one normal whose points form one convex
/// hull, as a comb on a floor makes, are reduced to its corners. Where corner and corner meet there
/// are several normals along which the bodies are apart near by; where they do not approach along
/// one of these they pass each other, and no contact there approaches.
/// Requires: body.exact of both, their boundaries share no point, reach > their distance.
template <int Dim>
void touching_contacts(const Body<Dim>& a, const Body<Dim>& b, double reach,
                       std::vector<Contact<Dim>>& contacts);

}  // namespace lod
