// A gas of gears in a closed box, elastic, with the net response: kinetic energy is kept, and
// momentum changes by what the walls take, at every level of the trees. Frame after frame the
// bodies meet in every way that a simulation knows: overlapping, hooked into each other, in crowds.

#include <cmath>
#include <cstdio>

#include "lodlab/core/base/random.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace lod;

namespace {

std::shared_ptr<const SphereTree<2>> tree_of(const lod2d::Shape& shape) {
    return std::make_shared<SphereTree<2>>(lod2d::build_tree(shape));
}

/// Gears of 1 m across in a box, whose walls are blocks of 2 m: even their root
/// circles close it.
std::vector<Body<2>> gas_of(int columns, int rows) {
    constexpr double cell = 1.4;
    std::vector<Body<2>> bodies;
    const lod2d::Shape gear = lod2d::generate("gear:9");
    const auto gear_tree = tree_of(gear);
    lod::Random random(2020);
    for (int i = 0; i < columns * rows; ++i) {
        Body<2> body;
        set_mass<2>(body, gear.area, Inertia<2>::Constant(gear.second_moment));
        body.tree = gear_tree;
        body.position = cell * Vector<2>(i % columns + 0.5, i / columns + 0.5);
        body.orientation = random.next(-3, 3);
        body.velocity = {random.next(-3, 3), random.next(-3, 3)};
        body.spin[0] = random.next(-3, 3);
        bodies.push_back(body);
    }
    const auto block = tree_of(lod2d::generate("box:2,2"));
    const double width = cell * columns;
    const double height = cell * rows;
    const auto add_wall = [&](double x, double y) {
        Body<2> wall;
        make_static(wall);
        wall.tree = block;
        wall.position = {x, y};
        bodies.push_back(wall);
    };
    for (double x = 0; x < width + 2; x += 2)
        for (const double y : {-1.5, height + 1.5}) add_wall(x, y);
    for (double y = 0; y < height + 2; y += 2)
        for (const double x : {-1.5, width + 1.5}) add_wall(x, y);
    return bodies;
}

/// How far a run strayed from what must be kept, as shares of what is there.
struct Drift {
    double energy = 0;
    double momentum = 0;
    std::uint64_t impacts = 0;
    int rounds = 0;  ///< the most that an island took
};

Drift drift_of(std::vector<Body<2>> bodies, int level, int frames) {
    const std::span<const Body<2>> seen(bodies);
    const double energy = kinetic_energy(seen);
    Vector<2> expected = momentum(seen);
    double exchanged = 0;
    for (const Body<2>& body : bodies)
        if (!body.is_static()) exchanged += body.velocity.norm() / body.inverse_mass;
    FrameSettings settings;
    settings.deepest_level = level;
    FrameStorage<2> storage;
    Drift drift;
    for (int frame = 0; frame < frames; ++frame) {
        Budget budget = Budget::unlimited();
        const auto& record = advance<2>(bodies, settings, budget, storage);
        for (std::size_t k = 0; k < record.impacts.size(); ++k) {
            const Impact<2>& impact = record.impacts[k];
            const Vector<2> push = record.impulses[k] * impact.contact.normal;
            if (bodies[static_cast<std::size_t>(impact.a)].is_static()) expected += push;
            if (bodies[static_cast<std::size_t>(impact.b)].is_static()) expected -= push;
        }
        drift.impacts += record.impacts.size();
        drift.rounds = std::max(drift.rounds, storage.record.response.most_visits);
        drift.energy = std::max(drift.energy, std::abs(kinetic_energy(seen) / energy - 1));
        drift.momentum = std::max(drift.momentum, (momentum(seen) - expected).norm() / exchanged);
    }
    return drift;
}

void check_gas(int columns, int rows, int frames, bool print) {
    const std::vector<Body<2>> bodies = gas_of(columns, rows);
    for (int level = 0; level < bodies[0].tree->levels(); ++level) {
        const Drift drift = drift_of(bodies, level, frames);
        if (print)
            std::printf(
                "level %d: %llu contacts, net rounds up to %d, energy within %.1e, momentum within "
                "%.1e\n",
                level, static_cast<unsigned long long>(drift.impacts), drift.rounds, drift.energy,
                drift.momentum);
        CHECK(drift.impacts > 50);  // one or two a touching pair
        CHECK(drift.energy <= 1e-9);
        CHECK(drift.momentum <= 1e-9);
    }
}

}  // namespace

TEST_CASE("a gas of gears keeps its energy, and the walls take its momentum", "[gas]") {
    check_gas(4, 4, 200, false);
}

TEST_CASE("the response of each of 10,000 frames stays below its reserve, by count", "[gas]") {
    // Kept in a box that is too small for them, at the allowances that a frame may have.
    std::vector<Body<2>> bodies = gas_of(3, 3);
    FrameStorage<2> storage;
    std::uint64_t contacts = 0;
    int cut = 0;
    const int frames = lodtest::sanitized ? 1'000 : 10'000;
    for (int frame = 0; frame < frames; ++frame) {
        Budget budget = frame % 4 == 0 ? Budget::unlimited()
                                       : Budget::node_tests(100U << frame % 8, frame % 3 * 20.0);
        const auto& record = advance<2>(bodies, {}, budget, storage);
        REQUIRE(record.response.row_visits <= record.reserved_row_visits);
        contacts += record.impacts.size();
        cut += record.interrupted() ? 1 : 0;
    }
    CHECK(contacts > static_cast<std::uint64_t>(frames / 2));
    CHECK(cut > frames / 10);
}

// Some minutes: test_exact "[long]".
TEST_CASE("200 gears keep their energy over 10,000 frames at every level", "[.][long]") {
    check_gas(20, 10, 10'000, true);
}
