#pragma once

/// \file
/// One frame of an animation, from detection to motion: begin here. `lod::advance` does all of it,
/// `lod::detect` all that changes no body.

#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/frame/contact_stage.hpp"
#include "lodlab/core/frame/finest.hpp"
#include "lodlab/core/frame/frame_record.hpp"
#include "lodlab/core/frame/schedule.hpp"
#include "lodlab/core/frame/sweep.hpp"
#include "lodlab/core/response/response.hpp"
#include "lodlab/core/tree/budget.hpp"

namespace lod {

/// How a frame goes.
struct FrameSettings {
    double time_step = 1.0 / 120;  ///< [s], > 0
    int deepest_level = 1000;      ///< refinement stops after this level
    ContactModel contact_model = ContactModel::hull;
    PointModel point_model = PointModel::radius_ratio;
    Response response = Response::net;
    Priority priority = Priority::closing_speed;
    Viewer viewer = {};  ///< of Priority::perceptual
    Organisation organisation = Organisation::interleaved;
    FinestDetail finest = {};  ///< beyond the leaves; a warm frame allocates nothing without it
    SweepSettings sweep = {};  ///< between this frame and the next
};

/// Storage that frames reuse: once its lists have been as long as they get, a frame allocates
/// nothing.
template <int Dim>
struct FrameStorage {
    /// Whose threads do the frame's parts, which changes no bit of it; nothing: the calling one
    /// alone. It must outlive the frames.
    Executor* executor = nullptr;
    std::vector<PosedTree<Dim>> world_S;
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> candidates;
    Scheduler<Dim> scheduler;
    Fronts fronts;
    TrueShapePass<Dim> true_shapes;
    ContactStage<Dim> contacts;
    Resolver<Dim> resolver;
    Sweeper<Dim> sweeper;
    FrameRecord<Dim> record;
};

/// Detection and contact modelling at the present instant; no body changes. Throws lod::Error,
/// limit exceeded, where bodies crowd so that more pairs are near than most_candidates.
template <int Dim>
LOD_NO_DANGLING const FrameRecord<Dim>& detect(std::span<const Body<Dim>> bodies,
                                               const FrameSettings& settings, Budget& budget,
                                               FrameStorage<Dim>& storage);

/// One frame: detect, respond, integrate (with SweepSettings, sweep). A pair that is backtracked
/// (FinestDetail) responds where it stood at its time of impact and goes on from there. The record
/// is valid until the next call. Throws as detect, before a body has changed. Requires: every body
/// passed check_body.
template <int Dim>
LOD_NO_DANGLING const FrameRecord<Dim>& advance(std::span<Body<Dim>> bodies,
                                                const FrameSettings& settings, Budget& budget,
                                                FrameStorage<Dim>& storage);

}  // namespace lod
