#include "lodlab/scenes/crowd/crowds.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "tests/catch.hpp"

namespace {

const char* const of_the_plane[] = {"gas:100", "sparse:100", "implode:100", "rain:100"};

int walls_of(const scenes::Scene& scene) {
    int walls = 0;
    for (const scenes::BodySpec& body : scene.bodies)
        walls += body.shape == scenes::half_space_name ? 1 : 0;
    return walls;
}

/// With trees that are built quickly.
scenes::Setup<2> shallow(const std::string& spec) {
    scenes::Scene scene = scenes::crowd(spec);
    for (scenes::BodySpec& body : scene.bodies) body.depth = 2;
    return scenes::set_up<2>(scene);
}

scenes::Run<2> run_of(const scenes::Setup<2>& setup) {
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(setup.scene, setup.scene.limits);
    options.frames = 60;
    return scenes::run(setup.bodies, options);
}

std::string message_of(const std::string& spec) {
    try {
        static_cast<void>(scenes::named_scene(spec));
    } catch (const lod::Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a crowd has as many bodies as it is asked for, and its walls") {
    CHECK(scenes::crowd("gas:1").bodies.size() == 1 + 4);
    CHECK(scenes::crowd("sparse:7").bodies.size() == 7 + 4);
    CHECK(scenes::crowd("implode:1000,5").bodies.size() == 1000 + 4);
    CHECK(scenes::crowd("rain:10").bodies.size() == 10 + 3);
    CHECK(scenes::crowd("bunnies:8").bodies.size() == 8 + 6);
    for (const char* spec : of_the_plane)
        CHECK(walls_of(scenes::crowd(spec)) == (std::string(spec) == "rain:100" ? 3 : 4));
}

TEST_CASE("a crowd is the same for the same seed, and another for another") {
    const auto place = [](const char* spec) { return scenes::crowd(spec).bodies[4].position; };
    CHECK(place("gas:10,1") == place("gas:10"));
    CHECK(place("gas:10,2") != place("gas:10,1"));
}

TEST_CASE("no bodies of a crowd overlap at the start, and none leaves its walls") {
    for (const char* spec : of_the_plane) {
        INFO(spec);
        const scenes::Setup<2> setup = shallow(spec);
        CHECK(setup.warnings.empty());
        const scenes::Run<2> run = run_of(setup);
        CHECK(run.energy_end <= run.energy_start * (1 + 1e-12));
        for (const lod::Body<2>& wall : setup.bodies) {
            if (!wall.tree->is_half_space()) continue;
            lod::PosedTree<2> world;
            world.pose(wall);
            for (std::size_t i = 0; i < run.end.size(); ++i)
                if (!setup.bodies[i].is_static())
                    CHECK(world.half_space().side(run.end[i].position) > 0);
        }
    }
}

TEST_CASE("a bunny of a crowd reaches less than half way to its neighbours and its walls") {
    const scenes::Scene scene = scenes::crowd("bunnies:8");
    const lod3d::Solid bunny =
        scenes::Shapes<3>::named(scene.bodies[0].shape, {.size = scene.bodies[0].size});
    double reach = 0;
    for (const lod3d::Point& corner : bunny.mesh.vertices) reach = std::max(reach, corner.norm());
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t k = 0; k < i; ++k) {
            double squared = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double gap = scene.bodies[i].position[axis] - scene.bodies[k].position[axis];
                squared += gap * gap;
            }
            CHECK(squared > 4 * reach * reach);
        }
    for (const scenes::BodySpec& wall : scene.bodies)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (wall.shape == scenes::half_space_name && wall.position[axis] != 0)
                for (std::size_t i = 0; i < 8; ++i)
                    CHECK(std::abs(wall.position[axis] - scene.bodies[i].position[axis]) > reach);
}

TEST_CASE("the crowd that implodes meets at its centre, and the rain slows down") {
    const scenes::Setup<2> setup = shallow("implode:100");
    const scenes::Run<2> run = run_of(setup);
    std::size_t contacts = 0;
    for (const auto& step : run.steps) contacts += step.record.impacts.size();
    CHECK(contacts > 100);
    const scenes::Setup<2> rain = shallow("rain:100");
    const scenes::Run<2> fallen = run_of(rain);
    CHECK(fallen.energy_end < 0.9 * fallen.energy_start);
}

TEST_CASE("a crowd that is not understood is refused with the mend") {
    CHECK(message_of("gas:x").find("write numbers, as in gas:BODIES,SEED") != std::string::npos);
    CHECK(message_of("gas:0").find("give a whole number from 1 to 50000") != std::string::npos);
    CHECK(message_of("gas:1.5").find("give a whole number") != std::string::npos);
    CHECK(message_of("gas").find("or a crowd, as in gas:1000") != std::string::npos);
    CHECK(message_of("gaz:10").find("or a crowd, as in gas:1000") != std::string::npos);
}

TEST_CASE("every crowd has its row on the page of scenes") {
    std::ifstream page(LODLAB_SOURCE_DIR "/scenes/README.md");
    std::stringstream text;
    text << page.rdbuf();
    for (const scenes::Crowd& crowd : scenes::crowds()) {
        INFO(crowd.name);
        CHECK(text.str().find("| `" + crowd.usage() + "` | " + std::string(crowd.description)) !=
              std::string::npos);
    }
}
