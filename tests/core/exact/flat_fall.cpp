// A box that falls flat on a floor must leave without spin (METHOD.md, "many contacts for one
// collision"), at every level of every builder's trees. Where trees are symmetric, only rounding
// may turn it; where a builder makes them lopsided, the box turns, and the tests say how much.

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/solid/surface.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// The half mirrored at the plane x = 0 lies within this of the other half [m].
template <int Dim>
double lopsidedness(const SphereTree<Dim>& tree, int level) {
    double worst = 0;
    const std::vector<int> nodes = tree.level_nodes(level);
    for (int i : nodes) {
        double best = std::numeric_limits<double>::infinity();
        for (int j : nodes) {
            Vector<Dim> mirrored = tree.sphere(j).centre;
            mirrored[0] = -mirrored[0];
            best = std::min(best, (tree.sphere(i).centre - mirrored).norm() +
                                      std::abs(tree.sphere(i).radius - tree.sphere(j).radius));
        }
        worst = std::max(worst, best);
    }
    return worst;
}

template <int Dim>
struct Fall {
    Body<Dim> floor;
    Body<Dim> box;

    /// Spin times the box's half width after a flat fall at 1 m/s [m/s]. If all of the energy went
    /// into spin, 1.22.
    [[nodiscard]] double edge_speed(int level, ContactModel model, Finest finest) const {
        std::vector<Body<Dim>> bodies{floor, box};
        FrameSettings settings;
        settings.time_step = 1.0 / 120;
        settings.deepest_level = level;
        settings.contact_model = model;
        settings.finest.level = finest;
        FrameStorage<Dim> storage;
        for (int frame = 0; frame < 2000 && bodies[1].velocity[1] < 0; ++frame) {
            Budget budget = Budget::unlimited();
            advance<Dim>(bodies, settings, budget, storage);
        }
        CHECK(bodies[1].velocity[1] >= 0);
        return bodies[1].spin.norm() * 0.5;
    }
};

/// `lopsided_spin`: the stated tolerance at levels that are not symmetric [m/s].
template <int Dim>
void check_fall(const Fall<Dim>& fall, const std::string& builder, double lopsided_spin) {
    for (const Finest finest : {Finest::exact, Finest::backtrack})
        CHECK(fall.edge_speed(1000, ContactModel::centre_line, finest) <= 1e-9);
    for (const ContactModel model : {ContactModel::centre_line, ContactModel::node_normal})
        for (int level = 0; level < fall.box.tree->levels(); ++level) {
            const double lopsided = std::max(
                lopsidedness(*fall.box.tree, level),
                lopsidedness(*fall.floor.tree, std::min(level, fall.floor.tree->levels() - 1)));
            const double spin = fall.edge_speed(level, model, Finest::leaves);
            INFO(builder << ", level " << level << ", lopsided by " << lopsided << " m");
            CHECK(spin <= (lopsided < 1e-11 ? 1e-9 : lopsided_spin));
        }
    // A box is its own hull, whatever its balls.
    for (int level = 0; level < fall.box.tree->levels(); ++level)
        CHECK(fall.edge_speed(level, ContactModel::hull, Finest::leaves) <= 1e-9);
}

Body<2> body_of(const lod2d::Shape& shape, lod2d::Builder builder) {
    Body<2> body;
    set_mass<2>(body, shape.area, Inertia<2>::Constant(shape.second_moment));
    body.exact = std::make_shared<lod2d::ExactOutline>(shape);
    lod2d::TreeSettings settings;
    settings.builder = builder;
    body.tree = std::make_shared<SphereTree<2>>(lod2d::build_tree(shape, settings));
    return body;
}

Body<3> body_of(const lod3d::Solid& solid, lod3d::Builder builder) {
    Body<3> body;
    set_mass<3>(body, solid.volume, solid.second_moment);
    body.exact = std::make_shared<lod3d::ExactSurface>(solid);
    lod3d::TreeSettings settings;
    settings.builder = builder;
    settings.depth = 2;
    settings.effort = 0.1;
    body.tree = std::make_shared<SphereTree<3>>(lod3d::build_tree(solid, settings));
    return body;
}

/// The box starts above all that stands out of the floor at any level.
template <int Dim>
Fall<Dim> fall_of(Body<Dim> floor, Body<Dim> box) {
    make_static(floor);
    floor.position[1] = -0.5;
    box.position[1] = 0.5 + 1.3 * floor.tree->radius[0];
    box.velocity[1] = -1;
    return {floor, box};
}

}  // namespace

TEST_CASE("a box that falls flat leaves without spin in the plane", "[flat]") {
    // The quadtree of a box is symmetric at every level. The pieces are until the last digits of a
    // search show at level 4. Circles of the medial axis alternate from one side to the other.
    const std::map<lod2d::Builder, double> lopsided_spin{{lod2d::Builder::quadtree, 0},
                                                         {lod2d::Builder::pieces, 1e-5},
                                                         {lod2d::Builder::medial, 0.85}};
    for (const auto& [builder, spin] : lopsided_spin) {
        const auto floor = body_of(lod2d::generate("box:6,1"), builder);
        const auto box = body_of(lod2d::generate("box"), builder);
        check_fall(fall_of(floor, box), std::string(lod::name_of(builder)), spin);
    }
    CHECK(lopsided_spin.size() == lod::choices<lod2d::Builder>().size());
}

TEST_CASE("a box that falls flat leaves without spin in space", "[flat]") {
    // The octree of the floor begins in a cube, so its level 2 is lopsided; the cover's spheres are
    // searched for from random starts.
    const std::map<lod3d::Builder, double> lopsided_spin{{lod3d::Builder::octree, 0.75},
                                                         {lod3d::Builder::cover, 1.15}};
    for (const auto& [builder, spin] : lopsided_spin) {
        const auto floor = body_of(lod3d::generate("box:2,1,2"), builder);
        const auto box = body_of(lod3d::generate("box:1,1,1"), builder);
        check_fall(fall_of(floor, box), std::string(lod::name_of(builder)), spin);
    }
    CHECK(lopsided_spin.size() == lod::choices<lod3d::Builder>().size());
}
