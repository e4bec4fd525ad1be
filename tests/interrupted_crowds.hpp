#pragma once

// The method's promise in crowds: wherever a frame is interrupted, no true collision is missed. The
// points of interruption, what is asked at each, and the crowds; bench/interruptions.cpp goes on
// where the tests take a sample.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"

namespace lodtest {

/// The bodies of a crowd as they stand.
template <int Dim>
struct Instant {
    std::vector<lod::Body<Dim>> bodies;
    /// Those whose true shapes share a point, by an oracle that knows nothing of trees; sorted.
    std::vector<lod::CandidatePair> touching;
    bool at_rest = false;
};

/// The first pair of bodies that touch and that the frame misses: it is no candidate, is called
/// apart or has no nodes that overlap; or, where nothing moves, it has no contact. (Where bodies
/// move, those that part wherever their hulls touch are answered by none: Manifold::parts.)
/// Requires: ContactModel::hull.
template <int Dim>
std::optional<lod::CandidatePair> missed(const lod::FrameRecord<Dim>& record,
                                         const Instant<Dim>& instant) {
    auto found = record.pairs.begin();
    for (const lod::CandidatePair& pair : instant.touching) {
        while (found != record.pairs.end() &&
               std::pair(found->bodies.a, found->bodies.b) < std::pair(pair.a, pair.b))
            ++found;
        if (found == record.pairs.end() || found->bodies != pair ||
            found->verdict == lod::Verdict::apart || found->nodes.count == 0 ||
            (instant.at_rest && found->contact_count == 0))
            return pair;
    }
    return std::nullopt;
}

/// What was checked.
struct Checked {
    std::uint64_t points = 0;    ///< frames that were interrupted
    std::uint64_t verdicts = 0;  ///< of pairs that touch, in these frames
    std::uint64_t by_count = 0;  ///< of the points
    std::uint64_t within_levels = 0;
    std::uint64_t by_clock = 0;
    std::uint64_t misses = 0;
    std::string first_miss;

    void add(const Checked& other) {
        points += other.points;
        verdicts += other.verdicts;
        by_count += other.by_count;
        within_levels += other.within_levels;
        by_clock += other.by_clock;
        if (misses == 0) first_miss = other.first_miss;
        misses += other.misses;
    }
};

/// Goes on by 40 ns a look, and at one look by an hour.
class LeapingClock final : public lod::Clock {
  public:
    explicit LeapingClock(int leap) : leap_(leap) {}
    std::chrono::nanoseconds now() const override {
        if (++looks_ == leap_) time_ += std::chrono::hours(1);
        return time_ += std::chrono::nanoseconds(40);
    }
    [[nodiscard]] bool leapt() const { return looks_ >= leap_; }

  private:
    int leap_;
    mutable int looks_ = 0;
    mutable std::chrono::nanoseconds time_{};
};

/// One crowd at an instant, detected again and again and interrupted elsewhere each time.
template <int Dim>
class InterruptedCrowd {
  public:
    /// `most`: points of each kind and way; where there are more, they are spread evenly.
    InterruptedCrowd(const Instant<Dim>& instant, std::uint64_t most)
        : instant_(instant), most_(most) {
        lod::Budget unlimited = lod::Budget::unlimited();
        const auto& record = lod::detect<Dim>(instant_.bodies, {}, unlimited, storage_);
        all_tests_ = record.tests;
        all_node_pairs_ = record.node_pairs.size();
        note(record, "not at all", 0);
        for (std::size_t p = 0; p < record.pairs.size(); ++p) {
            const auto [a, b] = record.pairs[p].bodies;
            const auto levels =
                lod::traverse_levels(instant_.bodies[lod::at(a)], instant_.bodies[lod::at(b)]);
            for (std::size_t k = 1; k < levels.size(); ++k)
                for (std::uint64_t t = 0; t < levels[k].tests - levels[k - 1].tests; ++t)
                    cuts_.push_back(
                        {static_cast<std::int32_t>(p), static_cast<std::int32_t>(k), t, {}, {}});
        }
    }

    /// All points of a policy and organisation.
    void interrupt(lod::Priority priority, lod::Organisation organisation) {
        settings_.priority = priority;
        settings_.organisation = organisation;
        ++round_;
        for (const std::uint64_t cost : {0, 3})
            each(all_tests_ + cost * all_node_pairs_, [&](std::uint64_t quota) {
                const bool cut = look(lod::Budget::node_tests(quota, static_cast<double>(cost)),
                                      "by count", quota);
                checked_.by_count += cut ? 1 : 0;
            });
        each(cuts_.size(), [&](std::uint64_t cut) {
            const bool within = look(lod::Budget::until(cuts_[cut]), "within a level", cut);
            checked_.within_levels += within ? 1 : 0;
        });
        for (const int quota : {1, 2, 4, 8, 16, 32})
            for (const int reserved : {0, 250}) interrupt_on_clock(quota, reserved);
    }

    [[nodiscard]] const Checked& checked() const { return checked_; }

  private:
    template <class Look>
    void each(std::uint64_t all, const Look& at_point) {
        const std::uint64_t stride = 1 + all / (most_ + 1);
        for (std::uint64_t k = round_ * 7 % stride; k < all; k += stride) at_point(k);
    }

    /// At every look at a clock; the first look tells when the frame begins. Where time is reserved
    /// [ns a node pair], entry levels and contacts end on it, too.
    void interrupt_on_clock(int microseconds, int reserved) {
        for (int leap = 2; leap < 2 + static_cast<int>(most_); ++leap) {
            const LeapingClock clock(leap);
            const bool cut =
                look(lod::Budget::deadline(clock, std::chrono::microseconds(microseconds),
                                           std::chrono::nanoseconds(reserved)),
                     "by clock", static_cast<std::uint64_t>(leap));
            checked_.by_clock += cut ? 1 : 0;
            if (!clock.leapt()) break;
        }
    }

    /// Returns whether the frame was interrupted.
    bool look(lod::Budget budget, const char* how, std::uint64_t number) {
        const auto& record = lod::detect<Dim>(instant_.bodies, settings_, budget, storage_);
        if (!record.interrupted()) return false;
        ++checked_.points;
        checked_.verdicts += instant_.touching.size();
        note(record, how, number);
        return true;
    }

    void note(const lod::FrameRecord<Dim>& record, const char* how, std::uint64_t number) {
        const auto pair = missed<Dim>(record, instant_);
        if (!pair || checked_.misses++ > 0) return;
        checked_.first_miss = "bodies " + std::to_string(pair->a) + " and " +
                              std::to_string(pair->b) + ", interrupted " + how + " at " +
                              std::to_string(number) + ", " +
                              std::string(lod::name_of(settings_.priority)) + ", " +
                              std::string(lod::name_of(settings_.organisation));
    }

    const Instant<Dim>& instant_;
    std::uint64_t most_;
    std::uint64_t all_tests_ = 0;
    std::uint64_t all_node_pairs_ = 0;
    std::vector<lod::Cut> cuts_;  ///< every test of every level
    std::uint64_t round_ = 0;
    lod::FrameSettings settings_;
    lod::FrameStorage<Dim> storage_;
    Checked checked_;
};

/// A crowd that runs, for its instants.
template <int Dim>
class Crowd {
  public:
    explicit Crowd(const scenes::Scene& scene, const io::TreeCache& cache = {})
        : setup_(scenes::set_up<Dim>(scene, {.cache = cache})) {
        settings_ = scenes::frame_settings(setup_.scene, {});
        for (const auto& shape : setup_.shapes) borders_.push_back(&border_of(*shape));
    }

    /// The bodies now, all nearer to the middle by `squeeze` than they are.
    [[nodiscard]] Instant<Dim> instant(double squeeze, bool at_rest) const {
        Instant<Dim> result{setup_.bodies, {}, at_rest};
        for (lod::Body<Dim>& body : result.bodies) {
            if (body.is_static()) continue;
            body.position *= squeeze;
            if (!at_rest) continue;
            body.velocity = lod::Vector<Dim>::Zero();
            body.spin = lod::Spin<Dim>::Zero();
        }
        for (std::size_t a = 0; a < result.bodies.size(); ++a)
            for (std::size_t b = a + 1; b < result.bodies.size(); ++b) {
                if (result.bodies[a].is_static() && result.bodies[b].is_static()) continue;
                if (scenes::Shapes<Dim>::touch(*borders_[a], result.bodies[a], *borders_[b],
                                               result.bodies[b]))
                    result.touching.push_back(
                        {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
            }
        return result;
    }

    void run(int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            lod::Budget budget = lod::Budget::unlimited();
            lod::advance<Dim>(setup_.bodies, settings_, budget, storage_);
        }
    }

  private:
    using Border = typename scenes::Shapes<Dim>::Border;

    /// Equal bodies share a shape.
    const Border& border_of(const scenes::Shape<Dim>& shape) {
        for (const auto& [known, border] : made_)
            if (known == &shape) return *border;
        made_.emplace_back(&shape, std::make_unique<Border>(scenes::Shapes<Dim>::border_of(shape)));
        return *made_.back().second;
    }

    scenes::Setup<Dim> setup_;
    lod::FrameSettings settings_;
    lod::FrameStorage<Dim> storage_;
    std::vector<std::pair<const scenes::Shape<Dim>*, std::unique_ptr<Border>>> made_;
    std::vector<const Border*> borders_;  ///< of each body
};

/// A crowd of space made of solids that are quickly built.
inline scenes::Scene crowd_of_solids(const std::string& spec, int depth) {
    scenes::Scene scene = scenes::crowd(spec);
    std::size_t next = 0;
    for (scenes::BodySpec& body : scene.bodies) {
        if (body.shape == scenes::half_space_name) continue;
        static const char* const solids[] = {"L", "gear:5,0.25,0.4", "box", "ring:0.12,24"};
        body.shape = solids[next++ % std::size(solids)];
        body.depth = depth;
    }
    return scene;
}

}  // namespace lodtest
