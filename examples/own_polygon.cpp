// A polygon of your own becomes a body; its tree is built once and kept in a file.
#include <cstdio>
#include <filesystem>
#include <vector>

#include <lodlab/core/frame/frame.hpp>
#include <lodlab/io/tree_json.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>

int main() {
    // Anticlockwise, y up, in metres; holes would run clockwise.
    const lod2d::Polygon outline{{{{0, 0}, {2, 0}, {2, 1}, {1, 0.5}, {0, 1}}}};
    // A file holds the tree alone: area, inertia and centre of mass come from the shape, which is
    // cheap.
    const lod2d::Shape rock = lod2d::make_shape("rock", outline);
    const std::filesystem::path file = "rock.tree.json";
    if (!std::filesystem::exists(file)) io::save_tree<2>(file, lod2d::build_tree(rock));
    const auto tree = std::make_shared<const lod::SphereTree<2>>(io::load_tree<2>(file));

    const auto body_at = [&](double x, double velocity) {
        lod::Body<2> body;
        lod::set_mass(body, rock.area, lod::Inertia<2>::Constant(rock.second_moment));
        body.tree = tree;
        body.position = {x, 0};  // of the centre of mass, which is at rock.centroid in the outline
        body.velocity = {velocity, 0};
        return body;
    };
    std::vector<lod::Body<2>> bodies{body_at(-2, 1), body_at(2, -1)};
    lod::FrameStorage<2> storage;
    for (int frame = 0; frame < 240; ++frame) {
        lod::Budget budget = lod::Budget::node_tests(500);
        const auto& record = lod::advance<2>(bodies, {.time_step = 1.0 / 120}, budget, storage);
        for (std::size_t i = 0; i < record.impacts.size(); ++i)
            if (record.impulses[i] > 0)
                std::printf("%.3f N s at (%.3f, %.3f)\n", record.impulses[i],
                            record.impacts[i].contact.point.x(),
                            record.impacts[i].contact.point.y());
    }
    std::printf("%zu circles; velocities %.3f and %.3f m/s\n", tree->radius.size(),
                bodies[0].velocity.x(), bodies[1].velocity.x());
}
