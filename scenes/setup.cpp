#include "scenes/setup.hpp"

#include <map>
#include <tuple>

#include "core/error.hpp"
#include "lod2d/generators.hpp"

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

SharedShape shape_of(const BodySpec& spec, Stock& stock) {
    const std::string name = spec.file.empty() ? spec.shape : spec.file.string();
    SharedShape& shape = stock.shapes[{name, spec.size}];
    if (!shape) shape = std::make_shared<const lod2d::Shape>(shape_named(name, spec.size));
    return shape;
}

// PROVISIONAL
void grow(const lod2d::Polygon& polygon, lod2d::Box box, int depth,
          std::vector<lod::TreeNode<2>>& nodes, int parent) {
    const int self = static_cast<int>(nodes.size());
    nodes.push_back({{box.center(), box.diagonal().norm() / 2}, {0, 0}, {}});
    if (parent >= 0) nodes[static_cast<std::size_t>(parent)].children.push_back(self);
    if (depth == 0) return;
    for (int k = 0; k < 4; ++k) {
        const lod2d::Point corner = box.corner(static_cast<lod2d::Box::CornerType>(k));
        lod2d::Box part(box.center());
        part.extend(corner);
        bool inside = false;
        for (const auto& ring : polygon.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto a = ring[i], b = ring[(i + 1) % ring.size()];
                for (int s = 0; s < 50; ++s)
                    if (part.contains(lod2d::Point(a + (b - a) * s / 50.0))) inside = true;
            }
        if (inside) grow(polygon, part, depth - 1, nodes, self);
    }
}

SharedTree tree_of(const BodySpec& spec, const SharedShape& shape, Stock& stock) {
    SharedTree& tree = stock.trees[{shape.get(), spec.builder, spec.branching, spec.depth}];
    if (!tree) {
        std::vector<lod::TreeNode<2>> nodes;
        grow(shape->polygon, lod2d::bounds(shape->polygon), spec.depth.value_or(4), nodes, -1);
        tree = std::make_shared<const lod::SphereTree<2>>(lod::lay_out<2>(nodes));
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

}  // namespace

lod2d::Shape shape_named(const std::string& spec, std::optional<double>) {
    return lod2d::generate(spec);
}

Setup set_up(const Scene& scene) {
    Setup setup;
    setup.scene = scene;
    Stock stock;
    for (const BodySpec& spec : scene.bodies) {
        lod::check_interrupted();
        try {
            setup.shapes.push_back(shape_of(spec, stock));
            SharedTree tree = tree_of(spec, setup.shapes.back(), stock);
            setup.bodies.push_back(body_of(spec, *setup.shapes.back(), std::move(tree)));
        } catch (const lod::Error& error) {
            // A shape that is misspelt in a file is input that is refused, not wrong usage.
            const auto kind = error.kind() == lod::ErrorKind::usage ? lod::ErrorKind::input_refused
                                                                    : error.kind();
            throw lod::Error(kind, spec.where + ": body " + spec.name + ": " + error.what());
        }
    }
    return setup;
}

}  // namespace scenes
