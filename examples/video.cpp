// Steps two bodies and films them: every frame of the video is a figure made from the bodies.
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>
#include <lodlab/viz/draw/scene_view.hpp>
#include <lodlab/viz/film/write.hpp>

std::vector<viz::Ring> outline(const lod2d::Shape& shape) {
    std::vector<viz::Ring> rings;
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        rings.emplace_back();
        for (const lod2d::Point& point : ring) rings.back().push_back({point.x(), point.y()});
    }
    return rings;
}

int main() {
    const std::vector<lod2d::Shape> shapes = {lod2d::generate("cross"), lod2d::generate("gear:7")};
    std::vector<lod::Body<2>> bodies(2);
    for (std::size_t i = 0; i < 2; ++i) {
        lod::set_mass(bodies[i], shapes[i].area,
                      lod::Inertia<2>::Constant(shapes[i].second_moment));
        bodies[i].tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shapes[i]));
    }
    bodies[0].position = {-1.2, 0};
    bodies[0].velocity = {1.5, 0};
    bodies[1].position = {0.4, 0.35};

    viz::Animation animation;
    lod::FrameStorage<2> storage;
    for (int frame = 0; frame < 60; ++frame) {
        viz::Panel panel;
        panel.view = {{-2, -1.2}, {2, 1.2}};
        for (int i = 0; i < 2; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const auto rings = viz::carried(bodies[at], outline(shapes[at]));
            panel.marks.push_back(viz::Path{{viz::Role::body, i}, rings});
        }
        viz::Figure figure;
        figure.title = "A cross strikes a gear off centre";
        figure.panels = {panel};
        viz::hold(animation, figure, 1.0 / 30);

        lod::Budget budget = lod::Budget::unlimited();
        lod::advance<2>(bodies, {.time_step = 1.0 / 30}, budget, storage);
    }
    viz::WriteOptions options;
    options.quality = viz::Quality::draft;
    viz::write_animation("cross_and_gear.mp4", animation, options);
}
