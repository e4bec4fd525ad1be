#include "lodlab/measure/crowd/quota.hpp"

#include <algorithm>

#include "lodlab/core/base/stop.hpp"

namespace measure {
namespace {

/// What a frame of the run without a quota began with, and ended with.
template <int Dim>
struct FrameWithout {
    std::vector<lod::Body<Dim>> before;
    std::vector<lod::Body<Dim>> after;
};

/// Sum over bodies of |m (dv - dv_ref)|, and of |m dv_ref|.
struct MomentumChanges {
    double wrong = 0;
    double all = 0;
};

template <int Dim>
void add(const FrameWithout<Dim>& reference, const std::vector<lod::Body<Dim>>& after,
         MomentumChanges& changes) {
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (after[i].is_static()) continue;
        const double mass = 1 / after[i].inverse_mass;
        changes.wrong += mass * (after[i].velocity - reference.after[i].velocity).norm();
        changes.all += mass * (reference.after[i].velocity - reference.before[i].velocity).norm();
    }
}

/// One quota and priority, over the frames so far.
template <int Dim>
class Trial {
  public:
    Trial(const QuotaPlan<Dim>& plan, lod::Priority priority, std::uint64_t quota)
        : settings_(plan.settings), quota_(quota) {
        settings_.priority = priority;
    }

    void frame(const FrameWithout<Dim>& reference) {
        bodies_ = reference.before;
        lod::Budget budget = lod::Budget::node_tests(quota_);
        const auto& record = lod::advance<Dim>(bodies_, settings_, budget, storage_);
        add(reference, bodies_, changes_);
        for (const lod::PairRecord& pair : record.pairs) {
            if (pair.verdict == lod::Verdict::apart) continue;
            levels_ += pair.level;
            ++pairs_;
        }
        cut_ += record.interrupted() ? 1 : 0;
        ++frames_;
    }

    [[nodiscard]] QuotaOutcome outcome() const {
        return {quota_, changes_.all > 0 ? changes_.wrong / changes_.all : 0,
                levels_ / std::max(1.0, pairs_), cut_ / std::max(1.0, frames_)};
    }

  private:
    lod::FrameSettings settings_;
    std::uint64_t quota_;
    lod::FrameStorage<Dim> storage_;
    std::vector<lod::Body<Dim>> bodies_;
    MomentumChanges changes_;
    double levels_ = 0;
    double pairs_ = 0;
    double cut_ = 0;
    double frames_ = 0;
};

/// Calls frame(reference) for each frame without a quota. Returns the most tests that one needs.
template <int Dim, class Frame>
std::uint64_t run(const QuotaPlan<Dim>& plan, const Frame& frame) {
    FrameWithout<Dim> reference;
    reference.after.assign(plan.bodies.begin(), plan.bodies.end());
    lod::FrameStorage<Dim> storage;
    std::uint64_t dearest = 0;
    for (std::int64_t i = 0; i < plan.frames; ++i) {
        lod::check_interrupted();
        reference.before = reference.after;
        lod::Budget budget = lod::Budget::unlimited();
        dearest = std::max(
            dearest, lod::advance<Dim>(reference.after, plan.settings, budget, storage).tests);
        frame(reference, static_cast<double>(i + 1) / static_cast<double>(plan.frames));
    }
    return dearest;
}

}  // namespace

template <int Dim>
QuotaOutcomes try_quotas(const QuotaPlan<Dim>& plan) {
    QuotaOutcomes outcomes;
    outcomes.dearest = run(plan, [](const FrameWithout<Dim>&, double) {});
    std::vector<Trial<Dim>> trials;
    for (const lod::Priority priority : plan.priorities)
        for (const double share : plan.shares)
            trials.emplace_back(
                plan, priority,
                static_cast<std::uint64_t>(share * static_cast<double>(outcomes.dearest)));
    run(plan, [&](const FrameWithout<Dim>& reference, double done) {
        for (Trial<Dim>& trial : trials) trial.frame(reference);
        if (plan.progress) plan.progress(done);
    });
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (i % plan.shares.size() == 0) outcomes.of_priority.emplace_back();
        outcomes.of_priority.back().push_back(trials[i].outcome());
    }
    return outcomes;
}

template QuotaOutcomes try_quotas(const QuotaPlan<2>&);
template QuotaOutcomes try_quotas(const QuotaPlan<3>&);

}  // namespace measure
