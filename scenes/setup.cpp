#include "scenes/setup.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/error.hpp"
#include "lod2d/generators.hpp"
#include "lod2d/load.hpp"
#include "lod2d/overlap.hpp"

namespace scenes {
namespace {

using SharedShape = std::shared_ptr<const lod2d::Shape>;
using SharedTree = std::shared_ptr<const lod::SphereTree<2>>;

/// Shapes and trees that were made already, by all that decides what they are.
struct Stock {
    std::map<std::tuple<std::string, std::optional<double>>, SharedShape> shapes;
    std::map<std::tuple<const lod2d::Shape*, std::string, std::optional<int>, std::optional<int>>,
             SharedTree>
        trees;
};

SharedShape shape_of(const BodySpec& spec, double raise_limits, Stock& stock) {
    const std::string name = spec.file.empty() ? spec.shape : spec.file.string();
    SharedShape& shape = stock.shapes[{name, spec.size}];
    if (!shape)
        shape = std::make_shared<const lod2d::Shape>(shape_named(name, spec.size, raise_limits));
    return shape;
}

SharedTree tree_of(const BodySpec& spec, const SharedShape& shape, Stock& stock) {
    SharedTree& tree = stock.trees[{shape.get(), spec.builder, spec.branching, spec.depth}];
    if (!tree) {
        const auto settings = tree_settings(spec.builder, spec.branching, spec.depth);
        tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(*shape, settings));
    }
    return tree;
}

lod::Body<2> body_of(const BodySpec& spec, const lod2d::Shape& shape, SharedTree tree) {
    lod::Body<2> body;
    body.tree = std::move(tree);
    body.restitution = spec.restitution;
    body.position = {spec.position[0], spec.position[1]};
    body.orientation = lod::wrapped_angle(spec.angle);
    body.velocity = {spec.velocity[0], spec.velocity[1]};
    body.spin[0] = spec.spin;
    if (spec.is_static) {
        lod::make_static(body);
    } else {
        const double mass = spec.mass.value_or(spec.density * shape.area);
        const double inertia = mass / shape.area * shape.second_moment;
        lod::set_mass<2>(body, mass, lod::Inertia<2>::Constant(inertia));
    }
    lod::check_body(body, spec.name);
    return body;
}

lod2d::Pose pose_of(const lod::Body<2>& body) {
    return {body.position, body.orientation};
}

bool roots_meet(const lod::Body<2>& a, const lod::Body<2>& b) {
    const lod::Sphere<2> root_a = a.tree->sphere(0);
    const lod::Sphere<2> root_b = b.tree->sphere(0);
    // Turning moves a centre within its distance from the centre of mass.
    const double reach =
        root_a.radius + root_a.centre.norm() + root_b.radius + root_b.centre.norm();
    return (b.position - a.position).norm() <= reach;
}

/// A line for every two bodies, not both static, whose shapes share a point at the start.
std::vector<std::string> overlaps_at_start(const Setup& setup) {
    std::vector<std::string> warnings;
    for (std::size_t a = 0; a < setup.bodies.size(); ++a) {
        lod::check_interrupted();
        for (std::size_t b = a + 1; b < setup.bodies.size(); ++b) {
            const lod::Body<2>& body_a = setup.bodies[a];
            const lod::Body<2>& body_b = setup.bodies[b];
            if ((body_a.is_static() && body_b.is_static()) || !roots_meet(body_a, body_b)) continue;
            if (!lod2d::overlap(*setup.shapes[a], pose_of(body_a), *setup.shapes[b],
                                pose_of(body_b)))
                continue;
            warnings.push_back(setup.scene.bodies[b].where + ": bodies " +
                               setup.scene.bodies[a].name + " and " + setup.scene.bodies[b].name +
                               " touch or overlap at the start; move one of them if that is not "
                               "meant");
        }
    }
    return warnings;
}

template <class Count>
void raise(Count& limit, double factor) {
    const double raised = static_cast<double>(limit) * factor;
    constexpr double most = 9e18;  // what every count can hold
    limit = static_cast<Count>(std::min(raised, most));
}

}  // namespace

lod2d::Shape shape_named(const std::string& spec, std::optional<double> size, double raise_limits) {
    lod2d::LoadSettings settings;
    if (size) settings.outline.size = *size;
    raise(settings.most_bytes, raise_limits);
    raise(settings.most_elements, raise_limits);
    raise(settings.outline.clean.most_points, raise_limits);
    raise(settings.outline.clean.most_edge_pairs, raise_limits);
    raise(settings.outline.clean.most_sweep_steps, raise_limits);
    lod2d::Shape shape = lod2d::load_shape(spec, settings);
    if (!size || !lod2d::names_generator(spec)) return shape;
    const double scale = *size / lod2d::bounds(shape.polygon).sizes().maxCoeff();
    for (lod2d::Ring& ring : shape.polygon.rings)
        for (lod2d::Point& point : ring) point *= scale;
    return lod2d::make_shape(shape.name, shape.polygon);
}

lod2d::TreeSettings tree_settings(const std::string& builder, std::optional<int> branching,
                                  std::optional<int> depth) {
    lod2d::TreeSettings settings;
    if (!builder.empty()) settings.builder = lod2d::builder_named(builder);
    if (branching) settings.branching = *branching;
    if (depth) settings.depth = *depth;
    return settings;
}

Setup set_up(const Scene& scene, double raise_limits) {
    Setup setup;
    setup.scene = scene;
    Stock stock;
    for (const BodySpec& spec : scene.bodies) {
        lod::check_interrupted();
        try {
            setup.shapes.push_back(shape_of(spec, raise_limits, stock));
            SharedTree tree = tree_of(spec, setup.shapes.back(), stock);
            setup.bodies.push_back(body_of(spec, *setup.shapes.back(), std::move(tree)));
        } catch (const lod::Error& error) {
            // A shape that is misspelt in a file is input that is refused, not wrong usage.
            const auto kind = error.kind() == lod::ErrorKind::usage ? lod::ErrorKind::input_refused
                                                                    : error.kind();
            throw lod::Error(kind, spec.where + ": body " + spec.name + ": " + error.what());
        }
    }
    setup.warnings = overlaps_at_start(setup);
    return setup;
}

}  // namespace scenes
