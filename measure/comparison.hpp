#pragma once

/// \file
/// One scene by lodlab at every level, exactly, and by Box2D, with what an observer would see
/// wrong.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lodlab/measure/first_impact.hpp"
#include "lodlab/measure/perceived.hpp"

namespace measure {

/// A scene run by lodlab in one way, and how wrong that looks against Box2D's run.
struct ComparedRun {
    int level = 0;  ///< the deepest level that frames tested; leaves where it is beyond all trees
    scenes::Run<2> run;
    std::vector<Collision<2>> collisions;
    PerceivedError perceived;
};

/// Two bodies that, in Box2D's run, had met nobody before they met each other: until then they
/// moved freely, so every way of computing starts from the same numbers. Or, where Box2D finds no
/// collision of either, two that a level takes to collide. Only the first push counts: teeth that
/// mesh push again a moment later.
struct FirstImpact {
    int a = 0;
    int b = 0;
    std::optional<Collision<2>> box2d;
    std::optional<Collision<2>> exact;                ///< of the two bodies alone
    std::vector<std::optional<Collision<2>>> levels;  ///< the same, one a level
};

/// A scene of the plane by lodlab at every level, exactly, and by Box2D.
struct Comparison {
    lod2d::Box2dSettings box2d_settings;
    lod2d::Box2dRun box2d;
    std::vector<Collision<2>> box2d_collisions;
    /// Frames that go on to the true shapes of every pair and back to its time of impact.
    ComparedRun exact;
    std::vector<ComparedRun> levels;         ///< 0 to the deepest of any tree
    std::vector<FirstImpact> first_impacts;  ///< in order of time
};

/// How a comparison goes.
struct ComparisonOptions {
    lod::FrameSettings settings;  ///< its deepest_level and finest are not used
    std::int64_t frames = 1;
    lod2d::Box2dSettings box2d;  ///< raised and shortened where shapes are too fine or fast
    PerceivedSettings perceived;
    lod::Executor* executor = nullptr;  ///< whose threads do the parts of frames; it changes no bit
    std::function<void(double share)> progress{};  ///< called with the share done, 0 to 1
};

/// Runs the scene in all ways. Impacts are compared one by one only where two bodies meet first:
/// after several, every small difference has grown, and Box2D's run is one of many true ones.
/// Requires: bodies with tree and exact shape; entry k of `shapes` is the shape of body k.
/// Throws lod::Error as lod2d::run_box2d, scenes::run and lod::time_of_impact do.
[[nodiscard]] Comparison compare(std::span<const lod::Body<2>> bodies,
                                 std::span<const lod2d::Shape* const> shapes,
                                 const ComparisonOptions& options);

}  // namespace measure
