#include <array>
#include <filesystem>
#include <memory>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/instant.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/draw/draw_contacts.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/motion/draw_backtracking.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"
#include "lodlab/viz/draw/motion/draw_strip.hpp"

namespace cli {
namespace {

/// What the figures show in each dimension: scenes that come with lodlab.
struct Cast {
    const char* tree;          ///< its first body
    const char* apart;         ///< two bodies whose trees prove that they are
    const char* face;          ///< a box above a floor
    const char* face_builder;  ///< puts its nodes evenly along a face
    const char* miss;          ///< two bodies that never touch, though nodes of level 1 do
    const char* collision;
};
constexpr std::array<Cast, 2> casts{{
    {"figure9", "near_miss", "box_falls_flat", "pieces", "wide_miss", "figure9"},
    {"two_bunnies", "near_miss_in_space", "cube_falls_flat", "octree", "wide_miss_in_space",
     "two_bunnies"},
}};
constexpr const char* without_package = "knot_meets_ring";

template <int Dim>
constexpr const Cast& cast = casts[Dim - 2];

/// A scene that comes with lodlab, with the options of the command line that concern it. Where its
/// package is missing, one of generators takes its place.
template <int Dim>
scenes::Setup<Dim> stage_named(const std::string& name, const Options& options) {
    Options staged = options;
    staged.scene = name;
    try {
        return stage<Dim>(scene_of(staged), options);
    } catch (const lod::Error& error) {
        if (error.kind() != lod::ErrorKind::not_installed) throw;
        remark(std::string(error.what()) + "; drawing the scene " + without_package +
               " in place of " + name);
    }
    staged.scene = without_package;
    return stage<Dim>(scene_of(staged), options);
}

/// Figure 1: the tree of a real shape, level by level.
template <int Dim>
Drawing tree_of_a_shape(const Options& options) {
    scenes::Setup<Dim> setup = stage_named<Dim>(cast<Dim>.tree, options);
    setup.bodies[0].orientation = lod::Space<Dim>::unturned();
    Drawing drawing;
    drawing.figure = [setup] {
        viz::Actor<Dim> actor = actor_of<Dim>(setup, setup.bodies, 0);
        actor.visual.name = setup.shapes[0]->name;
        viz::Figure figure = viz::tree_levels<Dim>(actor, {0, 1, 2, 3});
        figure.columns = 2;
        return figure;
    };
    return drawing;
}

/// Figure 2: two trees, level by level, until they prove to be apart.
template <int Dim>
Drawing traversal_to_apart(const Options& options) {
    const scenes::Setup<Dim> setup = stage_named<Dim>(cast<Dim>.apart, options);
    const Instant<Dim> instant = instant_of(setup, options);
    Drawing drawing;
    drawing.figure = [setup, instant] {
        return viz::traversal<Dim>(actor_of<Dim>(setup, instant.bodies, 0),
                                   actor_of<Dim>(setup, instant.bodies, 1),
                                   lod::traverse_levels(instant.bodies[0], instant.bodies[1]), {},
                                   viewpoint_of<Dim>(setup.scene));
    };
    return drawing;
}

/// Figure 3: a face meets a face, as ever more contacts of circles or spheres.
template <int Dim>
Drawing contacts_of_a_face(const Options& options) {
    scenes::Setup<Dim> setup = stage_named<Dim>(cast<Dim>.face, options);
    setup.bodies[0].position = 0.5 * lod::Vector<Dim>::Unit(1);  // the faces just touch
    const auto settings =
        scenes::Shapes<Dim>::settings({cast<Dim>.face_builder, {}, {}, {}, {}, {}});
    for (std::size_t i = 0; i < setup.bodies.size(); ++i)
        setup.bodies[i].tree = std::make_shared<lod::SphereTree<Dim>>(
            scenes::tree_of<Dim>(*setup.shapes[i], settings, cache_of(options)));
    Drawing drawing;
    drawing.figure = [setup] {
        viz::Figure figure = viz::contacts_by_level<Dim>(
            actor_of<Dim>(setup, setup.bodies, 0), actor_of<Dim>(setup, setup.bodies, 1),
            lod::traverse_levels(setup.bodies[0], setup.bodies[1]), {.levels = {0, 1, 2, 3}},
            viewpoint_of<Dim>(setup.scene));
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

/// Figure 5: what backtracking at a coarse level makes of bodies that miss each other.
template <int Dim>
Drawing backtracking_too_early(const Options& options) {
    const scenes::Setup<Dim> setup = stage_named<Dim>(cast<Dim>.miss, options);
    Drawing drawing;
    drawing.figure = [setup] {
        return viz::inappropriate_backtracking<Dim>(
            actor_of<Dim>(setup, setup.bodies, 0), actor_of<Dim>(setup, setup.bodies, 1),
            {.level = 1, .time_step = setup.scene.time_step, .horizon = setup.scene.duration},
            viewpoint_of<Dim>(setup.scene));
    };
    return drawing;
}

/// The contact model of a figure: the paper's, unless another is asked for.
lod::ContactModel model_of(const Options& options, const scenes::Scene& asked) {
    return options.contact_model.empty() ? lod::ContactModel::centre_line : asked.contact_model;
}

/// What the caption says of it.
std::string model_words(lod::ContactModel model) {
    switch (model) {
        case lod::ContactModel::centre_line:
            return " Normals run from centre to centre, as in the paper (equation 4); see "
                   "--contact-model hull for the same with hulls.";
        case lod::ContactModel::node_normal:
            return " Normals are those of the surfaces that the nodes stand for.";
        case lod::ContactModel::hull:
            return " Contacts come from the convex hulls of what the nodes hold.";
    }
    return "";
}

/// Figure 9: one collision of two real shapes, interrupted at levels 1, 2 and 3.
template <int Dim>
Drawing strips_of_a_collision(const Options& options) {
    scenes::Setup<Dim> setup = stage_named<Dim>(cast<Dim>.collision, options);
    setup.scene.contact_model = model_of(options, setup.scene);
    std::vector<viz::Run<Dim>> runs;
    for (const int level : {1, 2, 3}) {
        const std::string name = "Level " + std::to_string(level);
        setup.scene.limits = {level, {}, {}};
        runs.push_back(seen(setup, play(setup, options, name), name));
    }
    const auto viewpoint = viewpoint_of<Dim>(setup.scene);
    Drawing drawing;
    const std::string words = model_words(setup.scene.contact_model);
    drawing.figure = [runs, viewpoint, words] {
        viz::Figure figure = viz::strips<Dim>(runs, {}, viewpoint);
        figure.caption += words;
        return figure;
    };
    drawing.animation = [runs, viewpoint] { return viz::impact_motion<Dim>(runs, {}, viewpoint); };
    return drawing;
}

using Draw = Drawing (*)(const Options& options);
struct Numbered {
    int number;
    bool has_video;
    Draw in_plane;
    Draw in_space;  ///< null: there is none
};
constexpr std::array<Numbered, 6> figures{{
    {1, false, tree_of_a_shape<2>, tree_of_a_shape<3>},
    {2, false, traversal_to_apart<2>, traversal_to_apart<3>},
    {3, false, contacts_of_a_face<2>, contacts_of_a_face<3>},
    {4, false, point_and_normal, nullptr},
    {5, false, backtracking_too_early<2>, backtracking_too_early<3>},
    {9, true, strips_of_a_collision<2>, strips_of_a_collision<3>},
}};

}  // namespace

void run_figure(const Options& options) {
    for (const Numbered& figure : figures) {
        if (figure.number != options.number) continue;
        const Draw draw = options.dim == 3 ? figure.in_space : figure.in_plane;
        if (draw == nullptr)
            throw lod::Error(lod::ErrorKind::usage, "figure " + std::to_string(figure.number) +
                                                        " is the same in space; leave --dim 3 out");
        if (!options.contact_model.empty() && figure.number != 9)
            throw lod::Error(lod::ErrorKind::usage,
                             "only figure 9 can be drawn with another contact model; drop "
                             "--contact-model");
        Options named = options;
        if (named.out.empty()) {
            named.out = {"figure-" + std::to_string(figure.number) + ".png"};
            if (std::filesystem::exists(std::filesystem::symlink_status(named.out.front())))
                throw lod::Error(lod::ErrorKind::usage,
                                 named.out.front() + " is there already; give --out " +
                                     named.out.front() + " to replace it, or another name");
            remark("writing " + named.out.front() + "; name other files by --out");
        }
        check_outputs(named, {.video = figure.has_video});
        return write_outputs(named, draw(named));
    }
    throw lod::Error(lod::ErrorKind::usage, "there is no figure " +
                                                std::to_string(*options.number) +
                                                "; there are figures 1, 2, 3, 4, 5 and 9");
}

}  // namespace cli
