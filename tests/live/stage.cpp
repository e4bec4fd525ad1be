#include "lodlab/live/stage.hpp"

#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/live/picture.hpp"
#include "lodlab/viz/figure/json.hpp"
#include "tests/catch.hpp"
#include "tests/live/sample.hpp"

namespace {

using Json = nlohmann::json;

Json report_of(const live::Stage& stage) {
    return Json::parse(live::report(stage));
}

int count_role(const viz::Figure& figure, viz::Role role) {
    int count = 0;
    for (const viz::Mark& mark : figure.panels[0].marks)
        std::visit([&](const auto& held) { count += held.style.role == role ? 1 : 0; },
                   static_cast<const viz::AnyMark&>(mark));
    return count;
}

/// The two bodies overlap by far.
live::Stage meeting() {
    return live::Stage(sample::live_scene(0.7));
}

}  // namespace

TEST_CASE("looking at a stage moves nothing, and a step moves what moves") {
    live::Stage stage(sample::live_scene());
    const std::uint64_t start = stage.state_hash();
    static_cast<void>(live::picture(stage));
    static_cast<void>(live::report(stage));
    CHECK(stage.state_hash() == start);
    stage.step(10);
    CHECK(stage.frame() == 10);
    CHECK(stage.time() == Approx(10.0 / 240));
    CHECK(stage.bodies()[0].position.x() == Approx(-0.6 + 10.0 / 240));
    stage.reset();
    CHECK(stage.state_hash() == start);
    CHECK(stage.frame() == 0);
}

TEST_CASE("single steps and one of many give the same state") {
    live::Stage one(sample::live_scene());
    live::Stage many(sample::live_scene());
    for (int i = 0; i < 120; ++i) one.step();
    many.step(120);
    CHECK(one.state_hash() == many.state_hash());
    CHECK(live::report(one) == live::report(many));
}

TEST_CASE("a body that is dragged stands where it was put, and the picture follows") {
    live::Stage stage(sample::live_scene());
    const std::string before = viz::json_text(live::picture(stage));
    stage.place(0, {0.25, 0.5}, 1);
    CHECK(stage.bodies()[0].position == lod::Vector<2>(0.25, 0.5));
    CHECK(stage.bodies()[0].orientation == 1);
    CHECK(viz::json_text(live::picture(stage)) != before);
    stage.place(0, {-50, 0}, 1);
    CHECK(stage.pairs().empty());
    CHECK(live::picture(stage).caption == "No two bodies are near: nothing is tested.");
}

TEST_CASE("no frame tests deeper than the level that was set") {
    live::Stage stage = meeting();
    std::uint64_t last = 0;
    for (int level = 0; level <= 3; ++level) {
        stage.set_level(level);
        REQUIRE(stage.pairs().size() == 1);
        CHECK(stage.pairs()[0].record.level == level);
        CHECK(stage.pairs()[0].fronts.size() == static_cast<std::size_t>(level) + 1);
        CHECK(stage.record().tests > last);
        last = stage.record().tests;
    }
}

TEST_CASE("the tests of the levels and those thrown away are all tests") {
    live::Stage stage = meeting();
    stage.set_level(1000);
    const auto all = static_cast<int>(stage.record().tests);
    for (int budget = 0; budget <= all + 1; ++budget) {
        stage.set_budget(static_cast<std::uint64_t>(budget));
        const Json report = report_of(stage);
        int sum = report["dropped"].get<int>();
        for (const Json& tests : report["by_level"]) sum += tests.get<int>();
        CHECK(sum == report["tests"].get<int>());
        CHECK(report["interrupted"].get<bool>() == (budget < all));
        if (budget > 1) CHECK(report["tests"].get<int>() <= budget);
    }
}

TEST_CASE("node pairs reserve their cost of a budget") {
    live::Stage stage = meeting();
    stage.set_budget(200);
    stage.set_pair_cost(3);
    const Json report = report_of(stage);
    CHECK(report["reserved"].get<double>() > 0);
    CHECK(report["reserved"].get<double>() + report["tests"].get<double>() <= 200);
}

TEST_CASE("the gap that a stage tells is that of the true shapes") {
    live::Stage stage(sample::live_scene());
    stage.set_level(0);
    bool seen = false;
    for (int i = 0; i < 60; ++i, stage.step()) {
        for (const live::NearPair& near : stage.pairs()) {
            if (near.record.verdict == lod::Verdict::apart) continue;
            seen = true;
            const auto bodies = stage.bodies();
            const double wanted = lod::exactly_overlap<2>(bodies[0], bodies[1])
                                      ? 0
                                      : lod::separation<2>(bodies[0], bodies[1]).distance;
            CHECK(near.gap == wanted);
        }
    }
    CHECK(seen);
}

TEST_CASE("equation (1) is told of the deepest contact, from the bodies as they stand") {
    live::Stage stage = meeting();
    stage.set_restitution(0.5);
    const Json contact = report_of(stage)["contact"];
    REQUIRE_FALSE(contact.is_null());
    const lod::Vector<2> normal(contact["normal"][0], contact["normal"][1]);
    const lod::Contact<2>* deepest = nullptr;
    for (const lod::Impact<2>& impact : stage.record().impacts)
        if (!deepest || impact.contact.depth > deepest->depth) deepest = &impact.contact;
    CHECK(normal == deepest->normal);
    const auto bodies = stage.bodies();
    const auto speed_at = [&](const lod::Body<2>& body) {
        const lod::Vector<2> r = deepest->point - body.position;
        return body.velocity + body.spin[0] * lod::Vector<2>(-r.y(), r.x());
    };
    const double closing = (speed_at(bodies[1]) - speed_at(bodies[0])).dot(normal);
    CHECK(contact["closing"].get<double>() == Approx(closing));
    CHECK(contact["e"].get<double>() == 0.5);
    REQUIRE(closing < 0);
    CHECK(contact["j"].get<double>() == Approx(-1.5 * closing / contact["K"].get<double>()));
    stage.place(0, {-50, 0}, 0);
    CHECK(report_of(stage)["contact"].is_null());
}

TEST_CASE("verdicts alone are told of circles and proofs, and no contact is drawn") {
    live::Scene scene = sample::live_scene(0.7);
    scene.told = live::Told::verdicts;
    live::Stage stage(scene);
    CHECK(count_role(live::picture(live::Stage(sample::live_scene(0.7))), viz::Role::contact) > 0);
    CHECK(count_role(live::picture(stage), viz::Role::contact) == 0);
    CHECK(count_role(live::picture(stage), viz::Role::velocity) == 0);
    CHECK(live::picture(stage).caption.find("contact") == std::string::npos);
    stage.set_level(0);
    CHECK(live::picture(stage).caption == "The circles meet; the shapes do overlap.");
    stage.place(0, {-1.3, 0.2}, 0.3);
    CHECK(live::picture(stage).caption.starts_with("The circles are apart, and so are "));
    stage.place(0, {-50, 0}, 0);
    CHECK(count_role(live::picture(stage), viz::Role::level_node) == 2);  // the roots, untested
    CHECK(live::picture(stage).caption.starts_with("The circles are apart, and so are "));
}

TEST_CASE("inside a frame levels come first, then contacts, then impulses, and no body moves") {
    live::Stage stage = meeting();
    const std::uint64_t start = stage.state_hash();
    const std::string report = live::report(stage);
    const std::string picture = viz::json_text(live::picture(stage));
    const std::vector<scenes::Event<2>> events = stage.apart().events;
    REQUIRE(events.size() > 4);
    std::size_t impulses = 0;
    std::size_t contacts = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
        stage.look_inside(i);
        CHECK(stage.state_hash() == start);
        CHECK(report_of(stage)["event"] == i);
        const viz::Figure figure = live::picture(stage);
        contacts += events[i].kind == scenes::EventKind::contact ? 1 : 0;
        impulses += events[i].kind == scenes::EventKind::impulse ? 1 : 0;
        CHECK(count_role(figure, viz::Role::contact) == static_cast<int>(contacts));
        CHECK(count_role(figure, viz::Role::normal) ==
              (events[i].kind == scenes::EventKind::contact ? 1 : 0));
        if (events[i].kind != scenes::EventKind::round)
            CHECK(count_role(figure, viz::Role::impulse) == static_cast<int>(impulses));
        CHECK(figure.caption.starts_with("Event " + std::to_string(i + 1) + " of " +
                                         std::to_string(events.size()) + ": "));
    }
    CHECK(contacts == stage.record().impacts.size());
    CHECK(impulses > 0);
    stage.look_inside({});
    CHECK(live::report(stage) == report);
    CHECK(viz::json_text(live::picture(stage)) == picture);
    // The impulses are those of the next frame.
    stage.step();
    REQUIRE(stage.hits().size() == impulses);
    std::size_t hit = 0;
    for (const scenes::Event<2>& event : events)
        if (event.kind == scenes::EventKind::impulse)
            CHECK(stage.hits()[hit++].impulse == event.impulse);
}

TEST_CASE("inside a frame each level shows its own nodes and none of the later ones") {
    live::Stage stage = meeting();
    const auto bodies = stage.bodies();
    const auto fronts = lod::traverse_levels<2>(bodies[0], bodies[1]);
    for (std::size_t level = 0; level < fronts.size(); ++level) {
        stage.look_inside(level);
        CHECK(stage.inside().events[level].level == static_cast<int>(level));
        for (const viz::Mark& mark : live::picture(stage).panels[0].marks)
            std::visit(
                [&](const auto& held) {
                    const viz::Role role = held.style.role;
                    if (role == viz::Role::node || role == viz::Role::meeting_node)
                        CHECK(held.style.level <= static_cast<int>(level));
                },
                static_cast<const viz::AnyMark&>(mark));
    }
}

TEST_CASE("inside a frame the tests of a level that is thrown away are shown as such") {
    live::Stage stage = meeting();
    stage.set_pair_cost(3);
    bool seen = false;
    for (std::uint64_t budget = 1; budget < 200; ++budget) {
        stage.set_budget(budget);
        const std::vector<scenes::Event<2>> events = stage.apart().events;
        for (std::size_t i = 0; i < events.size(); ++i) {
            stage.look_inside(i);
            const bool is_dropped = events[i].kind == scenes::EventKind::dropped;
            seen |= is_dropped;
            CHECK((count_role(live::picture(stage), viz::Role::dropped_node) > 0) == is_dropped);
        }
    }
    CHECK(seen);
}

TEST_CASE("of many bodies those that the event is about are named") {
    live::Scene scene = sample::live_scene(0.7);
    for (int i = 0; i < 5; ++i) {
        scene.actors.push_back(sample::actor("disc", 10.0 + 3 * i, 0, 0, 1));
        scene.actors.back().visual.name = "far";
    }
    live::Stage stage(scene);
    const auto names = [&] {
        std::vector<std::string> found;
        for (const viz::Mark& mark : live::picture(stage).panels[0].marks)
            if (const auto* label = std::get_if<viz::Label>(&mark)) found.push_back(label->text);
        return found;
    };
    CHECK(names().empty());
    stage.look_inside(0);
    CHECK(names() == std::vector<std::string>{stage.names()[0], stage.names()[1]});
}

TEST_CASE("whatever changes a stage leaves the frame that was looked into") {
    const auto left_by = [](auto change) {
        live::Stage stage = meeting();
        stage.look_inside(1);
        CHECK(stage.event() == 1);
        change(stage);
        CHECK_FALSE(stage.event());
        CHECK(report_of(stage)["event"].is_null());
    };
    left_by([](live::Stage& stage) { stage.step(); });
    left_by([](live::Stage& stage) { stage.reset(); });
    left_by([](live::Stage& stage) { stage.place(0, {0, 0}, 0); });
    left_by([](live::Stage& stage) { stage.move(0, {0, 0}, 0); });
    left_by([](live::Stage& stage) { stage.set_level(1); });
    left_by([](live::Stage& stage) { stage.set_budget(9); });
    left_by([](live::Stage& stage) { stage.set_pair_cost(1); });
    left_by([](live::Stage& stage) { stage.set_restitution(0.5); });
    left_by([](live::Stage& stage) { stage.set_policy(lod::Priority::first_come); });
    left_by([](live::Stage& stage) { stage.set_contact_model(lod::ContactModel::centre_line); });
    left_by([](live::Stage& stage) { stage.set_response(lod::Response::sum); });
    left_by([](live::Stage& stage) { stage.set_fixation({0, 0}); });
}

TEST_CASE(
    "a scene of verdicts tells of levels alone inside a frame, and one without pairs nothing") {
    live::Scene scene = sample::live_scene(0.7);
    scene.told = live::Told::verdicts;
    live::Stage stage(scene);
    REQUIRE_FALSE(stage.apart().events.empty());
    for (const scenes::Event<2>& event : stage.apart().events)
        CHECK(event.kind == scenes::EventKind::level);
    CHECK_THROWS_WITH(stage.look_inside(99), Catch::Contains("this frame has 4 levels"));
    stage.place(0, {-50, 0}, 0);
    CHECK(stage.apart().events.empty());
    CHECK_THROWS_WITH(stage.look_inside(0), Catch::Contains("no event"));
}

TEST_CASE("a single body shows the circles of its level") {
    live::Scene scene = sample::live_scene();
    scene.actors.pop_back();
    live::Stage stage(scene);
    for (int level = 0; level <= 3; ++level) {
        stage.set_level(level);
        const auto circles = static_cast<int>(stage.bodies()[0].tree->level_nodes(level).size());
        CHECK(count_role(live::picture(stage), viz::Role::level_node) == circles);
        CHECK(live::picture(stage).caption == "Level " + std::to_string(level) + ": " +
                                                  std::to_string(circles) +
                                                  (circles == 1 ? " circle." : " circles."));
    }
}

TEST_CASE("a hit is shown for a third of a second") {
    live::Stage stage(sample::live_scene());
    int frames = 0;
    while (stage.hits().empty() && frames++ < 400) stage.step();
    REQUIRE_FALSE(stage.hits().empty());
    CHECK(count_role(live::picture(stage), viz::Role::impulse) ==
          static_cast<int>(stage.hits().size()));
    stage.step(120);
    CHECK(stage.hits().empty());
    CHECK(count_role(live::picture(stage), viz::Role::impulse) == 0);
}

TEST_CASE("restitution 0 leaves a head-on collision without closing speed") {
    live::Stage stage(sample::live_scene());
    const double before = lod::kinetic_energy<2>(stage.bodies());
    stage.set_restitution(0);
    stage.step(240);
    CHECK(lod::kinetic_energy<2>(stage.bodies()) < 0.9 * before);
    stage.reset();
    stage.set_restitution(1);
    stage.step(240);
    CHECK(lod::kinetic_energy<2>(stage.bodies()) == Approx(before));
}

TEST_CASE("the point looked at is shown where attention decides") {
    live::Stage stage = meeting();
    CHECK(count_role(live::picture(stage), viz::Role::reference) == 0);
    stage.set_policy(lod::Priority::perceptual);
    stage.set_fixation({0.5, 0.25});
    CHECK(count_role(live::picture(stage), viz::Role::reference) == 2);
    CHECK(stage.scene().settings.viewer.fixation == lod::Viewer::Point{0.5, 0.25, 0});
}

TEST_CASE("the finding of a stage says what the record says") {
    live::Stage stage = meeting();
    CHECK(live::picture(stage).caption.find("true collision at level 3") != std::string::npos);
    CHECK(live::picture(stage).caption.find("the shapes do overlap") != std::string::npos);
    stage.set_contact_model(lod::ContactModel::centre_line);
    stage.place(0, {-0.6, 0}, 0.3);
    stage.set_level(0);
    CHECK_THAT(live::picture(stage).caption,
               Catch::Contains("possible collision at level 0 after 1 node test, 1 contact") &&
                   Catch::Contains("the shapes are still"));
}

TEST_CASE("what a stage cannot do is refused and changes nothing") {
    live::Stage stage(sample::live_scene());
    const std::string before = live::report(stage);
    const double nan = std::nan("");
    CHECK_THROWS_AS(stage.place(9, {0, 0}, 0), lod::Error);
    CHECK_THROWS_AS(stage.place(0, {nan, 0}, 0), lod::Error);
    CHECK_THROWS_AS(stage.place(0, {0, 0}, 1e300), lod::Error);
    CHECK_THROWS_AS(stage.move(0, {1e9, 0}, 0), lod::Error);
    CHECK_THROWS_AS(stage.set_level(-1), lod::Error);
    CHECK_THROWS_AS(stage.set_restitution(1.5), lod::Error);
    CHECK_THROWS_AS(stage.set_pair_cost(nan), lod::Error);
    CHECK_THROWS_AS(stage.set_fixation({nan, 0}), lod::Error);
    CHECK_THROWS_AS(stage.step(-1), lod::Error);
    CHECK(live::report(stage) == before);
}

TEST_CASE("all nodes of the level are shown, or their hulls, where that is asked for") {
    live::Stage stage(sample::live_scene());
    stage.set_level(1);
    std::size_t nodes = 0;
    for (const lod::Body<2>& body : stage.bodies()) nodes += body.tree->level_nodes(1).size();
    CHECK(count_role(live::picture(stage), viz::Role::level_node) == 0);
    for (const live::Shown shown : {live::Shown::circles, live::Shown::hulls}) {
        stage.show(shown);
        CHECK(count_role(live::picture(stage), viz::Role::level_node) == static_cast<int>(nodes));
    }
}
