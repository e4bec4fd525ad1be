#include "lodlab/live/outline.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/live/stage.hpp"
#include "tests/catch.hpp"

namespace {

const viz::Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

live::Scene scene_of(const viz::Ring& ring) {
    return live::scene_of({{"A", ring}}, 2);
}

}  // namespace

TEST_CASE("a drawn outline becomes a body of 1 m with its exact mass") {
    for (const bool turned : {false, true}) {
        viz::Ring ring = square;
        if (turned) std::reverse(ring.begin(), ring.end());
        const live::Scene scene = scene_of(ring);
        REQUIRE(scene.actors.size() == 1);
        const lod::Body<2>& body = scene.actors[0].body;
        CHECK(1 / body.inverse_mass == Approx(1));
        CHECK(body.inertia[0] == Approx(1.0 / 6));
        CHECK(body.tree->levels() <= 3);
        CHECK(body.position == lod::Vector<2>::Zero());
    }
}

TEST_CASE("two drawn outlines approach each other and collide") {
    live::Stage stage(live::scene_of({{"A", square}, {"B", square}}, 3));
    CHECK(stage.pairs().empty());
    stage.step(600);
    CHECK(stage.bodies()[0].velocity.x() < 0.6);
    CHECK(lod::kinetic_energy<2>(stage.bodies()) == Approx(0.36));
}

TEST_CASE("an outline that bounds no body is refused, and says what to draw") {
    const auto refused = [](const viz::Ring& ring, const char* words) {
        CHECK_THROWS_WITH(static_cast<void>(scene_of(ring)), Catch::Contains(words));
    };
    refused({}, "fewer than three corners");
    refused({{0, 0}, {1, 0}, {1, 0}, {0, 0}}, "fewer than three corners");
    refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "crosses or touches itself");
    refused({{0, 0}, {1, 0}, {2, 0}}, "crosses or touches itself");
    refused({{0, 0}, {4, 0}, {2, 0}, {2, 2}}, "crosses or touches itself");
    refused({{0, 0}, {1, 0}, {std::nan(""), 1}}, "no place");
    refused(viz::Ring(401, {1, 1}), "fewer than three corners");
    viz::Ring many;
    for (int i = 0; i < 401; ++i) many.push_back({1.0 * i, 1.0 * i * i});
    refused(many, "more than 400 corners");
    CHECK_THROWS_AS(static_cast<void>(live::scene_of({{"A", square}}, 7)), lod::Error);
    CHECK_THROWS_AS(static_cast<void>(live::scene_of({}, 2)), lod::Error);
    CHECK_THROWS_AS(static_cast<void>(live::scene_of_outlines("{")), lod::Error);
}
