#include "lodlab/live/take.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/run.hpp"

namespace live {
namespace {

constexpr double margin = 0.06;  ///< of the view's longer side, on each side
constexpr double aspect = 0.75;  ///< of what a camera sees, as a page has room for it

/// What all bodies cover from the start to the end of the scene's duration.
viz::Box covered(const Scene& scene, std::int64_t frames) {
    scenes::RunOptions options;
    options.settings = scene.settings;
    options.frames = frames;
    options.limits.node_tests = scene.budget;
    std::vector<lod::Body<2>> bodies;
    for (const viz::Actor<2>& actor : scene.actors) bodies.push_back(actor.body);
    scenes::Runner<2> runner(std::move(bodies), options);
    viz::FlatView view;
    while (true) {
        for (std::size_t i = 0; i < scene.actors.size(); ++i)
            viz::take_in<2>(view, viz::Actor<2>{scene.actors[i].visual, runner.bodies()[i]});
        if (runner.frame() == frames) break;
        static_cast<void>(runner.next());
    }
    return viz::grown(view.box(), margin);
}

viz::Box seen_by(const scenes::Camera& camera) {
    const double across = camera.width / 2;
    const double up = aspect * across;
    const auto [x, y, z] = camera.centre;
    return {{x - across, y - up}, {x + across, y + up}};
}

}  // namespace

Scene scene_of(const scenes::Setup<2>& setup) {
    if (setup.bodies.size() > most_bodies)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "a page follows at most " + std::to_string(most_bodies) +
                             " bodies, and this scene has " + std::to_string(setup.bodies.size()) +
                             "; take a smaller one");
    Scene scene;
    scene.name = setup.scene.name;
    scene.title = setup.scene.title;
    scene.budget = setup.scene.limits.node_tests;
    scenes::Limits limits = setup.scene.limits;
    limits.milliseconds.reset();
    scene.settings = scenes::frame_settings(setup.scene, limits);
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
        viz::Visual<2> visual = viz::visual_of(*setup.shapes[i]);
        visual.name = setup.scene.bodies[i].name;
        scene.actors.push_back({std::move(visual), setup.bodies[i]});
    }
    scene.view =
        setup.scene.camera ? seen_by(*setup.scene.camera) : covered(scene, setup.scene.frames());
    return scene;
}

}  // namespace live
