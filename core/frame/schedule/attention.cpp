#include "lodlab/core/frame/schedule/attention.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// A point of the plane lies at z = 0.
template <int Dim>
Vector<3> in_space(const Vector<Dim>& point) {
    Vector<3> result = Vector<3>::Zero();
    for (int axis = 0; axis < Dim; ++axis) result[axis] = point[axis];
    return result;
}

Vector<3> in_space(const Viewer::Point& point) {
    return {point[0], point[1], point[2]};
}

}  // namespace

template <int Dim>
double closing_speed(const Body<Dim>& a, const Body<Dim>& b) {
    const Vector<Dim> line = b.position - a.position;
    const double length = line.norm();
    return length > 0 ? line.dot(a.velocity - b.velocity) / length : 0;
}

template <int Dim>
void Attention<Dim>::weigh(const Viewer& viewer, std::span<const Body<Dim>> bodies,
                           std::span<const CandidatePair> pairs, std::vector<double>& attention) {
    look_from(viewer);
    deal(bodies);
    attention.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        attention[i] = of_pair(viewer, bodies[at(pairs[i].a)], bodies[at(pairs[i].b)], pairs[i]);
}

template <int Dim>
void Attention<Dim>::look_from(const Viewer& viewer) {
    const Point fixation = in_space(viewer.fixation);
    eye_ = viewer.eye ? in_space(*viewer.eye) : Point(fixation + viewer.distance * Point::Unit(2));
    ahead_ = fixation - eye_;
    if (!(ahead_.norm() > 0)) ahead_ = -Point::Unit(2);
    ahead_ = ahead_.normalized();
    // The axis that is least along the line of sight is up.
    int axis = 1;
    for (const int other : {2, 0})
        if (std::abs(ahead_[other]) < std::abs(ahead_[axis])) axis = other;
    right_ = ahead_.cross(Point::Unit(axis)).normalized();
    up_ = right_.cross(ahead_);
    cell_size_ = viewer.half_sensitivity;
}

template <int Dim>
typename Attention<Dim>::Seen Attention<Dim>::seen(const Vector<Dim>& point, double radius) const {
    const Point from_eye = in_space<Dim>(point) - eye_;
    const double depth = from_eye.dot(ahead_);
    if (!(depth > 0)) return {0, 0, depth, radius};
    return {from_eye.dot(right_) / depth, from_eye.dot(up_) / depth, depth, radius};
}

template <int Dim>
std::size_t Attention<Dim>::cell_of(const Seen& seen) const {
    const auto place = [this](double tangent) {
        const double cell = tangent / cell_size_ + 0.5 * cells_a_side;
        if (!(cell > 0)) return 0;
        return cell < cells_a_side ? static_cast<int>(cell) : cells_a_side - 1;
    };
    return at(place(seen.up) * cells_a_side + place(seen.across));
}

template <int Dim>
void Attention<Dim>::deal(std::span<const Body<Dim>> bodies) {
    seen_.resize(bodies.size());
    refill(cells_, at(cells_a_side * cells_a_side), Cell());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body<Dim>& body = bodies[i];
        seen_[i] = seen(body.position, body.tree->radius[0]);
        if (body.tree->is_half_space() || !(seen_[i].depth > 0)) continue;
        Cell& cell = cells_[cell_of(seen_[i])];
        ++cell.bodies;
        if (cell.nearest < 0 || seen_[i].depth < seen_[at(cell.nearest)].depth)
            cell.nearest = static_cast<std::int32_t>(i);
    }
}

template <int Dim>
double Attention<Dim>::of_pair(const Viewer& viewer, const Body<Dim>& a, const Body<Dim>& b,
                               const CandidatePair& pair) const {
    // A half-space is met where the other body is.
    const Vector<Dim> at_a = a.tree->is_half_space() ? b.position : a.position;
    const Vector<Dim> at_b = b.tree->is_half_space() ? a.position : b.position;
    const double radius_a = a.tree->is_half_space() ? b.tree->radius[0] : a.tree->radius[0];
    const double radius_b = b.tree->is_half_space() ? a.tree->radius[0] : b.tree->radius[0];
    const Seen middle = seen(0.5 * (at_a + at_b), (std::min)(radius_a, radius_b));
    if (!(middle.depth > 0)) return 0;
    const double angle = std::sqrt(middle.across * middle.across + middle.up * middle.up);
    const double speed = std::abs(closing_speed(a, b));
    double attention = middle.radius / middle.depth;
    attention *= 1 + speed / viewer.speed;
    attention /= 1 + angle / viewer.half_sensitivity;
    const std::int32_t others = (std::max)(0, cells_[cell_of(middle)].bodies - 2);
    attention /= 1 + viewer.distractor * others;
    return is_hidden(middle, pair) ? viewer.behind_another * attention : attention;
}

template <int Dim>
bool Attention<Dim>::is_hidden(const Seen& middle, const CandidatePair& pair) const {
    const std::int32_t nearest = cells_[cell_of(middle)].nearest;
    if (nearest < 0 || nearest == pair.a || nearest == pair.b) return false;
    const Seen& screen = seen_[at(nearest)];
    if (screen.depth + screen.radius > middle.depth - middle.radius) return false;
    const double across = middle.across - screen.across;
    const double up = middle.up - screen.up;
    const double reach = screen.radius / screen.depth;
    return across * across + up * up < reach * reach;
}

#define LOD_INSTANTIATE(Dim)                                           \
    template double closing_speed(const Body<Dim>&, const Body<Dim>&); \
    template class Attention<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
