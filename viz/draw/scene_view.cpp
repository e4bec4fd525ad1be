#include "lodlab/viz/draw/scene_view.hpp"

#include <algorithm>
#include <utility>

#include "lodlab/viz/draw/surface.hpp"

namespace viz {

Visual<2> visual_of(const lod2d::Shape& shape) {
    Visual<2> visual{shape.name, {}};
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        visual.outline.emplace_back();
        for (const lod2d::Point& p : ring) visual.outline.back().push_back({p.x(), p.y()});
    }
    return visual;
}

Visual<3> visual_of(const lod3d::Solid& solid) {
    return {solid.name, std::make_shared<const Surface>(surface_of(solid.mesh))};
}

template <int Dim>
void add_instant(Run<Dim>& run, std::vector<lod::Body<Dim>> bodies_before,
                 const lod::FrameRecord<Dim>& record) {
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

template <int Dim>
lod::Sphere<Dim> carried_node(const lod::Body<Dim>& body, int node) {
    const lod::Sphere<Dim> local = body.tree->sphere(node);
    const lod::Vector<Dim> centre =
        body.position + lod::Space<Dim>::rotation(body.orientation) * local.centre;
    return {centre, local.radius};
}

template <int Dim>
void take_in(View<Dim>& view, const Actor<Dim>& actor) {
    const lod::Body<Dim>& body = actor.body;
    if (body.tree && body.tree->is_half_space()) return;  // it is everywhere
    const lod::Matrix<Dim> R = lod::Space<Dim>::rotation(body.orientation);
    for (const lod::Vector<Dim>& p : DrawTraits<Dim>::points_of(actor.visual.outline))
        view.take_in(body.position + R * p, 0);
    if (DrawTraits<Dim>::shown(actor.visual.outline) || !body.tree) return;
    for (int node = 0; node < body.tree->size(); ++node)
        if (body.tree->is_leaf(node)) take_in<Dim>(view, carried_node(body, node));
}

template <int Dim>
void take_in(View<Dim>& view, const lod::Sphere<Dim>& ball) {
    view.take_in(ball.centre, ball.radius);
}

template <int Dim>
void take_in(View<Dim>& view, const Run<Dim>& run, std::size_t until) {
    for (std::size_t i = 0; i <= until; ++i) {
        const auto& bodies = run.instants[i].bodies;
        for (std::size_t b = 0; b < bodies.size(); ++b)
            take_in<Dim>(view, Actor<Dim>{visual_at(run, b), bodies[b]});
    }
}

Box united(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

Box grown(const Box& box, double share) {
    const double by = share * longer_side(box);
    return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

double longer_side(const Box& box) {
    return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

template <int Dim>
int first_impact(const Run<Dim>& run) {
    for (std::size_t i = 0; i < run.instants.size(); ++i) {
        const std::vector<double>& impulses = run.instants[i].record.impulses;
        const bool pushed = std::any_of(impulses.begin(), impulses.end(),
                                        [](double impulse) { return impulse > 0; });
        if (pushed) return static_cast<int>(i);
    }
    return -1;
}

template <int Dim>
lod::Vector<Dim> way_between(const lod::Body<Dim>& a, const lod::Body<Dim>& b) {
    return b.position - a.position;
}

template <int Dim>
lod::Vector<Dim> way_of(const Run<Dim>& run) {
    const auto& bodies = run.instants.front().bodies;
    if (bodies.size() < 2) return lod::Vector<Dim>::Zero();
    const lod::Vector<Dim> approach = bodies[0].velocity - bodies[1].velocity;
    return bodies.size() == 2 && approach.norm() > 0 ? approach : way_between(bodies[0], bodies[1]);
}

template void add_instant<2>(Run<2>&, std::vector<lod::Body<2>>, const lod::FrameRecord<2>&);
template void add_instant<3>(Run<3>&, std::vector<lod::Body<3>>, const lod::FrameRecord<3>&);
template lod::Sphere<2> carried_node<2>(const lod::Body<2>&, int);
template lod::Sphere<3> carried_node<3>(const lod::Body<3>&, int);
template void take_in<2>(FlatView&, const Actor<2>&);
template void take_in<3>(SpaceView&, const Actor<3>&);
template void take_in<2>(FlatView&, const lod::Sphere<2>&);
template void take_in<3>(SpaceView&, const lod::Sphere<3>&);
template void take_in<2>(FlatView&, const Run<2>&, std::size_t);
template void take_in<3>(SpaceView&, const Run<3>&, std::size_t);
template int first_impact<2>(const Run<2>&);
template int first_impact<3>(const Run<3>&);
template lod::Vector<2> way_between<2>(const lod::Body<2>&, const lod::Body<2>&);
template lod::Vector<3> way_between<3>(const lod::Body<3>&, const lod::Body<3>&);
template lod::Vector<2> way_of<2>(const Run<2>&);
template lod::Vector<3> way_of<3>(const Run<3>&);

}  // namespace viz
