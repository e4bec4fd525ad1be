#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod2d/builder/medial_axis.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"
#include "lodlab/lod2d/source/load.hpp"
#include "lodlab/lod3d/source/file_mesh.hpp"
#include "lodlab/scenes/builder_choice.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/raise.hpp"
#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {
namespace {

lod2d::Pose pose_of(const lod::Body<2>& body) {
    return {body.position, body.orientation};
}

std::string names_of_generators() {
    std::string list;
    for (const lod2d::Generator& one : lod2d::generators())
        list += (list.empty() ? "" : ", ") + std::string(one.name);
    return list;
}

}  // namespace

PlaneShapes::Shape PlaneShapes::named(const std::string& spec, const ShapeChoice& choice) {
    if (lod3d::is_mesh_format(lod::ending_of(spec)))
        throw lod::Error(lod::ErrorKind::usage,
                         spec +
                             " is a mesh, and this is the plane; write dim = 3 in a scene, or "
                             "--dim 3 at the command");
    if (choice.fill)
        throw lod::Error(lod::ErrorKind::usage,
                         "only meshes are filled, and " + spec + " is none; drop the option");
    if (!lod2d::names_shape(spec))
        throw lod::Error(lod::ErrorKind::usage,
                         "'" + spec + "' names no shape; give a drawing (" +
                             std::string(words.files) + "), a mesh (" +
                             std::string(SpaceShapes::words.files) +
                             "), text:R, or a generator: " + names_of_generators());
    check_drawing_choice(spec, choice);
    lod2d::LoadSettings settings;
    settings.strokes = choice.strokes;
    settings.strict = choice.strict;
    settings.page = choice.page;
    if (choice.size) settings.outline.size = *choice.size;
    raise(settings.most_bytes, choice.raise_limits);
    raise(settings.most_elements, choice.raise_limits);
    raise(settings.most_memory, choice.raise_limits);
    raise(settings.most_seconds, choice.raise_limits);
    raise(settings.outline.clean.most_points, choice.raise_limits);
    raise(settings.outline.clean.most_edge_pairs, choice.raise_limits);
    raise(settings.outline.clean.most_sweep_steps, choice.raise_limits);
    raise(settings.outline.clean.most_crossings, choice.raise_limits);
    lod2d::Shape shape =
        lod2d::load_shape(in_package(spec) ? package_file(spec).string() : spec, settings);
    if (!choice.size || !lod2d::names_generator(spec)) return shape;
    const double scale = *choice.size / lod2d::bounds(shape.polygon).size().maxCoeff();
    for (lod2d::Ring& ring : shape.polygon.rings)
        for (lod2d::Point& point : ring) point *= scale;
    return lod2d::make_shape(shape.name, shape.polygon);
}

PlaneShapes::Shape PlaneShapes::half_space() {
    constexpr double reach = half_space_reach;
    Shape shape;
    shape.name = half_space_name;
    shape.polygon.rings = {{{-reach, -reach}, {reach, -reach}, {reach, 0}, {-reach, 0}}};
    shape.area = 2 * reach * reach;
    shape.second_moment = 1;  // of no meaning: it never turns
    return shape;
}

PlaneShapes::Settings PlaneShapes::settings(const TreeChoice& choice) {
    const Settings settings = settings_of<Settings>(choice, "builder of circle trees");
    check_effort(choice, false);
    return settings;
}

std::shared_ptr<const lod::ExactShape<2>> PlaneShapes::exact_of(const Shape& shape) {
    return std::make_shared<lod2d::ExactOutline>(shape);
}

lod::SphereTree<2> PlaneShapes::build(const Shape& shape, const Settings& settings) {
    return lod2d::build_tree(shape, settings);
}

void PlaneShapes::identify(const Shape& shape, const Settings& settings, io::Sha256& key) {
    key.add(lod2d::medial_axis_release());
    key.add(static_cast<int>(shape.polygon.rings.size()));
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        key.add(static_cast<int>(ring.size()));
        for (const lod2d::Point& point : ring)
            for (const double coordinate : point) key.add(coordinate);
    }
    // Names every setting, so that a new one does not compile until it is here.
    const auto& [builder, branching, depth, least_protrusion, most_nodes, normal_weight, progress] =
        settings;
    static_cast<void>(progress);
    key.add(lod::name_of(builder));
    key.add(branching);
    key.add(depth);
    key.add(least_protrusion);
    key.add(most_nodes);
    key.add(normal_weight);
}

lod::TreeReport PlaneShapes::report(const Shape& shape, const lod::SphereTree<2>& tree) {
    return lod2d::report_tree(shape, tree);
}

lod::Inertia<2> PlaneShapes::second_moment(const Shape& shape) {
    return lod::Inertia<2>::Constant(shape.second_moment);
}

std::vector<std::string> PlaneShapes::remarks(const Shape& shape) {
    return shape.remarks;
}

PlaneShapes::Border PlaneShapes::border_of(const Shape& shape) {
    return Border(shape.polygon);
}

bool PlaneShapes::touch(const Border& a, const lod::Body<2>& body_a, const Border& b,
                        const lod::Body<2>& body_b) {
    return lod2d::overlap(a.carried(pose_of(body_a)), b.carried(pose_of(body_b)));
}

std::vector<GeneratorNote> PlaneShapes::generators() {
    return notes_of(lod2d::generators());
}

std::vector<std::string_view> PlaneShapes::builders() {
    return builder_names<Settings>();
}

}  // namespace scenes
