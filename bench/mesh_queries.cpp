// Queries of two posed meshes: level by level by their sphere trees, and exactly by FCL.
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/meshes.hpp"
#include "bench/timing.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/tree/family_tests.hpp"
#include "lodlab/lod3d/builder/tree_report.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"
#include "tests/lod3d/fcl_oracle.hpp"
#include "tests/lod3d/random_pose.hpp"

namespace bench {
namespace {

/// Two bodies of one solid at random: turned any way, their centres up to a diameter apart.
struct Meeting {
    lod::Body<3> a;
    lod::Body<3> b;
    lod3d::Pose pose_a;
    lod3d::Pose pose_b;
    fcl::Transform3d fcl_a;
    fcl::Transform3d fcl_b;
};

std::vector<Meeting> random_meetings(const std::shared_ptr<const lod::SphereTree<3>>& tree,
                                     double diameter, int count) {
    lod::Random random(20260701);
    std::vector<Meeting> meetings;
    const auto placed = [&](const lod3d::Point& position) {
        lod::Body<3> body;
        body.tree = tree;
        body.position = position;
        body.orientation = random_orientation(random);
        return body;
    };
    for (int i = 0; i < count; ++i) {
        Meeting m;
        m.a = placed(lod3d::Point::Zero());
        m.b = placed(diameter * random.next() * random_direction(random));
        const auto pose = [](const lod::Body<3>& body, lod3d::Pose& ours,
                             fcl::Transform3d& theirs) {
            ours = {lod::Space<3>::rotation(body.orientation), body.position};
            theirs = lodtest::fcl_pose(ours.rotation, ours.position);
        };
        pose(m.a, m.pose_a, m.fcl_a);
        pose(m.b, m.pose_b, m.fcl_b);
        meetings.push_back(m);
    }
    return meetings;
}

/// From the poses of two bodies to an answer.
class LevelQuery {
  public:
    /// The verdict of a level.
    lod::Verdict operator()(const Meeting& m, int level) {
        pose(m);
        lod::test_roots(a_, b_, front_, list_);
        lod::Budget budget = lod::Budget::unlimited();
        while (front_.level < level && !front_.finest && front_.pairs.count > 0)
            static_cast<void>(lod::refine(a_, b_, budget, front_, list_));
        tests_ += front_.tests;
        return front_.pairs.count == 0 ? lod::Verdict::apart : front_.verdict;
    }

    /// Whether any nodes of it overlap.
    bool any(const Meeting& m, int level) {
        pose(m);
        return lod::overlap_at(a_, b_, level, list_);
    }

    /// Node tests of all verdicts so far.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }

  private:
    void pose(const Meeting& m) {
        a_.pose(m.a);
        b_.pose(m.b);
        list_.clear();
    }

    std::uint64_t tests_ = 0;
    lod::PosedTree<3> a_;
    lod::PosedTree<3> b_;
    lod::FrontList list_;
    lod::ListedFront front_;
};

/// What is true of a pair of poses.
struct Truth {
    bool touching = false;
    double gap = 0;  ///< where they are apart [m]
};

std::vector<Truth> find_truth(const std::vector<Meeting>& meetings,
                              const std::shared_ptr<lodtest::FclModel>& model) {
    std::vector<Truth> truth;
    for (const Meeting& m : meetings) {
        fcl::CollisionResultd hit;
        Truth of{fcl::collide(model.get(), m.fcl_a, model.get(), m.fcl_b, fcl::CollisionRequestd(),
                              hit) > 0};
        fcl::DistanceResultd near;
        if (!of.touching)
            of.gap = fcl::distance(model.get(), m.fcl_a, model.get(), m.fcl_b,
                                   fcl::DistanceRequestd(), near);
        truth.push_back(of);
    }
    return truth;
}

/// How a level's verdicts compare with the truth.
struct Errors {
    int met = 0;             ///< pairs that are not called apart
    int wrong = 0;           ///< of these, apart in truth
    int missed = 0;          ///< called apart, though they touch: never
    double largest_gap = 0;  ///< of the wrong ones [m]
};

Errors errors_of(LevelQuery& query, int level, const std::vector<Meeting>& meetings,
                 const std::vector<Truth>& truth) {
    Errors errors;
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        const bool apart = query(meetings[i], level) == lod::Verdict::apart;
        errors.missed += apart && truth[i].touching;
        if (apart) continue;
        ++errors.met;
        if (truth[i].touching) continue;
        ++errors.wrong;
        errors.largest_gap = std::max(errors.largest_gap, truth[i].gap);
    }
    return errors;
}

/// Medians of all pairs together [s].
struct Seconds {
    std::vector<double> verdict;    ///< of each level
    std::vector<double> any;        ///< of each level: whether any nodes overlap
    std::vector<double> paths;      ///< of the finest level's verdicts, by each way of computing
    std::vector<double> paths_any;  ///< the same, whether any overlap
    double triangles = 0;           ///< lod3d, first hit
    double first_hit = 0;           ///< FCL
    double all_hits = 0;            ///< FCL
};

void print_levels(LevelQuery& query, const std::vector<Meeting>& meetings,
                  const std::vector<Truth>& truth, const lod::TreeReport& report,
                  const Seconds& seconds) {
    const auto pairs = static_cast<double>(meetings.size());
    std::printf(
        "level | nodes | us a verdict | tests | tests a ns | FCL, all hits / it | us whether any | "
        "FCL, first hit / it | not apart | of these apart | error bound %% | mean protrusions %% | "
        "largest gap %%\n");
    for (std::size_t level = 0; level < seconds.verdict.size(); ++level) {
        const std::uint64_t before = query.tests();
        const Errors errors = errors_of(query, static_cast<int>(level), meetings, truth);
        const auto tests = static_cast<double>(query.tests() - before);
        const lod::LevelReport& of = report.levels[level];
        std::printf(
            "%zu | %d | %.2f | %.0f | %.2f | %.0f x | %.2f | %.1f x | %d | %.1f %% | %.2f | %.2f | "
            "%.2f%s\n",
            level, of.nodes, 1e6 * seconds.verdict[level] / pairs, tests / pairs,
            1e-9 * tests / seconds.verdict[level], seconds.all_hits / seconds.verdict[level],
            1e6 * seconds.any[level] / pairs, seconds.first_hit / seconds.any[level], errors.met,
            errors.met > 0 ? 100.0 * errors.wrong / errors.met : 0.0,
            200 * of.worst_protrusion_fraction, 200 * of.mean_protrusion_fraction,
            100 * errors.largest_gap / report.bounding_diameter,
            errors.missed > 0 ? "  MISSED A COLLISION" : "");
        if (level + 1 == seconds.verdict.size())
            for (std::size_t i = 0; i < seconds.paths.size(); ++i)
                std::printf("  %s: %.2f us a verdict, %.2f tests a ns; %.2f us whether any\n",
                            std::string(lod::detail::test_paths()[i].name).c_str(),
                            1e6 * seconds.paths[i] / pairs, 1e-9 * tests / seconds.paths[i],
                            1e6 * seconds.paths_any[i] / pairs);
    }
    const auto exact_row = [&](const char* name, double of) {
        std::printf("%s | %.2f us | FCL, first hit / it %.2f | FCL, all hits / it %.2f\n", name,
                    1e6 * of / pairs, seconds.first_hit / of, seconds.all_hits / of);
    };
    exact_row("triangles, lod3d, first hit", seconds.triangles);
    exact_row("triangles, FCL, first hit", seconds.first_hit);
    exact_row("triangles, FCL, all hits", seconds.all_hits);
}

/// Everything in turn, so that what else the machine does falls on all alike.
Seconds measure(const std::vector<Meeting>& meetings, int levels, const lod3d::Solid& solid,
                const std::shared_ptr<lodtest::FclModel>& model) {
    const lod3d::TriangleTree triangles(solid.mesh);
    LevelQuery query;
    long checksum = 0;
    std::vector<std::function<void()>> works;
    const auto add_levels = [&](int first, const lod::detail::TestPath& path) {
        for (int level = first; level < levels; ++level) {
            works.emplace_back([&, level] {
                lod::detail::take_path(path);
                for (const Meeting& m : meetings) checksum += static_cast<int>(query(m, level));
            });
            works.emplace_back([&, level] {
                lod::detail::take_path(path);
                for (const Meeting& m : meetings) checksum += query.any(m, level);
            });
        }
    };
    add_levels(0, lod::detail::test_paths().front());
    for (const lod::detail::TestPath& path : lod::detail::test_paths())
        add_levels(levels - 1, path);
    works.emplace_back([&] {
        for (const Meeting& m : meetings)
            checksum += lod3d::surfaces_intersect(triangles, m.pose_a, triangles, m.pose_b);
    });
    for (const std::size_t most_contacts : {std::size_t{1}, std::size_t{1'000'000}})
        works.emplace_back([&, most_contacts] {
            for (const Meeting& m : meetings) {
                fcl::CollisionResultd hit;
                checksum +=
                    static_cast<long>(fcl::collide(model.get(), m.fcl_a, model.get(), m.fcl_b,
                                                   fcl::CollisionRequestd(most_contacts), hit));
            }
        });
    const std::vector<double> taken = medians_of(7, works);
    lod::detail::take_path(lod::detail::test_paths().front());
    Seconds seconds;
    const auto by_level = 2 * static_cast<std::size_t>(levels);
    for (std::size_t i = 0; i + 3 < taken.size(); ++i) {
        auto& verdicts = i < by_level ? seconds.verdict : seconds.paths;
        auto& anys = i < by_level ? seconds.any : seconds.paths_any;
        (i % 2 == 0 ? verdicts : anys).push_back(taken[i]);
    }
    seconds.triangles = taken[taken.size() - 3];
    seconds.first_hit = taken[taken.size() - 2];
    seconds.all_hits = taken[taken.size() - 1];
    std::printf("(%ld)\n", checksum);  // so that no query is left out
    return seconds;
}

}  // namespace

void query_pairs(const lod3d::Solid& solid, int pairs, int depth) {
    const auto tree =
        std::make_shared<lod::SphereTree<3>>(lod3d::build_tree(solid, {.depth = depth}));
    const lod::TreeReport report = lod3d::report_tree(solid, *tree);
    const auto meetings = random_meetings(tree, report.bounding_diameter, pairs);
    const auto model = lodtest::fcl_model(solid.mesh);
    const auto truth = find_truth(meetings, model);
    const auto touching =
        std::count_if(truth.begin(), truth.end(), [](const Truth& t) { return t.touching; });
    std::printf("%d random pairs of %s, %zu triangles each; %td touch\n", pairs, solid.name.c_str(),
                solid.mesh.triangles.size(), touching);
    const Seconds seconds = measure(meetings, depth + 1, solid, model);
    LevelQuery query;
    print_levels(query, meetings, truth, report, seconds);
}

}  // namespace bench
