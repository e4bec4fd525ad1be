#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace sample {

/// Built once in a process.
inline std::shared_ptr<const lod::SphereTree<2>> tree(const std::string& spec, int depth) {
    static std::map<std::pair<std::string, int>, std::shared_ptr<const lod::SphereTree<2>>> built;
    auto& tree = built[{spec, depth}];
    if (!tree)
        tree = std::make_shared<lod::SphereTree<2>>(
            lod2d::build_tree(lod2d::generate(spec), {.branching = 4, .depth = depth}));
    return tree;
}

/// A body with the density 1 and a tree of so many levels below the root.
inline viz::Actor<2> actor(const std::string& spec, double x, double y, double angle,
                           int depth = 4) {
    const lod2d::Shape shape = lod2d::generate(spec);
    viz::Actor<2> actor{viz::visual_of(shape), {}};
    lod::set_mass<2>(actor.body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    actor.body.tree = tree(spec, depth);
    actor.body.position = {x, y};
    actor.body.orientation = angle;
    return actor;
}

}  // namespace sample
