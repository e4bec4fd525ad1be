#include <cmath>

#include "lessons/engine/lessons.hpp"
#include "lodlab/live/stage.hpp"
#include "tests/catch.hpp"

// What the live parts tell their reader to see.

using namespace lessons;

namespace {

live::Stage stage_of(const std::string& slug) {
    return live::Stage(run(find_lesson(slug).value().number).live.value().scene);
}

double speed(const live::Stage& stage, std::size_t body) {
    return stage.bodies()[body].velocity.x();
}

void run_for(live::Stage& stage, double seconds) {
    while (stage.time() < seconds) stage.step();
}

}  // namespace

TEST_CASE("a row of two: under net C leaves alone, under LCP two leave and A comes back",
          "[lessons]") {
    live::Stage net = stage_of("beside_box2d");
    live::Stage lcp = net;
    net.set_response(lod::Response::net);
    lcp.set_response(lod::Response::lcp);
    run_for(net, 1.5);
    run_for(lcp, 1.5);
    CHECK(speed(net, 0) == Approx(0).margin(1e-9));
    CHECK(speed(net, 1) == Approx(0).margin(1e-9));
    CHECK(speed(net, 2) == Approx(1));
    CHECK(speed(lcp, 0) < -0.1);
    CHECK(speed(lcp, 1) == Approx(speed(lcp, 2)));
    CHECK(speed(lcp, 2) > 0.1);
}

TEST_CASE("a row with a gap: net and LCP agree", "[lessons]") {
    live::Stage net = stage_of("beside_box2d");
    const lod::Body<2>& c = net.bodies()[2];
    net.place(2, c.position + lod::Vector<2>{0.1, 0}, c.orientation);
    live::Stage lcp = net;
    net.set_response(lod::Response::net);
    lcp.set_response(lod::Response::lcp);
    run_for(net, 1.5);
    run_for(lcp, 1.5);
    for (std::size_t body = 0; body < 3; ++body)
        CHECK(speed(net, body) == Approx(speed(lcp, body)).margin(1e-9));
    CHECK(speed(net, 2) == Approx(1));
}

TEST_CASE("two stars that miss each other are pushed at level 1 and pass at the leaves",
          "[lessons]") {
    live::Stage coarse = stage_of("too_early");
    live::Stage fine = coarse;
    const lod::Vector<2> before = coarse.bodies()[0].velocity;
    coarse.set_level(1);
    fine.set_level(100);
    run_for(coarse, 3);
    run_for(fine, 3);
    CHECK((coarse.bodies()[0].velocity - before).norm() > 0.1);
    CHECK(fine.bodies()[0].velocity == before);
}

TEST_CASE("one ball strikes two: only the sum makes energy, only one after the other is unfair",
          "[lessons]") {
    const live::Stage start = stage_of("many_contacts");
    const double before = lod::kinetic_energy<2>(start.bodies());
    const auto after = [&](lod::Response response) {
        live::Stage stage = start;
        stage.set_response(response);
        run_for(stage, 1.5);
        return stage;
    };
    const auto energy = [&](const live::Stage& stage) {
        return lod::kinetic_energy<2>(stage.bodies()) / before;
    };
    CHECK(energy(after(lod::Response::sum)) > 1.5);
    for (const lod::Response response :
         {lod::Response::net, lod::Response::sequential, lod::Response::lcp})
        CHECK(energy(after(response)) == Approx(1).epsilon(1e-9));
    for (const lod::Response response :
         {lod::Response::net, lod::Response::sum, lod::Response::lcp}) {
        const live::Stage stage = after(response);
        CHECK(speed(stage, 1) == Approx(speed(stage, 2)).epsilon(1e-9));
    }
    const live::Stage ordered = after(lod::Response::sequential);
    CHECK(std::abs(speed(ordered, 1) - speed(ordered, 2)) > 0.1);
}

TEST_CASE("the ball in the cover's hole is called apart, beside another circle it is not",
          "[lessons]") {
    const live::Scene scene = run(find_lesson("cover").value().number).live.value().scene;
    const lod::Body<2>& plank = scene.actors[0].body;
    lod::Body<2> ball = scene.actors[1].body;
    const auto meets = [&] { return !lod::traverse_levels<2>(plank, ball).back().pairs.empty(); };
    CHECK_FALSE(meets());
    ball.position.y() *= -1;  // the hole at the lower edge
    CHECK_FALSE(meets());
    for (const double x : {-1.8, -0.8, 1.2}) {
        ball.position.x() = x;
        CHECK(meets());
    }
}
