#include "viz/scene_view.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "lod2d/overlap.hpp"

namespace viz {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();

void take_in(Box& box, Point p, double reach) {
    box.low = {std::min(box.low.x, p.x - reach), std::min(box.low.y, p.y - reach)};
    box.high = {std::max(box.high.x, p.x + reach), std::max(box.high.y, p.y + reach)};
}

void take_in(Box& box, const Look& look, const lod::Body<2>& body) {
    for (const Ring& ring : look.rings)
        for (const Point& p : ring) take_in(box, carried(body, p), 0);
    if (!look.rings.empty() || !body.tree) return;
    for (int node = 0; node < body.tree->size(); ++node) {
        if (!body.tree->is_leaf(node)) continue;
        const lod::Sphere<2> leaf = carried_node(body, node);
        take_in(box, {leaf.centre.x(), leaf.centre.y()}, leaf.radius);
    }
}

lod2d::BoundaryIndex world_boundary(const Actor& actor) {
    lod2d::Polygon polygon;
    for (const Ring& ring : carried(actor.body, actor.look.rings)) {
        lod2d::Ring points;
        for (const Point& p : ring) points.emplace_back(p.x, p.y);
        polygon.rings.push_back(std::move(points));
    }
    return lod2d::BoundaryIndex(polygon);
}

}  // namespace

Look look_of(const lod2d::Shape& shape) {
    Look look{shape.name, {}};
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        look.rings.emplace_back();
        for (const lod2d::Point& p : ring) look.rings.back().push_back({p.x(), p.y()});
    }
    return look;
}

double gap(const Actor& a, const Actor& b) {
    if (a.look.rings.empty() || b.look.rings.empty()) return -1;
    return lod2d::distance(world_boundary(a), world_boundary(b));
}

void add_instant(Run& run, std::vector<lod::Body<2>> bodies_before,
                 const lod::FrameRecord<2>& record) {
    const double time = static_cast<double>(run.instants.size()) * run.time_step;
    run.instants.push_back({time, std::move(bodies_before), record});
}

Point carried(const lod::Body<2>& body, Point local) {
    const lod::Vector<2> world = body.position + lod::Space<2>::rotation(body.orientation) *
                                                     lod::Vector<2>(local.x, local.y);
    return {world.x(), world.y()};
}

std::vector<Ring> carried(const lod::Body<2>& body, const std::vector<Ring>& rings) {
    std::vector<Ring> world = rings;
    for (Ring& ring : world)
        for (Point& p : ring) p = carried(body, p);
    return world;
}

lod::Sphere<2> carried_node(const lod::Body<2>& body, int node) {
    const lod::Sphere<2> local = body.tree->sphere(node);
    const lod::Vector<2> centre =
        body.position + lod::Space<2>::rotation(body.orientation) * local.centre;
    return {centre, local.radius};
}

Box bounds(const std::vector<Look>& looks, const std::vector<lod::Body<2>>& bodies) {
    Box box{{far_away, far_away}, {-far_away, -far_away}};
    for (std::size_t i = 0; i < bodies.size(); ++i)
        take_in(box, i < looks.size() ? looks[i] : Look{}, bodies[i]);
    return box;
}

Box box_of(const lod::Sphere<2>& ball) {
    const double x = ball.centre.x();
    const double y = ball.centre.y();
    return {{x - ball.radius, y - ball.radius}, {x + ball.radius, y + ball.radius}};
}

Box united(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

Box grown(const Box& box, double share) {
    const double by = share * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

int first_impact(const Run& run) {
    for (std::size_t i = 0; i < run.instants.size(); ++i) {
        const std::vector<double>& impulses = run.instants[i].record.impulses;
        const bool pushed = std::any_of(impulses.begin(), impulses.end(),
                                        [](double impulse) { return impulse > 0; });
        if (pushed) return static_cast<int>(i);
    }
    return -1;
}

}  // namespace viz
