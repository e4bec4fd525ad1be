#pragma once

/// \file
/// One frame of an animation, from detection to motion: begin here. `lod::advance` does all of it,
/// `lod::detect` all that changes no body.

#include <cstdint>
#include <optional>
#include <vector>

#include "lodlab/core/contact/front_contacts.hpp"
#include "lodlab/core/frame/finest.hpp"
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

/// What a frame found of one candidate pair; the lists that it points into are the record's.
struct PairRecord {
    CandidatePair bodies;
    int level = 0;  ///< last finished level
    Verdict verdict = Verdict::possible;
    std::uint64_t tests = 0;
    std::int32_t first_contact = 0;  ///< into impacts, impulses and contact_nodes
    std::int32_t contact_count = 0;
    Range nodes;  ///< into node_pairs: the overlapping nodes that nothing proved apart
    /// Beyond leaves: `level` is the leaves', but the verdict and the contacts are those of the
    /// true shapes.
    Finest finest = Finest::leaves;
    double impact_time = 0;  ///< when the true shapes touched, from the frame's instant [s]
};

/// What a frame did with its budget.
struct Spending {
    LevelCounts levels;  ///< beyond the entry ones
    /// Of a quota of node tests, beside what is reserved.
    std::optional<std::uint64_t> tests_left = {};
    /// Of a quota on a clock, at the end of the frame; negative where it was overrun.
    std::optional<std::chrono::nanoseconds> time_left = {};
};

/// Every stage's result of one frame. Pictures, lessons, traces and metrics read it and never hook
/// into the solver.
template <int Dim>
struct FrameRecord {
    std::vector<PairRecord> pairs;     ///< every candidate pair of the broad phase
    std::vector<NodePair> node_pairs;  ///< pair by pair, patch by patch
    std::vector<Impact<Dim>> impacts;  ///< the contacts, pair by pair; `pair` indexes `pairs`
    std::vector<Range> contact_nodes;  ///< same order; into node_pairs: the nodes behind each
                                       ///< contact, none behind an exact one
    std::vector<double> impulses;      ///< same order [N s]
    std::uint64_t tests = 0;           ///< node tests of the frame
    /// Where the budget ended before the finest level. A frame that ran on a clock gives the same
    /// bits when it is played again with Budget::until(*cut), unlimited where there is none.
    std::optional<Cut> cut;
    Spending spending;
    /// What the response of the finished levels may cost at most, in row visits: the reserve that
    /// Budget holds back as the cost of node pairs. Of Response::net.
    std::uint64_t reserved_row_visits = 0;
    ResponseReport response;   ///< of `advance`
    double energy_before = 0;  ///< kinetic, before the response [J]
    double energy_after = 0;   ///< kinetic, after it [J]
    /// What fast bodies ran into on the way to the next frame, in the order of time.
    std::vector<SweptImpact<Dim>> swept;

    /// Whether the budget ended before the finest level.
    [[nodiscard]] bool interrupted() const { return cut.has_value(); }
    /// The node pairs of a pair or behind a contact.
    [[nodiscard]] std::span<const NodePair> nodes_of(const Range& range) const {
        return range.of(std::span<const NodePair>(node_pairs));
    }
};

/// Storage that frames reuse: once its lists have been as long as they get, a frame allocates
/// nothing.
template <int Dim>
struct FrameStorage {
    std::vector<PosedTree<Dim>> world_S;
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> candidates;
    Scheduler<Dim> scheduler;
    Fronts fronts;
    TrueShapePass<Dim> true_shapes;
    FrontContacts<Dim> front_contacts;
    FrontModel<Dim> front;  ///< of one pair
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
