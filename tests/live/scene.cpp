#include "lodlab/live/scene.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/live/stage.hpp"
#include "lodlab/live/take.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/run.hpp"
#include "tests/catch.hpp"
#include "tests/live/sample.hpp"

namespace {

scenes::Setup<2> set_up(const std::string& name, int depth) {
    scenes::Scene scene = scenes::load_scene(scenes::scene_file(name));
    for (scenes::BodySpec& body : scene.bodies) body.depth = depth;
    return scenes::set_up<2>(scene);
}

}  // namespace

TEST_CASE("a live scene is written and read again to the same bits") {
    live::Scene scene = sample::live_scene();
    scene.budget = 120;
    scene.pair_cost = 2.5;
    scene.told = live::Told::verdicts;
    scene.settings.viewer.fixation = {0.1, -0.2, 0};
    scene.actors.push_back({{"floor", {{{-9, -9}, {9, -9}, {9, 0}, {-9, 0}}}}, {}});
    scene.actors.back().body.tree =
        std::make_shared<const lod::SphereTree<2>>(lod::half_space<2>({0, 1}));
    lod::make_static(scene.actors.back().body);
    const std::string text = live::scene_text(scene);
    const live::Scene again = live::scene_from(text);
    CHECK(live::scene_text(again) == text);
    CHECK(again.budget == scene.budget);
    CHECK(again.pair_cost == scene.pair_cost);
    CHECK(again.told == scene.told);
    CHECK(again.settings.viewer.fixation == scene.settings.viewer.fixation);
    REQUIRE(again.actors.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(lod::tree_hash(*again.actors[i].body.tree) ==
              lod::tree_hash(*scene.actors[i].body.tree));
        CHECK(again.actors[i].visual.outline == scene.actors[i].visual.outline);
    }
    CHECK(again.actors[2].body.tree->is_half_space());
}

TEST_CASE("bodies of one shape share its tree in a live scene") {
    live::Scene scene = sample::live_scene();
    scene.actors.push_back(scene.actors[0]);
    const live::Scene again = live::scene_from(live::scene_text(scene));
    CHECK(again.actors[0].body.tree == again.actors[2].body.tree);
    CHECK(again.actors[0].body.tree != again.actors[1].body.tree);
}

TEST_CASE("a stage steps a scene of a file to the bits of its run") {
    for (const char* name : {"gears_in_a_box", "box_falls_flat"}) {
        const scenes::Setup<2> setup = set_up(name, 2);
        scenes::RunOptions options;
        options.settings = scenes::frame_settings(setup.scene, setup.scene.limits);
        options.frames = 150;
        options.limits = setup.scene.limits;
        const std::uint64_t wanted = scenes::run<2>(setup.bodies, options).state_hash;
        live::Stage stage(live::scene_from(live::scene_text(live::scene_of(setup))));
        stage.step(150);
        CHECK(stage.state_hash() == wanted);
    }
}

TEST_CASE("a live scene shows what its camera sees, else all that moves") {
    const live::Scene seen = live::scene_of(set_up("gears_in_a_box", 1));
    CHECK(seen.view.high.x - seen.view.low.x == Approx(7.6));
    const scenes::Setup<2> setup = set_up("offset_boxes", 1);
    const live::Scene framed = live::scene_of(setup);
    for (const lod::Body<2>& body : setup.bodies) {
        CHECK(body.position.x() > framed.view.low.x);
        CHECK(body.position.x() < framed.view.high.x);
    }
}

TEST_CASE("more bodies than a page follows are refused for a live scene") {
    const scenes::Setup<2> setup = scenes::set_up<2>(scenes::named_scene("gas:101"));
    CHECK_THROWS_WITH(
        static_cast<void>(live::scene_of(setup)),
        Catch::Contains("at most 100 bodies") && Catch::Contains("take a smaller one"));
}

TEST_CASE("a text that is no live scene is refused in one line") {
    const std::string good = live::scene_text(sample::live_scene());
    const auto refused = [](std::string text) {
        CHECK_THROWS_AS(static_cast<void>(live::scene_from(text)), lod::Error);
        try {
            static_cast<void>(live::scene_from(text));
        } catch (const lod::Error& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            CHECK(error.kind() == lod::ErrorKind::input_refused);
        }
    };
    refused("");
    refused("[]");
    refused(good.substr(0, good.size() / 2));
    for (const auto& [from, to] :
         {std::pair{"\"version\":1", "\"version\":2"}, std::pair{"\"shape\":1", "\"shape\":7"},
          std::pair{"\"restitution\":1.0", "\"restitution\":2.0"},
          std::pair{"\"view\":[-2.0", "\"view\":[3.0"}}) {
        std::string text = good;
        REQUIRE(text.find(from) != std::string::npos);
        refused(text.replace(text.find(from), std::string(from).size(), to));
    }
}
