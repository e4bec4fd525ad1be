#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/frame/frame.hpp"

namespace lessons::impact {

constexpr double impulse_length = 0.8;  ///< metres of arrow for a newton second

/// A gear and a star, and the two nodes between which they are taken to touch.
struct Scene {
    viz::Actor<2> gear;
    viz::Actor<2> star;
    lod::Sphere<2> node_a;
    lod::Sphere<2> node_b;
    lod::Contact<2> contact;
    int level = 0;   ///< at which the traversal was interrupted
    double gap = 0;  ///< between the outlines [m]
    viz::Box view;
};

[[nodiscard]] Scene make_scene();

/// The bodies on their way, for readers to play with.
[[nodiscard]] live::Scene play(const Scene& start);

/// The flight, the impact and what follows, as a video.
void animate(Lesson& lesson, const Scene& start);

/// What the nodes' surfaces say of the direction (surface.cpp).
void give_surface(Lesson& lesson);

}  // namespace lessons::impact
