// A run is written to a trace while it goes; any frame of it is reached without running from the
// start, forwards and backwards, and tells what happened there.
#include <cstdio>
#include <vector>

#include <lodlab/core/frame/state_hash.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>
#include <lodlab/scenes/trace/events.hpp>
#include <lodlab/scenes/trace/trace_player.hpp>
#include <lodlab/scenes/trace/trace_writer.hpp>

std::vector<lod::Body<2>> stars() {
    const lod2d::Shape star = lod2d::generate("star:5");
    const auto tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(star));
    std::vector<lod::Body<2>> bodies(2);
    for (lod::Body<2>& body : bodies) {
        lod::set_mass(body, star.area, lod::Inertia<2>::Constant(star.second_moment));
        body.tree = tree;
    }
    bodies[0].position = {-2, 0.1};
    bodies[0].velocity = {1, 0};
    bodies[0].spin[0] = 2;
    return bodies;
}

int main() {
    scenes::RunOptions options;
    options.settings.time_step = 1.0 / 120;
    options.limits.node_tests = 40;
    scenes::Runner<2> runner(stars(), options);
    scenes::TraceWriter<2> writer("stars.json",
                                  {"stars", runner.bodies(), options.settings, options.limits});
    while (runner.frame() < 1000) {
        const scenes::Step<2>& step = runner.next();
        writer.add(step, scenes::states_of(runner.bodies()));
    }
    writer.finish();

    scenes::TracePlayer<2> player(scenes::read_trace("stars.json"), stars());
    player.seek(1000);
    const bool same = player.state_hash() == lod::state_hash(runner.bodies());
    while (player.frame() > 0) {
        player.back();
        if (player.step().record.impacts.empty()) continue;
        const auto events = scenes::events_of<2>(player.step(), player.bodies(), options.settings);
        std::printf("the last frame with a contact: %d, %zu events\n", int(player.frame()),
                    events.size());
        break;
    }
    std::printf("the end has %s bits; %d frames were run to find it\n", same ? "the same" : "OTHER",
                int(player.frames_run()));
    return same ? 0 : 1;
}
