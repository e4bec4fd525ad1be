#include "lodlab/measure/free_flight.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/core/frame/integrate.hpp"

namespace measure {
namespace {

/// A node pair that waits to be opened.
struct Waiting {
    double gap;  ///< largest on the way down
    std::int32_t a;
    std::int32_t b;
    int level;
    bool operator<(const Waiting& other) const { return gap > other.gap; }
};

/// The node's children, or itself where it has none.
template <int Dim>
std::pair<std::int32_t, std::int32_t> family(lod::PosedTree<Dim>& world, std::int32_t node) {
    const auto n = static_cast<std::size_t>(node);
    if (world.tree().is_leaf(node)) return {node, node + 1};
    return {world.tree().first_child[n], world.tree().first_child[n] + world.tree().child_count[n]};
}

}  // namespace

template <int Dim>
double clearance(lod::PosedTree<Dim>& a, lod::PosedTree<Dim>& b, int level) {
    const auto gap = [&](std::int32_t node_a, std::int32_t node_b) {
        const lod::Sphere<Dim> ball_a = a.sphere(node_a);
        const lod::Sphere<Dim> ball_b = b.sphere(node_b);
        return (ball_b.centre - ball_a.centre).norm() - ball_a.radius - ball_b.radius -
               a.rounding() - b.rounding();
    };
    std::priority_queue<Waiting> waiting;
    waiting.push({gap(0, 0), 0, 0, 0});
    for (;;) {
        const Waiting next = waiting.top();
        waiting.pop();
        const bool leaves = a.tree().is_leaf(next.a) && b.tree().is_leaf(next.b);
        if (next.level == level || leaves) return next.gap;
        const auto [first_a, end_a] = family(a, next.a);
        const auto [first_b, end_b] = family(b, next.b);
        for (std::int32_t i = first_a; i < end_a; ++i)
            for (std::int32_t k = first_b; k < end_b; ++k)
                waiting.push({std::max(next.gap, gap(i, k)), i, k, next.level + 1});
    }
}

template <int Dim>
double fastest_approach(const lod::Body<Dim>& a, double radius_a, const lod::Body<Dim>& b,
                        double radius_b) {
    // Spin may change, as angular momentum may not.
    const auto fastest_spin = [](const lod::Body<Dim>& body) {
        const lod::Matrix<Dim> R = lod::Space<Dim>::rotation(body.orientation);
        const lod::Spin<Dim> own =
            lod::Space<Dim>::carried_spin(lod::Matrix<Dim>(R.transpose()), body.spin);
        return std::max(own.norm(), body.inverse_inertia.norm() * (body.inertia * own).norm());
    };
    return (b.velocity - a.velocity).norm() + fastest_spin(a) * radius_a +
           fastest_spin(b) * radius_b;
}

template <int Dim>
FreeFlight<Dim>::FreeFlight(Moment<Dim> start, double step) : step_(step), now_(std::move(start)) {
    const auto radius = [](const lod::Body<Dim>& body) {
        return std::max(body.tree->extent, body.exact ? body.exact->radius() : 0.0);
    };
    const lod::Body<Dim>& a = now_.bodies[0];
    const lod::Body<Dim>& b = now_.bodies[1];
    speed_ = fastest_approach(a, radius(a), b, radius(b));
}

template <int Dim>
void FreeFlight<Dim>::step(std::int64_t frames) {
    for (std::int64_t i = 0; i < frames; ++i, ++now_.frame)
        lod::integrate(std::span(now_.bodies), step_);
}

/// Whole frames for which a gap surely lasts; one less, for rounding.
template <int Dim>
std::int64_t FreeFlight<Dim>::clear_frames(double gap) const {
    return static_cast<std::int64_t>(std::min(1e6, gap / (speed_ * step_))) - 1;
}

template <int Dim>
bool FreeFlight<Dim>::to_front(int level, double end) {
    for (; time() <= end;) {
        lod::check_interrupted();
        world_a_.pose(now_.bodies[0]);
        world_b_.pose(now_.bodies[1]);
        const std::int64_t clear = clear_frames(clearance(world_a_, world_b_, level));
        if (clear < 1) return true;
        step(clear);
    }
    return false;
}

template <int Dim>
bool FreeFlight<Dim>::to_near(double end) {
    for (; time() <= end;) {
        lod::check_interrupted();
        const std::int64_t clear =
            clear_frames(lod::separation(now_.bodies[0], now_.bodies[1]).distance);
        if (clear < 1) return true;
        step(clear);
    }
    return false;
}

#define MEASURE_INSTANTIATE(Dim)                                                           \
    template double clearance(lod::PosedTree<Dim>&, lod::PosedTree<Dim>&, int);            \
    template double fastest_approach(const lod::Body<Dim>&, double, const lod::Body<Dim>&, \
                                     double);                                              \
    template class FreeFlight<Dim>;
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
