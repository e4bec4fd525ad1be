// What could a frame save by what the last one found?
// Usage: bench_coherence [FRAMES [CROWD ...]]   100; gas:1000 implode:1000 rain:1000
// A pair that was proved apart is apart again, untested, where the bodies have moved against each
// other by less than the gap between them. Here the gap is the true shapes' distance, which no
// proof by balls or hulls exceeds, so that what is counted is more than any such memory can save.
// Besides: all pairs that are apart twice; and the node pairs above the last level, which a front
// that is carried on from frame to frame would not test again.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/thread_clock.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"

namespace {

using Body = lod::Body<2>;

/// How a pair was found, and where its bodies were.
struct Past {
    bool apart = false;
    double gap = 0;  ///< [m]
    Body a;
    Body b;
};

/// No point of the body is further from its centre of mass [m]. That of a half-space never turns.
double reach(const Body& body) {
    if (body.tree->is_half_space()) return 0;
    const lod::SphereTree<2>& tree = *body.tree;
    return tree.radius[0] + lod::Vector<2>(tree.centre[0][0], tree.centre[1][0]).norm();
}

/// By how much two bodies may have come nearer to each other since then [m].
double motion(const Past& past, const Body& a, const Body& b) {
    return ((b.position - a.position) - (past.b.position - past.a.position)).norm() +
           std::abs(a.orientation - past.a.orientation) * reach(a) +
           std::abs(b.orientation - past.b.orientation) * reach(b);
}

/// Of all frames.
struct Counts {
    double pairs = 0;
    double tests = 0;
    double known = 0;        ///< pairs that were candidates in the last frame
    double same = 0;         ///< of them, with the same verdict
    double above = 0;        ///< node pairs above the last levels
    double twice = 0;        ///< pairs that were apart and are
    double twice_tests = 0;  ///< of them
    double saved = 0;        ///< of them: whose gap is more than the motion
    double saved_tests = 0;
    double step = 0;  ///< processor time of all steps [us]
    double twice_time = 0;
    double saved_time = 0;
};

class Crowd {
  public:
    explicit Crowd(const std::string& spec)
        : setup_(scenes::set_up<2>(scenes::crowd(spec), {.cache = io::TreeCache::of_user()})),
          settings_(scenes::frame_settings(setup_.scene, {})) {
        for (const auto& shape : setup_.shapes)
            borders_.push_back(scenes::Shapes<2>::border_of(*shape));
    }

    void step(Counts& counts) {
        lod::Budget unlimited = lod::Budget::unlimited();
        const auto& record = lod::detect<2>(setup_.bodies, settings_, unlimited, storage_);
        std::vector<lod::CandidatePair> twice;
        std::vector<lod::CandidatePair> saved;
        std::map<std::pair<int, int>, Past> now;
        for (const lod::PairRecord& pair : record.pairs) {
            const Past& here = now[{pair.bodies.a, pair.bodies.b}] = seen(pair);
            counts.pairs += 1;
            counts.tests += static_cast<double>(pair.tests);
            const auto levels = lod::traverse_levels(here.a, here.b);
            for (std::size_t k = 0; k + 1 < levels.size(); ++k)
                counts.above += static_cast<double>(levels[k].pairs.size());
            const auto past = past_.find({pair.bodies.a, pair.bodies.b});
            if (past == past_.end()) continue;
            counts.known += 1;
            counts.same += past->second.apart == here.apart ? 1 : 0;
            if (!past->second.apart || !here.apart) continue;
            twice.push_back(pair.bodies);
            counts.twice_tests += static_cast<double>(pair.tests);
            if (motion(past->second, here.a, here.b) >= past->second.gap) continue;
            saved.push_back(pair.bodies);
            counts.saved_tests += static_cast<double>(pair.tests);
        }
        past_ = std::move(now);
        counts.twice += static_cast<double>(twice.size());
        counts.saved += static_cast<double>(saved.size());
        counts.twice_time += time_of(twice);
        counts.saved_time += time_of(saved);
        counts.step += timed([&] {
            lod::Budget budget = lod::Budget::unlimited();
            lod::advance<2>(setup_.bodies, settings_, budget, storage_);
        });
    }

  private:
    [[nodiscard]] Past seen(const lod::PairRecord& pair) const {
        const std::size_t a = lod::at(pair.bodies.a);
        const std::size_t b = lod::at(pair.bodies.b);
        Past past{pair.verdict == lod::Verdict::apart, 0, setup_.bodies[a], setup_.bodies[b]};
        if (past.apart)
            past.gap = lod2d::distance(borders_[a].carried({past.a.position, past.a.orientation}),
                                       borders_[b].carried({past.b.position, past.b.orientation}));
        return past;
    }

    template <class Work>
    [[nodiscard]] double timed(const Work& work) const {
        const auto begin = clock_.now();
        work();
        return 1e-3 * static_cast<double>((clock_.now() - begin).count());
    }

    /// Tests and hulls of these pairs alone.
    double time_of(const std::vector<lod::CandidatePair>& pairs) {
        return timed([&] {
            lod::Budget unlimited = lod::Budget::unlimited();
            scheduler_.refine_all({setup_.bodies,
                                   pairs,
                                   storage_.world_S,
                                   {settings_.deepest_level, true},
                                   settings_.priority,
                                   {}},
                                  unlimited, fronts_);
            for (std::size_t p = 0; p < pairs.size(); ++p) {
                const std::size_t a = lod::at(pairs[p].a);
                const std::size_t b = lod::at(pairs[p].b);
                contacts_.model(
                    {storage_.world_S[a], storage_.world_S[b], fronts_.pairs(p)},
                    {settings_.contact_model, settings_.point_model},
                    lod::pair_motion(setup_.bodies[a], setup_.bodies[b], settings_.time_step),
                    model_);
            }
        });
    }

    scenes::Setup<2> setup_;
    lod::FrameSettings settings_;
    std::vector<lod2d::BoundaryIndex> borders_;
    std::map<std::pair<int, int>, Past> past_;
    lod::FrameStorage<2> storage_;
    lod::Scheduler<2> scheduler_;
    lod::Fronts fronts_;
    lod::FrontContacts<2> contacts_;
    lod::FrontModel<2> model_;
    bench::ThreadClock clock_;
};

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 100;
    std::vector<std::string> specs(argv + std::min(argc, 2), argv + argc);
    if (specs.empty()) specs = {"gas:1000", "implode:1000", "rain:1000"};
    for (const std::string& spec : specs) {
        Crowd crowd(spec);
        Counts first;
        crowd.step(first);  // has no past
        Counts all;
        for (int frame = 1; frame < frames; ++frame) crowd.step(all);
        const auto percent = [](double part, double whole) { return 100 * part / whole; };
        std::printf(
            "%-13s %.0f pairs, %.0f tests a frame; of the pairs %.1f %% were candidates before, of "
            "these %.1f %% with the same verdict; apart twice: %.1f %% of pairs, %.1f %% of tests, "
            "%.1f %% of a step; gap above motion: %.1f, %.1f, %.1f %%; above the last level: "
            "%.1f %% of tests\n",
            spec.c_str(), all.pairs / (frames - 1), all.tests / (frames - 1),
            percent(all.known, all.pairs), percent(all.same, all.known),
            percent(all.twice, all.pairs), percent(all.twice_tests, all.tests),
            percent(all.twice_time, all.step), percent(all.saved, all.pairs),
            percent(all.saved_tests, all.tests), percent(all.saved_time, all.step),
            percent(all.above, all.tests));
    }
}
