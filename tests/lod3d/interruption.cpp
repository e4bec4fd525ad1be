// Detection interrupted after every test, in space: solids with and without cavities and in several
// parts, and as the oracle FCL's triangle test. FCL knows surfaces only. Here a solid is what its
// surface encloses: a body wholly inside another's material touches no surface and collides all the
// same; one that floats in another's cavity does not.
#include "tests/interruption.hpp"

#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/lod3d/fcl_oracle.hpp"

using namespace lod;
using lod3d::Mesh;
using lod3d::Point;

namespace {

Mesh made(const char* spec) {
    return lod::make_from_spec(lod3d::generators(), spec);
}

Mesh joined(Mesh mesh, const Mesh& other, const Point& by, double scale) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Point& p : other.vertices) mesh.vertices.push_back(scale * p + by);
    for (const lod3d::Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return mesh;
}

/// A box with a box-shaped cavity.
Mesh hollow(double scale) {
    Mesh inner = made("box");
    lod3d::flip(inner);
    return joined(made("box"), inner, Point::Zero(), scale);
}

class Solids {
  public:
    void add(const lod3d::Solid& solid, const lod3d::TreeSettings& settings) {
        Body<3> body;
        set_mass<3>(body, solid.volume, solid.second_moment);
        body.tree = std::make_shared<SphereTree<3>>(lod3d::build_tree(solid, settings));
        models.push_back({solid.name, body});
        solids_.push_back({solid.mesh, lodtest::fcl_model(solid.mesh), {}});
        const lod3d::Parts parts = lod3d::find_parts(solid.mesh);
        std::vector<bool> seen(static_cast<std::size_t>(parts.count), false);
        for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t)
            if (const auto part = static_cast<std::size_t>(parts.of_triangle[t]); !seen[part]) {
                seen[part] = true;
                solids_.back().witnesses.push_back(solid.mesh.corner(t, 0));
            }
    }

    [[nodiscard]] bool surfaces_meet(std::size_t i, const Body<3>& a, std::size_t j,
                                     const Body<3>& b) const {
        const auto pose = [](const Body<3>& body) {
            return lodtest::fcl_pose(Space<3>::rotation(body.orientation), body.position);
        };
        return lodtest::fcl_collide(solids_[i].model, pose(a), solids_[j].model, pose(b));
    }
    /// Whether a part of b's surface lies inside a. Requires: the surfaces do not meet.
    [[nodiscard]] bool holds(std::size_t i, const Body<3>& a, std::size_t j,
                             const Body<3>& b) const {
        const lod::Matrix<3> to_a = Space<3>::rotation(a.orientation).transpose();
        const lod::Matrix<3> from_b = Space<3>::rotation(b.orientation);
        return std::ranges::any_of(solids_[j].witnesses, [&](const Point& p) {
            return lodtest::ray_inside(solids_[i].mesh,
                                       to_a * (from_b * p + b.position - a.position));
        });
    }
    [[nodiscard]] lodtest::Touching<3> touching() const {
        return [this](std::size_t i, const Body<3>& a, std::size_t j, const Body<3>& b) {
            return surfaces_meet(i, a, j, b) || holds(i, a, j, b) || holds(j, b, i, a);
        };
    }

    std::vector<lodtest::Model<3>> models;

  private:
    struct Truth {
        Mesh mesh;
        std::shared_ptr<lodtest::FclModel> model;
        std::vector<Point> witnesses;  ///< one of each part of the surface
    };
    std::vector<Truth> solids_;
};

lod3d::TreeSettings octree(int depth) {
    return {.builder = lod3d::Builder::octree, .depth = depth};
}

lod3d::TreeSettings cover(int depth) {
    return {.builder = lod3d::Builder::cover, .branching = 4, .depth = depth, .effort = 0.05};
}

/// Convex and not, with holes, a cavity, two parts; large beside small, so that some contain
/// others.
Solids every_kind(const lod3d::TreeSettings& settings) {
    Solids solids;
    for (const char* spec : {"box", "rod", "tetrahedron", "L", "cross", "ring:0.12,24",
                             "gear:5,0.25,0.4", "box:2,1.5,1.8", "box:0.2,0.2,0.2"})
        solids.add(lod3d::generate(spec), settings);
    solids.add(lod3d::make_solid("hollow box", hollow(0.8)), settings);
    solids.add(lod3d::make_solid("two boxes", joined(made("box:0.3,0.3,0.3"), made("box"),
                                                     Point(0.6, 0.1, 0), 0.4)),
               settings);
    return solids;
}

}  // namespace

TEST_CASE("pairs in space interrupted after every test stand at their last finished level",
          "[interruption]") {
    for (const auto& settings : {octree(2), cover(2)}) {
        const Solids solids = every_kind(settings);
        const auto count =
            lodtest::check_pairs<3>(solids.models, solids.touching(), 90, 300, 0.9, 250);
        // All kinds of pairs were met.
        CHECK(count.touching > 25);
        CHECK(count.apart > 25);
        CHECK(count.refuted_late > 5);
    }
}

TEST_CASE("deep trees in space stand at their last finished level", "[interruption]") {
    const Solids solids = every_kind(octree(3));
    const auto count = lodtest::check_pairs<3>(solids.models, solids.touching(), 40, 7000, 0.9, 60);
    CHECK(count.touching > 10);
    CHECK(count.apart > 5);
}

TEST_CASE("a body wholly inside another collides, and one in its cavity does not",
          "[interruption]") {
    Solids solids;
    solids.add(lod3d::make_solid("hollow box", hollow(0.8)), octree(4));
    solids.add(lod3d::generate("box:3,3,3"), octree(2));
    solids.add(lod3d::generate("box:0.1,0.12,0.14"), octree(2));
    lodtest::Random random(9);
    lodtest::Count count;
    FrameStorage<3> storage;
    const auto meeting = [&](std::size_t i, std::size_t j, double reach) {
        lodtest::Meeting<3> pair;
        pair.bodies = {lodtest::placed<3>(random, solids.models[i].body, 1),
                       lodtest::placed<3>(random, solids.models[j].body, reach)};
        pair.bodies[1].position += pair.bodies[0].position;
        REQUIRE_FALSE(solids.surfaces_meet(i, pair.bodies[0], j, pair.bodies[1]));
        pair.touching = solids.touching()(i, pair.bodies[0], j, pair.bodies[1]);
        return pair;
    };
    for (int trial = 0; trial < 10; ++trial) {
        const auto inside = meeting(1, 2, 0.7);  // any way it is turned, clear of the surface
        CHECK(inside.touching);
        check_interruptions(inside, storage, count, 100);
        const auto both = meeting(1, 0, 0.3);  // a hollow body inside a full one
        CHECK(both.touching);
        check_interruptions(both, storage, count, 100);
        const auto floating = meeting(0, 2, 0.05);
        CHECK_FALSE(floating.touching);
        check_interruptions(floating, storage, count, 100);
    }
    CHECK(count.refuted_late == 10);  // the cavity is seen by a tree that is fine enough
}
