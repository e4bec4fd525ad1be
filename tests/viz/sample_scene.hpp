#pragma once

#include <memory>
#include <string>

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace sample {

/// A body with the density 1 and a tree of so many levels below the root.
inline viz::Actor<2> actor(const std::string& spec, double x, double y, double angle,
                           int depth = 4) {
    const lod2d::Shape shape = lod2d::generate(spec);
    viz::Actor<2> actor{viz::visual_of(shape), {}};
    lod::set_mass<2>(actor.body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    actor.body.tree = std::make_shared<lod::SphereTree<2>>(
        lod2d::build_tree(shape, {.branching = 4, .depth = depth}));
    actor.body.position = {x, y};
    actor.body.orientation = angle;
    return actor;
}

}  // namespace sample
