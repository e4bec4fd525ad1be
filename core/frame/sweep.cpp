#include "lodlab/core/frame/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/broad/body_box.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/frame/integrate.hpp"
#include "lodlab/core/frame/schedule.hpp"

namespace lod {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double steps_of_thickness = 0.5;  ///< between two instants that are looked at
constexpr double most_instants = 65536;     ///< of two bodies that pass each other
constexpr double rounding_of_ways = 64 * std::numeric_limits<double>::epsilon();
constexpr int halvings = 40;  ///< until the moment of meeting is known to rounding

/// The least width across a face.
template <int Dim>
double width(const HullView<Dim>& hull) {
    double least = forever;
    for (std::size_t face = 0; face < hull.normals.size(); ++face) {
        double depth = 0;
        for (const Vector<Dim>& corner : hull.corners)
            depth = std::max(depth, hull.offsets[face] - hull.normals[face].dot(corner));
        least = std::min(least, depth);
    }
    return least;
}

}  // namespace

template <int Dim>
double thickness(const SphereTree<Dim>& tree) {
    if (tree.is_half_space()) return forever;
    double least = forever;
    if (!tree.has_hulls()) {
        for (const int node : tree.level_nodes(tree.levels() - 1))
            least = std::min(least, 2 * tree.radius[tree.index(node)]);
        return least;
    }
    for (const int node : tree.level_nodes(tree.hulls.entry_level))
        least = std::min(least, width(tree.hulls.of(tree.hulls.best(node))));
    return least;
}

namespace {

/// No point of the body is faster [m/s].
template <int Dim>
double fastest_point(const Body<Dim>& body) {
    return body.is_static() ? 0 : body.velocity.norm() + body.spin.norm() * body.tree->extent;
}

}  // namespace

template <int Dim>
double reach_of_motion(const Body<Dim>& body, double h) {
    return h * fastest_point(body);
}

template <int Dim>
void Sweeper<Dim>::advance(std::span<Body<Dim>> bodies, double time_step,
                           const SweepSettings& settings, const Model& model,
                           std::vector<SweptImpact<Dim>>& found) {
    settings_ = settings;
    model_ = model;
    found.clear();
    if (begin(bodies, time_step)) {
        const std::uint64_t before = ways_.steps();
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (is_fast(i)) find_those_of(i);
        for (Meeting meeting; meetings_.take_next(meeting); go_on(meeting))
            if (!hold(meeting)) answer(meeting, found);
        steps_ += ways_.steps() - before;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (held_[i] == 0 && now_[i] < time_step)
            integrate(bodies.subspan(i, 1), time_step - now_[i]);
}

/// Returns whether any body is fast.
template <int Dim>
bool Sweeper<Dim>::begin(std::span<Body<Dim>> bodies, double time_step) {
    bodies_ = bodies;
    time_step_ = time_step;
    meetings_.clear(bodies.size());
    half_spaces_.clear();
    steps_ = 0;
    ++round_;
    now_.assign(bodies.size(), 0);
    impacts_of_.assign(bodies.size(), 0);
    held_.assign(bodies.size(), 0);
    sought_in_.resize(bodies.size());
    measured_.resize(bodies.size());
    thickness_.resize(bodies.size());
    bool any = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (measured_[i] != bodies[i].tree) {
            measured_[i] = bodies[i].tree;
            thickness_[i] = thickness(*bodies[i].tree);
        }
        if (measured_[i]->is_half_space()) half_spaces_.push_back(i);
        any = any || is_fast(i);
    }
    if (!any) return false;
    way_boxes_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) way_boxes_.push_back(way_of(i));
    ways_.build(way_boxes_);
    return true;
}

/// The box of what the ball that holds a body sweeps in what is left of the step; a place of no
/// meaning for a half-space, which is near everything.
template <int Dim>
Box<Dim> Sweeper<Dim>::way_of(std::size_t body) const {
    const Body<Dim>& from = bodies_[body];
    Box<Dim> way(from.position, from.position);
    if (held_[body] == 0) way.hold(from.position + (time_step_ - now_[body]) * from.velocity);
    const double far = std::max(way.low.cwiseAbs().maxCoeff(), way.high.cwiseAbs().maxCoeff());
    const double extent = measured_[body]->extent;
    const auto half = Vector<Dim>::Constant(extent + rounding_of_ways * (far + extent));
    way = Box<Dim>(way.low - half, way.high + half);
    const Vector<Dim> origin = Vector<Dim>::Zero();
    return is_somewhere(way) ? way : Box<Dim>(origin, origin);
}

/// Whether it moves further than its thickness in the whole step.
template <int Dim>
bool Sweeper<Dim>::is_fast(std::size_t body) const {
    return held_[body] == 0 && reach_of_motion(bodies_[body], time_step_) > thickness_[body];
}

template <int Dim>
Body<Dim> Sweeper<Dim>::at_time(std::size_t body, double time) const {
    if (held_[body] != 0) return bodies_[body];
    return moved_freely(bodies_[body], time - now_[body], time_step_);
}

/// When the ball that holds a body reaches a half-space, in what is left of the step.
template <int Dim>
bool Sweeper<Dim>::may_meet_border(std::size_t body, std::size_t border, Span& span) const {
    if (measured_[body]->is_half_space()) return false;
    const Body<Dim>& wall = bodies_[border];
    const Vector<Dim> normal =
        Space<Dim>::rotation(wall.orientation) * *measured_[border]->half_space;
    const double height =
        normal.dot(at_time(body, span.begin).position - at_time(border, span.begin).position);
    const double gap = height - measured_[body]->extent;
    // A half-space that turns sweeps what it likes.
    const double speed = normal.dot(bodies_[body].velocity - wall.velocity);
    if (gap > 0 && wall.spin.norm() == 0) {
        if (speed >= 0) return false;
        span.begin += gap / -speed;
    }
    return span.begin < span.end;
}

/// When the balls that hold them overlap, in what is left of the step. Centres move on lines.
template <int Dim>
bool Sweeper<Dim>::may_meet(std::size_t a, std::size_t b, Span& span) const {
    if (bodies_[a].is_static() && bodies_[b].is_static()) return false;
    span = {std::max(now_[a], now_[b]), time_step_};
    if (!(span.begin < span.end)) return false;
    if (measured_[b]->is_half_space()) return may_meet_border(a, b, span);
    if (measured_[a]->is_half_space()) return may_meet_border(b, a, span);
    const auto velocity_of = [&](std::size_t body) {
        return held_[body] != 0 ? Vector<Dim>(Vector<Dim>::Zero()) : bodies_[body].velocity;
    };
    const auto position_of = [&](std::size_t body) {
        return Vector<Dim>(bodies_[body].position + (span.begin - now_[body]) * velocity_of(body));
    };
    const double radius = bodies_[a].tree->extent + bodies_[b].tree->extent;
    const Vector<Dim> velocity = velocity_of(b) - velocity_of(a);
    const Vector<Dim> between = position_of(b) - position_of(a);
    const double speed = velocity.norm();
    if (!(speed * (span.end - span.begin) > 0)) return between.norm() <= radius;
    const Vector<Dim> along = velocity / speed;
    const double nearest = -between.dot(along);  // how far on the way [m]
    const double aside = (between + nearest * along).norm();
    if (aside > radius) return false;
    const double half = std::sqrt((radius - aside) * (radius + aside));
    span.end = std::min(span.end, span.begin + (nearest + half) / speed);
    span.begin = std::max(span.begin, span.begin + (nearest - half) / speed);
    return span.begin < span.end;
}

template <int Dim>
bool Sweeper<Dim>::next_meeting(std::size_t a, std::size_t b, Meeting& meeting) {
    Span span;
    if (!may_meet(a, b, span)) return false;
    meeting.a = static_cast<std::int32_t>(a);
    meeting.b = static_cast<std::int32_t>(b);
    const bool with_border = measured_[a]->is_half_space() || measured_[b]->is_half_space();
    const bool held = held_[a] != 0 || held_[b] != 0;  // a place of its own, no motion
    const bool exactly = settings_.exact && bodies_[a].exact && bodies_[b].exact;
    if (!exactly || with_border || held) return swept_meeting(span, meeting);
    return exact_meeting(span, meeting);
}

template <int Dim>
bool Sweeper<Dim>::exact_meeting(const Span& span, Meeting& meeting) {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    TimeOfImpact<Dim> impact = time_of_impact(at_time(a, span.begin), at_time(b, span.begin),
                                              {.horizon = span.end - span.begin,
                                               .tolerance = settings_.tolerance,
                                               .longest_turn = time_step_});
    if (impact.outcome == ImpactOutcome::never) return false;
    // Bodies that overlap, or circle each other for too long, have no time of impact.
    if (impact.outcome != ImpactOutcome::touching) return swept_meeting(span, meeting);
    meeting.time = span.begin + impact.time;
    meeting.contacts = std::move(impact.contacts);
    meeting.body_a = std::move(impact.a);
    meeting.body_b = std::move(impact.b);
    return true;
}

template <int Dim>
bool Sweeper<Dim>::approach_at(Meeting& pair, double time, double step) {
    pair.time = time;
    pair.body_a = at_time(static_cast<std::size_t>(pair.a), time);
    pair.body_b = at_time(static_cast<std::size_t>(pair.b), time);
    posed_a_.pose(pair.body_a);
    posed_b_.pose(pair.body_b);
    list_.clear();
    ListedFront front;
    test_roots(posed_a_, posed_b_, front, list_);
    const bool by_hulls = model_.contact_model == ContactModel::hull;
    const int deepest =
        std::max(settings_.deepest_level, entry_level(posed_a_, posed_b_, by_hulls));
    Budget enough = Budget::unlimited();
    while (front.level < deepest && !front.finest && front.pairs.count > 0)
        if (refine(posed_a_, posed_b_, enough, front, list_) == Refinement::interrupted) break;
    front_contacts_.model({posed_a_, posed_b_, list_.pairs_of(front)},
                          {model_.contact_model, model_.point_model},
                          pair_motion(pair.body_a, pair.body_b, step), front_);
    const double settled =
        1e-9 * (fastest_point(pair.body_a) + fastest_point(pair.body_b));  // rounding of an answer
    return std::any_of(
        front_.contacts.begin(), front_.contacts.end(), [&](const PatchContact<Dim>& patch) {
            return closing_velocity(pair.body_a, pair.body_b, patch.contact) < -settled;
        });
}

template <int Dim>
bool Sweeper<Dim>::swept_meeting(const Span& span, Meeting& meeting) {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    const double length = span.end - span.begin;
    const auto turn =
        [&](std::size_t body) {  // a half-space has no extent, and no speed that counts
            return bodies_[body].tree->is_half_space()
                       ? 0
                       : bodies_[body].spin.norm() * bodies_[body].tree->extent;
        };
    const double way =
        length * ((bodies_[b].velocity - bodies_[a].velocity).norm() + turn(a) + turn(b));
    const double stride = steps_of_thickness * std::min(thickness_[a], thickness_[b]);
    const double instants = std::clamp(std::ceil(way / stride), 1.0, most_instants);
    const double step = length / instants;
    // What approaches at once is answered at once: an answer leaves nothing that approaches.
    if (approach_at(meeting, span.begin, step))
        return meet_between(span.begin, span.begin, step, meeting);
    for (double instant = 1; instant <= instants; ++instant) {
        const double time = instant < instants ? span.begin + instant * step : span.end;
        if (approach_at(meeting, time, step)) return meet_between(time - step, time, step, meeting);
    }
    // Balls that glance off each other only touch at the beginning and part from the middle on.
    const double early = span.begin + step / 4;
    return approach_at(meeting, early, step) && meet_between(span.begin, early, step, meeting);
}

/// The contacts of when the bodies of a meeting begin to approach and overlap: not yet at `free`,
/// but at `met`, unless both are the same. Returns true.
template <int Dim>
bool Sweeper<Dim>::meet_between(double free, double met, double step, Meeting& meeting) {
    for (int i = 0; free < met && i < halvings; ++i) {
        const double middle = 0.5 * (free + met);
        if (!(middle > free && middle < met)) break;
        (approach_at(meeting, middle, step) ? met : free) = middle;
    }
    static_cast<void>(approach_at(meeting, met, step));
    meeting.contacts.clear();
    for (const auto& [contact, nodes] : front_.contacts) meeting.contacts.push_back(contact);
    return true;
}

/// What follows for the two bodies of a meeting. A static one goes on as before.
template <int Dim>
void Sweeper<Dim>::go_on(const Meeting& meeting) {
    ++round_;
    const std::array two{at(meeting.a), at(meeting.b)};
    for (const std::size_t body : two) {
        if (bodies_[body].is_static()) continue;
        meetings_.change(body);
        ways_.grow(body, way_of(body));
    }
    for (const std::size_t body : two)
        if (!bodies_[body].is_static()) find_those_of(body);
}

template <int Dim>
void Sweeper<Dim>::list_near(std::size_t body) {
    near_ = half_spaces_;
    if (measured_[body]->is_half_space()) {
        near_.resize(bodies_.size());
        std::iota(near_.begin(), near_.end(), std::size_t{0});
        return;
    }
    ways_.each_meeting(way_of(body), [&](std::size_t other) {
        if (!measured_[other]->is_half_space()) near_.push_back(other);
    });
}

/// The next meetings of a body, with all others where it is fast, else with those that are; but for
/// those with a body that was sought for in this round.
template <int Dim>
void Sweeper<Dim>::find_those_of(std::size_t body) {
    const bool fast = is_fast(body);
    list_near(body);
    for (const std::size_t other : near_) {
        ++steps_;
        if (other == body || sought_in_[other] == round_ || !(fast || is_fast(other))) continue;
        const auto [a, b] = std::minmax(body, other);
        Meeting meeting;
        if (next_meeting(a, b, meeting)) meetings_.add(std::move(meeting));
    }
    sought_in_[body] = round_;
}

template <int Dim>
void Sweeper<Dim>::answer(Meeting& meeting, std::vector<SweptImpact<Dim>>& found) {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    std::array<Body<Dim>, 2> two{std::move(meeting.body_a), std::move(meeting.body_b)};
    impacts_.clear();
    for (const Contact<Dim>& contact : meeting.contacts) impacts_.push_back({0, 1, 0, contact});
    impulses_.assign(impacts_.size(), 0);
    resolver_.resolve(model_.response, impacts_, two, impulses_);
    for (std::size_t i = 0; i < impacts_.size(); ++i)
        found.push_back({meeting.a, meeting.b, meeting.time, meeting.contacts[i], impulses_[i]});
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? a : b;
        if (bodies_[body].is_static()) continue;
        bodies_[body] = std::move(two[i]);
        now_[body] = meeting.time;
        ++impacts_of_[body];
    }
}

/// Where a body that moves has had its impacts, leaves it there. Returns whether it did.
template <int Dim>
bool Sweeper<Dim>::hold(const Meeting& meeting) {
    bool holds = false;
    for (const std::int32_t body : {meeting.a, meeting.b}) {
        const auto i = static_cast<std::size_t>(body);
        if (bodies_[i].is_static() || held_[i] != 0 || impacts_of_[i] < settings_.most_impacts)
            continue;
        bodies_[i] = at_time(i, meeting.time);
        now_[i] = meeting.time;
        held_[i] = 1;
        holds = true;
    }
    return holds;
}

#define LOD_INSTANTIATE(Dim)                                   \
    template double thickness(const SphereTree<Dim>&);         \
    template double reach_of_motion(const Body<Dim>&, double); \
    template class Sweeper<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
