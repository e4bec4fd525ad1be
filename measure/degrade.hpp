#pragma once

/// \file
/// Random impacts at every level against the exact answer: the measurement behind `lodlab degrade`.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/measure/ensemble.hpp"

namespace measure {

/// One impact as one level of detail answers it, against the exact answer.
struct Outcome {
    /// |J - J_exact| / |J_exact| of the impulse that the bodies exchange, which is the error of
    /// either body's velocity over its change.
    double impulse_error = 0;
    double angle_error = 0;  ///< between the ways in which a body leaves, the worse body's [rad]
    double spin_error = 0;   ///< between a body's spins after it, the worse body's [rad/s]
    double gap = 0;          ///< between the shapes when something pushes, 0 where they overlap [m]
    double gap_bound = 0;    ///< e_k(A) + e_k(B) and the motion of one step [m]
    double delay = 0;        ///< of the push after the exact impact [s]; negative: too early
    double tests = 0;        ///< node tests of the frame that pushes
    double microseconds = 0;  ///< that its detection and response took; 0 without a clock
    /// Nothing pushed until `patience` after the exact impact: the bodies pass through each other.
    /// Counts as an impulse of zero and a delay of the patience.
    bool missed = false;

    friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// One part of a long measurement, for machines that share the work: the impacts whose number
/// leaves `index` - 1 when divided by `count`.
struct Share {
    int index = 1;  ///< 1 to count
    int count = 1;
    /// Whether the impact of that number is of this share.
    [[nodiscard]] bool holds(int number) const { return number % count == index - 1; }
};

/// What is measured. Two measurements with equal plans have equal outcomes, but for the time.
struct Plan {
    int dim = 2;
    std::vector<std::string> shapes;
    std::string builder;  ///< by name
    int branching = 4;
    int depth = 6;                 ///< levels 0 to depth, and the exact one
    int impacts = 0;               ///< of all shares together
    double time_step = 1.0 / 960;  ///< [s]
    EnsembleSettings ensemble;
    std::vector<lod::ContactModel> models;
    std::vector<lod::Response> responses;

    /// How many: one for each model and response.
    [[nodiscard]] std::size_t curves() const { return models.size() * responses.size(); }
    /// Of a curve, the exact one included.
    [[nodiscard]] std::size_t levels() const { return static_cast<std::size_t>(depth) + 2; }
    friend bool operator==(const Plan&, const Plan&) = default;
};

/// One impact under every curve and level.
struct ImpactSample {
    int number = 0;
    /// Curve by curve (each response for the first contact model, then for the next), level by
    /// level, the exact one last: curves() x levels() entries.
    std::vector<Outcome> outcomes;

    friend bool operator==(const ImpactSample&, const ImpactSample&) = default;
};

/// Every outcome of a measurement or of one share of it, so that shares can be put together.
struct Outcomes {
    Plan plan;
    std::vector<ImpactSample> impacts;  ///< by number

    /// Whether every impact of the plan is there.
    [[nodiscard]] bool complete() const {
        return impacts.size() == static_cast<std::size_t>(plan.impacts);
    }
};

/// How a measurement goes; nothing here changes a result.
struct DegradeOptions {
    Share share;
    const lod::Clock* clock = nullptr;  ///< nothing: times are 0, and every bit is repeatable
    /// Whose threads do impacts; several at a time share the machine, so their times are longer.
    lod::Executor* executor = nullptr;
    std::function<void(double)> progress{};  ///< share of the work done, 0 to 1
};

/// How long after the exact impact a level may still push [s]. Ours: many times what any level
/// needs; what has not bounced by then has passed through.
inline constexpr double patience = 0.25;

/// Throws lod::Error (usage) where the plan or the share is out of range, or the share is empty.
void check_plan(const Plan& plan, const Share& share);

/// Runs every impact of the share at every level by frames of the plan's time step, each by
/// lod::advance with the level as the deepest, until something pushes. Frames in which a level
/// cannot have a front are skipped (measure/free_flight.hpp), which changes no result.
/// Requires: shapes belong to the plan's shapes. Throws lod::Error as check_plan does.
template <int Dim>
[[nodiscard]] Outcomes degrade(const Plan& plan, std::span<const MeasuredShape<Dim>> shapes,
                               const DegradeOptions& options = {});

/// Puts shares together, in any order: the same bits as one run (without a clock). Throws
/// lod::Error (input refused) where their plans differ, impacts are there twice, or some are
/// missing.
[[nodiscard]] Outcomes merged(std::vector<Outcomes> shares);

}  // namespace measure
