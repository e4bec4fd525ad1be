#pragma once

#include "lodlab/live/scene.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "tests/viz/sample_scene.hpp"

namespace sample {

/// Two bodies that approach, and what a page needs beside them.
inline live::Scene live_scene(double apart = 1.2) {
    live::Scene scene;
    scene.name = "two";
    scene.title = "A star meets a gear";
    scene.view = {{-2, -1.5}, {2, 1.5}};
    scene.settings.time_step = 1.0 / 240;
    scene.actors = {actor("star:5", -apart / 2, 0.1, 0.3, 3),
                    actor("gear:9", apart / 2, 0, 0.2, 3)};
    for (viz::Actor<2>& one : scene.actors) {
        lod2d::Shape shape;
        for (const viz::Ring& ring : one.visual.outline) {
            shape.polygon.rings.emplace_back();
            for (const viz::Point& p : ring) shape.polygon.rings.back().push_back({p.x, p.y});
        }
        one.body.exact = std::make_shared<lod2d::ExactOutline>(shape);
    }
    scene.actors[0].body.velocity = {1, 0};
    scene.actors[1].body.velocity = {-1, 0};
    return scene;
}

}  // namespace sample
