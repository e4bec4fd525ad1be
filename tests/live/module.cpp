#include "lodlab/live/module.hpp"

#include <cmath>
#include <string>

#include "lodlab/live/picture.hpp"
#include "lodlab/live/sources.hpp"
#include "lodlab/viz/figure/json.hpp"
#include "tests/catch.hpp"
#include "tests/live/sample.hpp"

TEST_CASE("the calls of C do what the stage does") {
    const std::string text = live::scene_text(sample::live_scene());
    live::Stage stage(live::scene_from(text));
    lodlab_live* opened = lodlab_live_open(text.c_str());
    REQUIRE(opened != nullptr);
    const auto same = [&] {
        CHECK(lodlab_live_state(opened) == live::report(stage));
        CHECK(lodlab_live_figure(opened) ==
              viz::json_text(live::picture(stage), viz::Spacing::none));
    };
    same();
    CHECK(lodlab_live_step(opened, 70) == 0);
    stage.step(70);
    same();
    CHECK(lodlab_live_place(opened, 1, 0.25, 0.125, 0.5) == 0);
    CHECK(lodlab_live_move(opened, 0, 0.5, 0.25, 1) == 0);
    CHECK(lodlab_live_set(opened, "level", 2) == 0);
    CHECK(lodlab_live_set(opened, "budget", 30) == 0);
    CHECK(lodlab_live_set(opened, "restitution", 0.25) == 0);
    CHECK(lodlab_live_choose(opened, "policy", "perceptual") == 0);
    CHECK(lodlab_live_choose(opened, "contact_model", "centre_line") == 0);
    CHECK(lodlab_live_choose(opened, "response", "mean") == 0);
    CHECK(lodlab_live_fixate(opened, 0.5, 0.5) == 0);
    stage.place(1, {0.25, 0.125}, 0.5);
    stage.move(0, {0.5, 0.25}, 1);
    stage.set_level(2);
    stage.set_budget(30);
    stage.set_restitution(0.25);
    stage.set_policy(lod::Priority::perceptual);
    stage.set_contact_model(lod::ContactModel::centre_line);
    stage.set_response(lod::Response::mean);
    stage.set_fixation({0.5, 0.5});
    same();
    CHECK(lodlab_live_events(opened) == live::events_report(stage));
    CHECK(lodlab_live_set(opened, "event", 1) == 0);
    stage.look_inside(1);
    same();
    CHECK(lodlab_live_set(opened, "event", -1) == 0);
    stage.look_inside({});
    same();
    CHECK(lodlab_live_set(opened, "budget", -1) == 0);
    stage.set_budget({});
    CHECK(lodlab_live_reset(opened) == 0);
    stage.reset();
    same();
    lodlab_live_close(opened);
}

TEST_CASE("the module says of which sources it was made") {
    const std::string sources = lodlab_live_sources();
    CHECK(sources.size() == 64);
    CHECK(sources.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(sources == live::sources());
}

TEST_CASE("a call of C that is refused says why and changes nothing") {
    CHECK(lodlab_live_open("{}") == nullptr);
    CHECK(std::string(lodlab_live_error()).find("no scene") != std::string::npos);
    lodlab_live* opened = lodlab_live_open(live::scene_text(sample::live_scene()).c_str());
    REQUIRE(opened != nullptr);
    CHECK(std::string(lodlab_live_error()).empty());
    const std::string before = lodlab_live_state(opened);
    const auto refused = [&](int code) {
        CHECK(code == -1);
        CHECK_FALSE(std::string(lodlab_live_error()).empty());
        CHECK(lodlab_live_state(opened) == before);
    };
    refused(lodlab_live_place(opened, -1, 0, 0, 0));
    refused(lodlab_live_place(opened, 7, 0, 0, 0));
    refused(lodlab_live_set(opened, "level", 1.5));
    refused(lodlab_live_set(opened, "budget", std::nan("")));
    refused(lodlab_live_set(opened, "colour", 1));
    refused(lodlab_live_set(opened, "event", 1e9));
    refused(lodlab_live_choose(opened, "policy", "loudest"));
    refused(lodlab_live_choose(opened, "colour", "red"));
    refused(lodlab_live_step(opened, -3));
    lodlab_live_close(opened);
}
