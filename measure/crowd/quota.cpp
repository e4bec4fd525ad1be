#include "lodlab/measure/crowd/quota.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/measure/crowd/frames_without.hpp"

namespace measure {
namespace {

using detail::FrameWithout;

/// Sums over bodies of |m (dv - dv_ref)|, and of |m dv_ref|.
struct MomentumChanges {
    double wrong = 0;
    double all = 0;

    [[nodiscard]] double share_wrong() const { return all > 0 ? wrong / all : 0; }
};

/// One quota and priority, over the frames so far.
template <int Dim>
class Trial {
  public:
    Trial(const QuotaPlan<Dim>& plan, lod::Priority priority, std::uint64_t quota)
        : settings_(plan.settings), quota_(quota) {
        settings_.priority = priority;
        storage_.executor = plan.executor;
    }

    void frame(const FrameWithout<Dim>& reference, std::span<const double> attention) {
        bodies_ = reference.before;
        lod::Budget budget = lod::Budget::node_tests(quota_);
        const auto& record = lod::advance<Dim>(bodies_, settings_, budget, storage_);
        add(reference, attention);
        const lod::LevelsReached reached = record.levels_reached();
        levels_ += reached.mean * static_cast<double>(reached.pairs);
        pairs_ += static_cast<double>(reached.pairs);
        cut_ += record.interrupted() ? 1 : 0;
        ++frames_;
    }

    [[nodiscard]] QuotaOutcome outcome() const {
        return {quota_, changes_.share_wrong(), attended_.share_wrong(),
                levels_ / std::max(1.0, pairs_), cut_ / std::max(1.0, frames_)};
    }

  private:
    void add(const FrameWithout<Dim>& reference, std::span<const double> attention) {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i].is_static()) continue;
            const double mass = 1 / bodies_[i].inverse_mass;
            const lod::Vector<Dim>& right = reference.after[i].velocity;
            const double wrong = mass * (bodies_[i].velocity - right).norm();
            const double all = mass * (right - reference.before[i].velocity).norm();
            changes_.wrong += wrong;
            changes_.all += all;
            attended_.wrong += attention[i] * wrong;
            attended_.all += attention[i] * all;
        }
    }

    lod::FrameSettings settings_;
    std::uint64_t quota_;
    lod::FrameStorage<Dim> storage_;
    std::vector<lod::Body<Dim>> bodies_;
    MomentumChanges changes_;
    MomentumChanges attended_;  ///< weighted by attention
    double levels_ = 0;
    double pairs_ = 0;
    double cut_ = 0;
    double frames_ = 0;
};

}  // namespace

template <int Dim>
std::vector<double> body_attention(const lod::Viewer& viewer,
                                   std::span<const lod::Body<Dim>> bodies,
                                   std::span<const lod::CandidatePair> pairs) {
    lod::Attention<Dim> attention;
    std::vector<double> of_pair;
    attention.weigh(viewer, bodies, pairs, of_pair);
    std::vector<double> most(bodies.size(), 0.0);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const std::int32_t body : {pairs[i].a, pairs[i].b})
            most[lod::at(body)] = std::max(most[lod::at(body)], of_pair[i]);
    return most;
}

template <int Dim>
QuotaOutcomes try_quotas(const QuotaPlan<Dim>& plan) {
    const detail::RunWithout<Dim> run{plan.bodies, plan.settings, plan.frames, plan.executor};
    QuotaOutcomes outcomes;
    outcomes.dearest = detail::run_without(run, [](const FrameWithout<Dim>&) {});
    std::vector<Trial<Dim>> trials;
    for (const lod::Priority priority : plan.priorities)
        for (const double share : plan.shares)
            trials.emplace_back(
                plan, priority,
                static_cast<std::uint64_t>(share * static_cast<double>(outcomes.dearest)));
    detail::run_without(run, [&](const FrameWithout<Dim>& reference) {
        const std::vector<double> attention =
            body_attention<Dim>(plan.settings.viewer, reference.before, reference.candidates);
        for (Trial<Dim>& trial : trials) trial.frame(reference, attention);
        if (plan.progress) plan.progress(reference.done);
    });
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (i % plan.shares.size() == 0) outcomes.of_priority.emplace_back();
        outcomes.of_priority.back().push_back(trials[i].outcome());
    }
    return outcomes;
}

#define MEASURE_INSTANTIATE(Dim)                              \
    template QuotaOutcomes try_quotas(const QuotaPlan<Dim>&); \
    template std::vector<double> body_attention(              \
        const lod::Viewer&, std::span<const lod::Body<Dim>>, std::span<const lod::CandidatePair>);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
