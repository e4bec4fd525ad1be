#include <algorithm>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod2d/source/load.hpp"
#include "lodlab/lod3d/builder/tree_report.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/solid/surface.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "lodlab/scenes/builder_choice.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/raise.hpp"
#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/shapes.hpp"

namespace scenes {
namespace {

lod3d::ImportLimits limits_raised(double factor) {
    lod3d::ImportLimits limits;
    raise(limits.most_bytes, factor);
    raise(limits.most_triangles, factor);
    raise(limits.most_memory, factor);
    raise(limits.most_seconds, factor);
    return limits;
}

/// The shape's triangles in the frame of their source.
lod3d::FileMesh mesh_of(const std::string& spec, double raise_limits) {
    if (lod3d::names_generator(spec))
        return {lod::make_from_spec(lod3d::generators(), spec), 0, {}};
    if (looks_like_file(spec) && lod::ending_of(spec) != "svg")
        return lod3d::read_mesh(in_package(spec) ? package_file(spec).string() : spec,
                                limits_raised(raise_limits), spec);
    if (lod2d::names_shape(spec))
        throw lod::Error(lod::ErrorKind::usage,
                         spec + " is a shape of the plane, and this is space; name a mesh (" +
                             std::string(SpaceShapes::words.files) +
                             ") or a generator of space, which lodlab tree --list shows");
    return {lod::make_from_spec(lod3d::generators(), spec), 0, {}};  // throws: no such
}

lod3d::Pose pose_of(const lod::Body<3>& body) {
    return {lod::Space<3>::rotation(body.orientation), body.position};
}

/// Whether a point of some part of one body lies inside the other.
bool any_inside(const SpaceShapes::Border& a, const lod::Body<3>& body_a,
                const SpaceShapes::Border& b, const lod::Body<3>& body_b) {
    const lod3d::Pose from = pose_of(body_a);
    const lod3d::Pose to = pose_of(body_b);
    return std::any_of(a.of_parts.begin(), a.of_parts.end(), [&](const lod3d::Point& p) {
        return b.distance.inside(to.rotation.transpose() * (from.carry(p) - to.position));
    });
}

}  // namespace

SpaceShapes::Shape SpaceShapes::named(const std::string& spec, const ShapeChoice& choice) {
    check_drawing_choice(spec, choice);
    lod3d::FileMesh file = mesh_of(spec, choice.raise_limits);
    const std::string name =
        lod3d::names_generator(spec) ? spec : std::filesystem::path(spec).stem().string();
    lod3d::SolidOptions options;
    options.source = spec;
    options.longest_side = choice.size;
    options.fill = choice.fill;
    Shape shape = lod3d::make_solid(name, std::move(file.mesh), options);
    shape.mended.insert(shape.mended.begin(), file.remarks.begin(), file.remarks.end());
    return shape;
}

SpaceShapes::Shape SpaceShapes::half_space() {
    Shape shape = lod3d::generate("box:1,1,1");
    shape.name = half_space_name;
    // The box's upper side through the origin; what makes up a mass has no meaning, it never moves.
    for (lod3d::Point& p : shape.mesh.vertices)
        p = 2 * half_space_reach * (p - lod3d::Point(0, 0.5, 0));
    return shape;
}

SpaceShapes::Settings SpaceShapes::settings(const TreeChoice& choice) {
    Settings settings = settings_of<Settings>(choice, "builder of sphere trees");
    check_effort(choice, settings.builder == lod3d::Builder::cover);
    if (choice.effort) settings.effort = *choice.effort;
    return settings;
}

lod::SphereTree<3> SpaceShapes::build(const Shape& shape, const Settings& settings) {
    return lod3d::build_tree(shape, settings);
}

void SpaceShapes::identify(const Shape& shape, const Settings& settings, io::Sha256& key) {
    key.add(static_cast<int>(shape.inside_rule));
    key.add(static_cast<int>(shape.mesh.vertices.size()));
    for (const lod3d::Point& point : shape.mesh.vertices)
        for (const double coordinate : point) key.add(coordinate);
    key.add(static_cast<int>(shape.mesh.triangles.size()));
    for (const lod3d::Triangle& triangle : shape.mesh.triangles)
        for (const std::int32_t corner : triangle) key.add(corner);
    // Names every setting, so that a new one does not compile until it is here.
    const auto& [builder, branching, depth, least_protrusion, effort, most_nodes, progress] =
        settings;
    static_cast<void>(progress);
    key.add(lod::name_of(builder));
    key.add(branching);
    key.add(depth);
    key.add(least_protrusion);
    key.add(effort);
    key.add(most_nodes);
}

lod::TreeReport SpaceShapes::report(const Shape& shape, const lod::SphereTree<3>& tree) {
    return lod3d::report_tree(shape, tree);
}

lod::Inertia<3> SpaceShapes::second_moment(const Shape& shape) {
    return shape.second_moment;
}

std::vector<std::string> SpaceShapes::remarks(const Shape& shape) {
    std::vector<std::string> lines;
    for (const std::string& line : shape.mended) lines.push_back(shape.name + ": " + line);
    if (shape.approximate)
        lines.push_back(shape.name + ": volume, centre and inertia are approximate");
    return lines;
}

std::shared_ptr<const lod::ExactShape<3>> SpaceShapes::exact_of(const Shape& shape) {
    return std::make_shared<lod3d::ExactSurface>(shape);
}

SpaceShapes::Border SpaceShapes::border_of(const Shape& shape) {
    Border border{lod3d::MeshDistance(shape.mesh, shape.inside_rule), {}};
    const lod3d::Parts parts = lod3d::find_parts(shape.mesh);
    std::vector<bool> seen(static_cast<std::size_t>(parts.count), false);
    for (std::size_t t = 0; t < shape.mesh.triangles.size(); ++t) {
        const auto part = static_cast<std::size_t>(parts.of_triangle[t]);
        if (!seen[part]) border.of_parts.push_back(shape.mesh.corner(t, 0));
        seen[part] = true;
    }
    return border;
}

bool SpaceShapes::touch(const Border& a, const lod::Body<3>& body_a, const Border& b,
                        const lod::Body<3>& body_b) {
    return lod3d::surfaces_intersect(a.distance.tree(), pose_of(body_a), b.distance.tree(),
                                     pose_of(body_b)) ||
           any_inside(a, body_a, b, body_b) || any_inside(b, body_b, a, body_a);
}

std::vector<GeneratorNote> SpaceShapes::generators() {
    return notes_of(lod3d::generators());
}

std::vector<std::string_view> SpaceShapes::builders() {
    return builder_names<Settings>();
}

int dimension_of(const std::string& spec) {
    if (looks_like_file(spec)) return lod3d::is_mesh_format(lod::ending_of(spec)) ? 3 : 2;
    return lod3d::names_generator(spec) && !lod2d::names_shape(spec) ? 3 : 2;
}

}  // namespace scenes
