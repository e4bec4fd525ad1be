#include <array>
#include <memory>

#include "cli/command.hpp"
#include "cli/instant.hpp"
#include "cli/output.hpp"
#include "cli/pictures.hpp"
#include "cli/staging.hpp"
#include "core/error.hpp"
#include "lod2d/build_tree.hpp"
#include "viz/draw_contacts.hpp"
#include "viz/draw_motion.hpp"
#include "viz/draw_strip.hpp"
#include "viz/draw_traversal.hpp"
#include "viz/draw_tree.hpp"

namespace cli {
namespace {

/// A scene that comes with lodlab, with the options of the command line that concern it.
template <int Dim>
scenes::Setup<Dim> stage_named(const std::string& name, const Options& options) {
    Options staged = options;
    staged.scene = name;
    return stage<Dim>(scene_of(staged), options);
}

/// Figure 1: the tree of a real shape, level by level.
Drawing tree_of_a_shape(const Options& options) {
    scenes::Setup<2> setup = stage_named<2>("figure9", options);
    setup.bodies[0].orientation = 0;
    Drawing drawing;
    drawing.figure = [setup] {
        viz::Figure figure = viz::tree_levels(actor_of(setup, setup.bodies, 0), {0, 1, 2, 3});
        figure.columns = 2;
        return figure;
    };
    return drawing;
}

/// Figure 2: two trees, level by level, until they prove to be apart.
Drawing traversal_to_apart(const Options& options) {
    const scenes::Setup<2> setup = stage_named<2>("near_miss", options);
    const Instant<2> instant = instant_of(setup, options);
    Drawing drawing;
    drawing.figure = [setup, instant] {
        return viz::traversal(actor_of(setup, instant.bodies, 0),
                              actor_of(setup, instant.bodies, 1),
                              lod::traverse_levels(instant.bodies[0], instant.bodies[1]));
    };
    return drawing;
}

/// Figure 3: a face meets a face, as ever more contacts of circles.
Drawing contacts_of_a_face(const Options& options) {
    scenes::Setup<2> setup = stage_named<2>("box_falls_flat", options);
    setup.bodies[0].position = {0, 0.5};                   // the faces just touch
    for (std::size_t i = 0; i < setup.bodies.size(); ++i)  // circles evenly along a face
        setup.bodies[i].tree = std::make_shared<lod::SphereTree<2>>(
            lod2d::build_tree(*setup.shapes[i], {.builder = lod2d::Builder::pieces}));
    Drawing drawing;
    drawing.figure = [setup] {
        viz::Figure figure = viz::contacts_by_level(
            actor_of(setup, setup.bodies, 0), actor_of(setup, setup.bodies, 1),
            lod::traverse_levels(setup.bodies[0], setup.bodies[1]), lod::PointModel::radius_ratio,
            {0, 1, 2, 3});
        figure.columns = 2;
        return figure;
    };
    return drawing;
}

/// Figure 4: the contact point and normal of two nodes of different size.
Drawing point_and_normal(const Options&) {
    Drawing drawing;
    drawing.figure = [] {
        const lod::Sphere<2> large{{0, 0}, 2};
        const lod::Sphere<2> small{{2.2, 0.9}, 1};
        return viz::contact_construction(large, small);
    };
    return drawing;
}

/// Figure 9: one collision of two real shapes, interrupted at levels 1, 2 and 3.
Drawing strips_of_a_collision(const Options& options) {
    scenes::Setup<2> setup = stage_named<2>("figure9", options);
    std::vector<viz::Run<2>> runs;
    for (const int level : {1, 2, 3}) {
        const std::string name = "Level " + std::to_string(level);
        setup.scene.limits = {level, {}, {}};
        runs.push_back(seen(setup, play(setup, options, name), name));
    }
    Drawing drawing;
    drawing.figure = [runs] { return viz::strips(runs); };
    drawing.animation = [runs] { return viz::impact_motion(runs); };
    return drawing;
}

struct Numbered {
    int number;
    bool has_video;
    Drawing (*draw)(const Options& options);
};
constexpr std::array<Numbered, 5> figures{{{1, false, tree_of_a_shape},
                                           {2, false, traversal_to_apart},
                                           {3, false, contacts_of_a_face},
                                           {4, false, point_and_normal},
                                           {9, true, strips_of_a_collision}}};

}  // namespace

void run_figure(const Options& options) {
    for (const Numbered& figure : figures) {
        if (figure.number != options.number) continue;
        check_outputs(options, {.video = figure.has_video});
        Options named = options;
        if (named.out.empty()) {
            named.out = {"figure-" + std::to_string(figure.number) + ".png"};
            remark("writing " + named.out.front() + "; name other files by --out");
        }
        return write_outputs(named, figure.draw(named));
    }
    throw lod::Error(lod::ErrorKind::usage, "there is no figure " +
                                                std::to_string(*options.number) +
                                                "; there are figures 1, 2, 3, 4 and 9");
}

}  // namespace cli
