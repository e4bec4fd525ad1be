#include "lodlab/measure/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"

namespace measure {
namespace {

/// The indices of the collisions of each pair of bodies, in order of time.
template <int Dim>
std::map<std::pair<int, int>, std::vector<int>> by_pair(
    std::span<const Collision<Dim>> collisions) {
    std::map<std::pair<int, int>, std::vector<int>> lists;
    for (int i = 0; i < static_cast<int>(collisions.size()); ++i)
        lists[{collisions[lod::at(i)].a, collisions[lod::at(i)].b}].push_back(i);
    return lists;
}

/// Least costs of pairing the first i of one list with the first j of the other.
class Alignment {
  public:
    Alignment(const std::vector<double>& reference, const std::vector<double>& seen, double window)
        : reference_(reference),
          seen_(seen),
          alone_(window / 2),
          width_(seen.size() + 1),
          cost_((reference.size() + 1) * width_) {
        for (std::size_t i = 0; i <= reference_.size(); ++i)
            for (std::size_t j = 0; j <= seen_.size(); ++j) cost_[i * width_ + j] = least(i, j);
    }

    /// Calls paired(i, j), missing(i) and extra(j) from the last to the first.
    template <class Paired, class Missing, class Extra>
    void trace(Paired&& paired, Missing&& missing, Extra&& extra) const {
        std::size_t i = reference_.size();
        std::size_t j = seen_.size();
        while (i > 0 || j > 0) {
            if (i > 0 && j > 0 && cost(i, j) == together(i, j))
                paired(--i, --j);
            else if (j == 0 || (i > 0 && cost(i, j) == cost(i - 1, j) + alone_))
                missing(--i);
            else
                extra(--j);
        }
    }

  private:
    [[nodiscard]] double cost(std::size_t i, std::size_t j) const { return cost_[i * width_ + j]; }
    [[nodiscard]] double together(std::size_t i, std::size_t j) const {
        return cost(i - 1, j - 1) + std::abs(reference_[i - 1] - seen_[j - 1]);
    }
    [[nodiscard]] double least(std::size_t i, std::size_t j) const {
        if (i == 0 || j == 0) return static_cast<double>(i + j) * alone_;
        return std::min({together(i, j), cost(i - 1, j) + alone_, cost(i, j - 1) + alone_});
    }

    const std::vector<double>& reference_;
    const std::vector<double>& seen_;
    double alone_;
    std::size_t width_;
    std::vector<double> cost_;
};

template <int Dim>
std::vector<double> times_of(std::span<const Collision<Dim>> collisions,
                             const std::vector<int>& chosen) {
    std::vector<double> times;
    for (const int i : chosen) times.push_back(collisions[lod::at(i)].time);
    return times;
}

}  // namespace

template <int Dim>
void CollisionLog<Dim>::add(double time, int a, int b, std::span<const lod::Body<Dim>> before,
                            std::span<const lod::Body<Dim>> after) {
    if (a > b) std::swap(a, b);
    const double apart = shapes_.separation(a, before[lod::at(a)], b, before[lod::at(b)]);
    const auto [latest, is_first] = latest_.try_emplace({a, b}, collisions_.size());
    steps_ += is_first ? 0 : 1;
    if (is_first || time - collisions_[latest->second].until > pause_) {
        latest->second = collisions_.size();
        collisions_.push_back({a,
                               b,
                               time,
                               time,
                               std::max(0.0, apart),
                               std::max(0.0, -apart),
                               {before[lod::at(a)], before[lod::at(b)]},
                               {after[lod::at(a)], after[lod::at(b)]}});
        return;
    }
    Collision<Dim>& found = collisions_[latest->second];
    found.until = time;
    found.penetration = std::max(found.penetration, -apart);
    found.after = {after[lod::at(a)], after[lod::at(b)]};
}

template <int Dim>
std::vector<Collision<Dim>> collisions_of(const scenes::Run<Dim>& run,
                                          std::span<const lod::Body<Dim>> bodies,
                                          const BodyShapes<Dim>& shapes, double pause) {
    CollisionLog<Dim> log(shapes, pause);
    std::vector<lod::Body<Dim>> before(bodies.begin(), bodies.end());
    std::vector<lod::Body<Dim>> after = before;
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
        const lod::FrameRecord<Dim>& record = run.steps[k].record;
        const auto& next = k + 1 < run.steps.size() ? run.steps[k + 1].before : run.end;
        for (std::size_t i = 0; i < before.size(); ++i) {
            scenes::put(run.steps[k].before[i], before[i]);
            after[i] = before[i];
            after[i].velocity = next[i].velocity;
            after[i].spin = next[i].spin;
        }
        std::map<std::pair<int, int>, double> pushed;  // and when, from the frame's instant
        for (std::size_t c = 0; c < record.impacts.size(); ++c) {
            if (!(record.impulses[c] > 0)) continue;
            const lod::PairRecord& pair = record.pairs[lod::at(record.impacts[c].pair)];
            pushed[{pair.bodies.a, pair.bodies.b}] =
                pair.finest == lod::Finest::backtrack ? pair.impact_time : 0;
        }
        for (const auto& [pair, later] : pushed)
            log.add(static_cast<double>(k) * run.settings.time_step + later, pair.first,
                    pair.second, before, after);
        for (const lod::SweptImpact<Dim>& met : record.swept) {
            if (!(met.impulse > 0)) continue;
            // As its first impact of the frame finds them.
            const std::array<std::int32_t, 2> bodies_met{met.a, met.b};
            for (const std::int32_t body : bodies_met)
                before[lod::at(body)] =
                    lod::moved_freely(before[lod::at(body)], met.time, run.settings.time_step);
            log.add(static_cast<double>(k) * run.settings.time_step + met.time, met.a, met.b,
                    before, after);
            for (const std::int32_t body : bodies_met)
                scenes::put(run.steps[k].before[lod::at(body)], before[lod::at(body)]);
        }
    }
    std::vector<Collision<Dim>> collisions = log.collisions();
    std::stable_sort(collisions.begin(), collisions.end(),
                     [](const auto& p, const auto& q) { return p.time < q.time; });
    return collisions;
}

std::vector<Collision<2>> collisions_of(const lod2d::Box2dRun& run, const BodyShapes<2>& shapes,
                                        double pause) {
    CollisionLog<2> log(shapes, pause);
    for (const lod2d::Box2dImpact& impact : run.impacts) {
        std::set<std::pair<int, int>> pushed;
        for (const lod2d::Box2dContact& contact : impact.contacts)
            pushed.insert({contact.a, contact.b});
        for (const auto& [a, b] : pushed) log.add(impact.time, a, b, impact.before, impact.after);
    }
    return log.collisions();
}

template <int Dim>
Matching match(std::span<const Collision<Dim>> reference, std::span<const Collision<Dim>> seen,
               double window) {
    const auto of_reference = by_pair(reference);
    const auto of_seen = by_pair(seen);
    std::set<std::pair<int, int>> bodies;
    for (const auto& [pair, list] : of_reference) bodies.insert(pair);
    for (const auto& [pair, list] : of_seen) bodies.insert(pair);
    const auto list_of = [](const auto& lists, const std::pair<int, int>& pair) {
        const auto found = lists.find(pair);
        return found == lists.end() ? std::vector<int>{} : found->second;
    };
    Matching matching;
    for (const auto& pair : bodies) {
        const std::vector<int> first = list_of(of_reference, pair);
        const std::vector<int> second = list_of(of_seen, pair);
        const std::vector<double> reference_times = times_of(reference, first);
        const std::vector<double> seen_times = times_of(seen, second);
        Alignment(reference_times, seen_times, window)
            .trace(
                [&](std::size_t i, std::size_t j) {
                    matching.pairs.push_back({first[i], second[j]});
                },
                [&](std::size_t i) { matching.missing.push_back(first[i]); },
                [&](std::size_t j) { matching.extra.push_back(second[j]); });
    }
    std::sort(matching.pairs.begin(), matching.pairs.end(),
              [](const auto& p, const auto& q) { return p.reference < q.reference; });
    std::sort(matching.missing.begin(), matching.missing.end());
    std::sort(matching.extra.begin(), matching.extra.end());
    return matching;
}

#define MEASURE_INSTANTIATE(Dim)                                                                   \
    template class CollisionLog<Dim>;                                                              \
    template std::vector<Collision<Dim>> collisions_of(                                            \
        const scenes::Run<Dim>&, std::span<const lod::Body<Dim>>, const BodyShapes<Dim>&, double); \
    template Matching match(std::span<const Collision<Dim>>, std::span<const Collision<Dim>>,      \
                            double);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
