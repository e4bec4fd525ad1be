#include "lodlab/live/outline.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"
#include "lodlab/lod2d/shape/outline.hpp"

namespace live {
namespace {

constexpr double apart = 1.1;  ///< centres from the middle [m]
constexpr double speed = 0.6;  ///< [m/s]

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, "outline " + name + " " + why);
}

/// The corners, without those that are where the one before is.
lod2d::Ring corners_of(const DrawnOutline& outline) {
    lod2d::Ring ring;
    for (const viz::Point& p : outline.ring) {
        const lod2d::Point corner(p.x, p.y);
        if (!(corner.norm() < 1e6)) refuse(outline.name, "has a corner that is no place");
        if (ring.empty() || ring.back() != corner) ring.push_back(corner);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) refuse(outline.name, "has fewer than three corners; draw on");
    if (ring.size() > most_corners)
        refuse(outline.name,
               "has more than " + std::to_string(most_corners) + " corners; draw a simpler one");
    return ring;
}

/// Whether two sides that are no neighbours meet, or neighbours fold onto each other.
bool crosses_itself(const lod2d::Ring& ring) {
    const std::size_t count = ring.size();
    const auto next = [&](std::size_t i) { return (i + 1) % count; };
    for (std::size_t i = 0; i < count; ++i) {
        const lod2d::Point& after = ring[next(next(i))];
        if (lod2d::orientation(ring[i], ring[next(i)], after) == 0 &&
            (lod2d::on_segment(ring[i], ring[next(i)], after) ||
             lod2d::on_segment(ring[next(i)], after, ring[i])))
            return true;
        for (std::size_t k = i + 2; k < count; ++k) {
            if (next(k) == i) continue;
            if (lod2d::segments_meet(ring[i], ring[next(i)], ring[k], ring[next(k)])) return true;
        }
    }
    return false;
}

viz::Actor<2> actor_of(const DrawnOutline& outline, int depth) {
    lod2d::Polygon polygon{{corners_of(outline)}};
    lod2d::Ring& ring = polygon.rings[0];
    if (crosses_itself(ring))
        refuse(outline.name, "crosses or touches itself; draw one that does not");
    if (lod2d::polygon_area(polygon) < 0) std::reverse(ring.begin(), ring.end());
    const double size = lod2d::bounds(polygon).size().maxCoeff();
    for (lod2d::Point& corner : ring) corner *= 1 / size;
    const lod2d::Shape shape = lod2d::make_shape(outline.name, polygon);
    viz::Actor<2> actor{viz::visual_of(shape), {}};
    lod::set_mass<2>(actor.body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    actor.body.tree =
        std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(shape, {.depth = depth}));
    actor.body.exact = std::make_shared<lod2d::ExactOutline>(shape);
    return actor;
}

Scene read(const nlohmann::json& json) {
    std::vector<DrawnOutline> outlines;
    for (const nlohmann::json& one : json.at("outlines")) {
        DrawnOutline outline{one.at("name").get<std::string>(), {}};
        const auto numbers = one.at("points").get<std::vector<double>>();
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            outline.ring.push_back({numbers[i], numbers[i + 1]});
        outlines.push_back(std::move(outline));
    }
    return scene_of(outlines, json.at("depth").get<int>());
}

}  // namespace

Scene scene_of(const std::vector<DrawnOutline>& outlines, int depth) {
    if (outlines.empty() || outlines.size() > 2)
        throw lod::Error(lod::ErrorKind::input_refused, "one outline or two make a scene");
    if (depth < 0 || depth > most_depth)
        throw lod::Error(
            lod::ErrorKind::input_refused,
            "a tree has 0 to " + std::to_string(most_depth) + " levels below its root");
    Scene scene;
    scene.name = "playground";
    scene.title = "Draw a shape, and let it collide";
    scene.settings.time_step = 1.0 / 240;
    for (const DrawnOutline& outline : outlines) scene.actors.push_back(actor_of(outline, depth));
    if (scene.actors.size() == 2)
        for (const int i : {0, 1}) {
            lod::Body<2>& body = scene.actors[static_cast<std::size_t>(i)].body;
            body.position = {i == 0 ? -apart : apart, i == 0 ? 0.0 : 0.15};
            body.velocity = {i == 0 ? speed : -speed, 0};
        }
    scene.view = {{-2.2, -1.5}, {2.2, 1.5}};
    return scene;
}

Scene scene_of_outlines(std::string_view text) {
    try {
        return read(nlohmann::json::parse(text));
    } catch (const lod::Error&) {
        throw;
    } catch (const std::exception& error) {
        throw lod::Error(lod::ErrorKind::input_refused,
                         std::string("these are no outlines: ") + error.what() + "; draw again");
    }
}

}  // namespace live
