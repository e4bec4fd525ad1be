#pragma once

#include <string>
#include <vector>

#include "core/frame.hpp"
#include "lod2d/shape.hpp"
#include "viz/figure.hpp"

namespace viz {

/// What a picture shows of a body beyond what the method knows of it.
struct Look {
    std::string name;         ///< what the reader calls it; used in alt texts and labels
    std::vector<Ring> rings;  ///< outline with holes, body frame [m]; empty: its leaves are drawn
};

/// The outline of a shape under its name.
[[nodiscard]] Look look_of(const lod2d::Shape& shape);

/// A body as a picture needs it. Requires: body.tree is there.
struct Actor {
    Look look;
    lod::Body<2> body;
};

/// One frame of a simulation, copied from its record.
struct Instant {
    double time = 0;                   ///< [s]
    std::vector<lod::Body<2>> bodies;  ///< as the frame found them: before response and motion
    lod::FrameRecord<2> record;        ///< what the frame did; the next instant's bodies show it
};

/// A simulation from its first frame to its last; instants are equally far apart.
struct Run {
    std::string name;         ///< "level 2", "exact", "budget 400 tests": heads its row or panel
    std::vector<Look> looks;  ///< one a body
    std::vector<Instant> instants;
    double time_step = 1.0 / 120;  ///< [s]
};

/// Appends an instant: call it with the bodies copied before `advance` and the record that
/// `advance` returned. The last instant of a run may have an empty record: where the bodies ended.
void add_instant(Run& run, std::vector<lod::Body<2>> bodies_before,
                 const lod::FrameRecord<2>& record);

/// A point of the body frame in the world.
[[nodiscard]] Point carried(const lod::Body<2>& body, Point local);

/// The outline carried to the world frame.
[[nodiscard]] std::vector<Ring> carried(const lod::Body<2>& body, const std::vector<Ring>& rings);

/// A node of the body's tree carried to the world frame.
[[nodiscard]] lod::Sphere<2> carried_node(const lod::Body<2>& body, int node);

/// The smallest box round all that the bodies show.
[[nodiscard]] Box bounds(const std::vector<Look>& looks, const std::vector<lod::Body<2>>& bodies);
[[nodiscard]] Box box_of(const lod::Sphere<2>& ball);
[[nodiscard]] Box united(const Box& a, const Box& b);
[[nodiscard]] Box grown(const Box& box, double share);  ///< by that share of its larger side

/// The distance between the outlines of two bodies [m]: 0 where they overlap, negative where one of
/// them has no outline.
[[nodiscard]] double gap(const Actor& a, const Actor& b);

/// First instant whose record has an impulse, or -1.
[[nodiscard]] int first_impact(const Run& run);

}  // namespace viz
