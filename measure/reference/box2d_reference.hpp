#pragma once

/// \file
/// A scene as Box2D runs it, for comparison.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lodlab/core/tree/body.hpp"
#include "lodlab/lod2d/shape/convex_parts.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// How Box2D is run for a comparison. Gravity, friction, damping, sleep, warm starting, continuous
/// collision and the restitution threshold are off; velocities are solved, positions never pushed.
struct Box2dSettings {
    double time_step = 1.0 / 960;  ///< [s], > 0; bodies spin far in a longer step
    int most_steps = 10000;        ///< of run_to_impact
    /// Box2D gives every polygon a skin of 0.01 of its units and welds corners nearer than 0.0025:
    /// with 16 units a metre these are 0.6 mm and 0.16 mm. A power of two keeps numbers exact.
    double units_per_metre = 16;
    int velocity_iterations = 100;  ///< of its solver; 8 is usual in games
    std::function<void(double share)>
        progress{};  ///< of run_box2d: the share done, after each frame
};

/// One contact point that Box2D pushed at. Points that the pieces of one body share count once.
struct Box2dContact {
    int a = 0;              ///< index of body A
    int b = 0;              ///< index of body B, above a
    Point point = {0, 0};   ///< world frame, midway between the two skins [m]
    Point normal = {0, 0};  ///< unit, from A towards B
    double impulse = 0;     ///< > 0 [N s]
};

/// A step of Box2D 2.4 in which impulses act.
struct Box2dImpact {
    bool happened = false;             ///< false: nothing met within most_steps
    double time = 0;                   ///< from the start to the instant of impact [s]
    std::vector<lod::Body<2>> before;  ///< at the instant; at the end where nothing happened
    std::vector<lod::Body<2>> after;   ///< the same poses with the velocities after the impact
    std::vector<Box2dContact> contacts;
};

/// A whole scene as Box2D 2.4 sees it.
struct Box2dRun {
    double frame_step = 0;  ///< [s]
    /// The bodies at the times 0, frame_step, 2 frame_step, ... : one entry more than frames.
    std::vector<std::vector<lod::Body<2>>> frames;
    /// Every step in which impulses act, in order of time: bodies that meet face to face may take
    /// several, one for each end of the face.
    std::vector<Box2dImpact> impacts;
};

/// Runs bodies for `frames` frames of `frame_step` seconds, each cut into equal steps of at most
/// settings.time_step. A step is lodlab's: detect where the bodies are, respond, move. Single
/// precision: numbers agree with exact mechanics to about 1e-6 of the largest that enters.
///
/// `shapes[i]` is the shape of body i, in its body frame; of a half-space Box2D gets the border, as
/// an edge that reaches 1 km to either side. Concave shapes become convex pieces of at
/// most 8 corners; mass and inertia are the bodies' own. A pair's restitution is the smaller one.
/// Requires frame_step > 0, frames >= 0. Throws lod::Error: input refused where a shape is too fine
/// for Box2D at this scale, which is where more than a thousandth of its area lies in pieces
/// thinner than Box2D can hold; limit exceeded where a body moves or turns farther in one step than
/// Box2D lets it.
[[nodiscard]] Box2dRun run_box2d(std::span<const lod::Body<2>> bodies,
                                 std::span<const Shape* const> shapes, std::int64_t frames,
                                 double frame_step, const Box2dSettings& settings = {});

/// The same to the first step in which an impulse acts, and that step, in steps of
/// settings.time_step.
[[nodiscard]] Box2dImpact run_to_impact(std::span<const lod::Body<2>> bodies,
                                        std::span<const Shape* const> shapes,
                                        const Box2dSettings& settings = {});

}  // namespace lod2d
