#pragma once

/// \file
/// What pictures show of bodies and of a run: copies, so that a picture can be made when the run is
/// over.

#include <string>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/shape/shape.hpp"
#include "lodlab/lod3d/solid/solid.hpp"
#include "lodlab/viz/draw/draw_traits.hpp"

namespace viz {

/// What a picture shows of a body beyond what the method knows of it, as `visual` in URDF: name and
/// geometry, where `lod::Body` has tree and mass.
template <int Dim>
struct Visual {
    std::string name;  ///< what the reader calls it; used in alt texts and labels
    typename DrawTraits<Dim>::Outline
        outline{};  ///< rings or a surface; where empty, leaves are drawn
};

/// The outline of a shape, or the surface of a solid, under its name.
[[nodiscard]] Visual<2> visual_of(const lod2d::Shape& shape);
/// The same of a solid.
[[nodiscard]] Visual<3> visual_of(const lod3d::Solid& solid);

/// A body as a picture needs it. Requires: body.tree is there.
template <int Dim>
struct Actor {
    Visual<Dim> visual;
    lod::Body<Dim> body;
};

/// One frame of a simulation, copied from its record.
template <int Dim>
struct Instant {
    double time = 0;                     ///< [s]
    std::vector<lod::Body<Dim>> bodies;  ///< as the frame found them: before response and motion
    lod::FrameRecord<Dim> record;        ///< what the frame did; the next instant's bodies show it
};

/// A simulation from its first frame to its last; instants are equally far apart.
template <int Dim>
struct Run {
    std::string name;  ///< "level 2", "exact", "budget 400 tests": heads its row or panel
    std::vector<Visual<Dim>> visuals;  ///< one a body
    std::vector<Instant<Dim>> instants;
    double time_step = 1.0 / 120;  ///< [s]
};

/// Of one body of a run; nameless and without an outline where the run has none for it.
template <int Dim>
[[nodiscard]] Visual<Dim> visual_at(const Run<Dim>& run, std::size_t body) {
    return body < run.visuals.size() ? run.visuals[body] : Visual<Dim>{};
}

/// Appends an instant: call it with the bodies copied before `advance` and the record that
/// `advance` returned. The last instant of a run may have an empty record: where the bodies ended.
template <int Dim>
void add_instant(Run<Dim>& run, std::vector<lod::Body<Dim>> bodies_before,
                 const lod::FrameRecord<Dim>& record);

/// A point of the plane's body frame in the world.
[[nodiscard]] Point carried(const lod::Body<2>& body, Point local);

/// The outline carried to the world frame.
[[nodiscard]] std::vector<Ring> carried(const lod::Body<2>& body, const std::vector<Ring>& rings);

/// A node of the body's tree carried to the world frame.
template <int Dim>
[[nodiscard]] lod::Sphere<Dim> carried_node(const lod::Body<Dim>& body, int node);

/// Widens a view until it shows a body, a ball, all that the bodies of a run show until an instant.
template <int Dim>
void take_in(View<Dim>& view, const Actor<Dim>& actor);
/// The same of a ball.
template <int Dim>
void take_in(View<Dim>& view, const lod::Sphere<Dim>& ball);
/// The same of a run until an instant.
template <int Dim>
void take_in(View<Dim>& view, const Run<Dim>& run, std::size_t until);

/// The box of both.
[[nodiscard]] Box united(const Box& a, const Box& b);
[[nodiscard]] Box grown(const Box& box, double share);  ///< by that share of its larger side
/// Its width or height.
[[nodiscard]] double longer_side(const Box& box);

/// First instant whose record has an impulse, or -1.
template <int Dim>
[[nodiscard]] int first_impact(const Run<Dim>& run);

/// Which way two bodies lie from each other, and which way a run's bodies meet: what a view is
/// taken across.
template <int Dim>
[[nodiscard]] lod::Vector<Dim> way_between(const lod::Body<Dim>& a, const lod::Body<Dim>& b);
/// The same of a run: how its two bodies approach, or how its first two lie.
template <int Dim>
[[nodiscard]] lod::Vector<Dim> way_of(const Run<Dim>& run);

}  // namespace viz
