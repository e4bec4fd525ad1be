// Queries of two posed meshes: level by level by their sphere trees, and exactly by FCL.
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "bench/meshes.hpp"
#include "bench/timing.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/tree/traversal.hpp"
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

/// From the poses of two bodies to the verdict of a level.
class LevelQuery {
  public:
    lod::Verdict operator()(const Meeting& m, int level) {
        a_.pose(m.a);
        b_.pose(m.b);
        list_.clear();
        lod::test_roots(a_, b_, front_, list_);
        lod::Budget budget = lod::Budget::unlimited();
        while (front_.level < level && !front_.finest && front_.pairs.count > 0)
            static_cast<void>(lod::refine(a_, b_, budget, front_, list_));
        return front_.pairs.count == 0 ? lod::Verdict::apart : front_.verdict;
    }

  private:
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

/// `seconds`: of the four levels, the triangles, FCL's first hit and all its hits.
template <class Seconds>
void print_levels(LevelQuery& query, const std::vector<Meeting>& meetings,
                  const std::vector<Truth>& truth, const lod::TreeReport& report,
                  const Seconds& seconds) {
    const auto pairs = static_cast<double>(meetings.size());
    const double first_hit = seconds[5];
    const double all_hits = seconds[6];
    std::printf(
        "level | nodes | us a query | FCL, first hit / it | FCL, all hits / it | not apart | of "
        "these apart | error bound %% | largest gap %%\n");
    for (std::size_t level = 0; level < 4; ++level) {
        const Errors errors = errors_of(query, static_cast<int>(level), meetings, truth);
        const lod::LevelReport& of = report.levels[level];
        std::printf(
            "%zu | %d | %.2f | %.1f | %.1f | %d | %.1f %% | %.2f | %.2f%s\n", level, of.nodes,
            1e6 * seconds[level] / pairs, first_hit / seconds[level], all_hits / seconds[level],
            errors.met, errors.met > 0 ? 100.0 * errors.wrong / errors.met : 0.0,
            200 * of.worst_protrusion_fraction, 100 * errors.largest_gap / report.bounding_diameter,
            errors.missed > 0 ? "  MISSED A COLLISION" : "");
    }
    const auto exact_row = [&](const char* name, double of) {
        std::printf("%s | | %.2f | %.2f | %.2f\n", name, 1e6 * of / pairs, first_hit / of,
                    all_hits / of);
    };
    exact_row("triangles, lod3d, first hit", seconds[4]);
    exact_row("triangles, FCL, first hit", first_hit);
    exact_row("triangles, FCL, all hits", all_hits);
}

}  // namespace

void query_pairs(const lod3d::Solid& solid, int pairs) {
    const auto tree = std::make_shared<lod::SphereTree<3>>(lod3d::build_tree(solid));
    const lod::TreeReport report = lod3d::report_tree(solid, *tree);
    const auto meetings = random_meetings(tree, report.bounding_diameter, pairs);
    const auto model = lodtest::fcl_model(solid.mesh);
    const auto truth = find_truth(meetings, model);
    const auto touching =
        std::count_if(truth.begin(), truth.end(), [](const Truth& t) { return t.touching; });
    std::printf("%d random pairs of %s, %zu triangles each; %td touch\n", pairs, solid.name.c_str(),
                solid.mesh.triangles.size(), touching);

    const lod3d::TriangleTree triangles(solid.mesh);
    LevelQuery query;
    long checksum = 0;
    const auto by_level = [&](int level) {
        return [&, level] {
            for (const Meeting& m : meetings) checksum += static_cast<int>(query(m, level));
        };
    };
    const auto by_fcl = [&](std::size_t most_contacts) {
        return [&, most_contacts] {
            for (const Meeting& m : meetings) {
                fcl::CollisionResultd hit;
                checksum +=
                    static_cast<long>(fcl::collide(model.get(), m.fcl_a, model.get(), m.fcl_b,
                                                   fcl::CollisionRequestd(most_contacts), hit));
            }
        };
    };
    const auto exactly = [&] {
        for (const Meeting& m : meetings)
            checksum += lod3d::surfaces_intersect(triangles, m.pose_a, triangles, m.pose_b);
    };
    const auto seconds = medians(7, by_level(0), by_level(1), by_level(2), by_level(3), exactly,
                                 by_fcl(1), by_fcl(1'000'000));
    print_levels(query, meetings, truth, report, seconds);
    std::printf("(%ld)\n", checksum);  // so that no query is left out
}

}  // namespace bench
