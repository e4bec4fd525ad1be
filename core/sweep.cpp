#include "lodlab/core/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "lodlab/core/integrate.hpp"
#include "lodlab/core/schedule.hpp"
#include "lodlab/core/time_of_impact.hpp"

namespace lod {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double steps_of_thickness = 0.5;  ///< between two instants that are looked at
constexpr double most_instants = 65536;     ///< of two bodies that pass each other
constexpr int halvings = 40;                ///< until the moment of meeting is known to rounding

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

template <int Dim>
double reach_of_motion(const Body<Dim>& body, double h) {
    return body.is_static() ? 0 : h * (body.velocity.norm() + body.spin.norm() * body.tree->extent);
}

template <int Dim>
void Sweeper<Dim>::advance(std::span<Body<Dim>> bodies, double time_step,
                           const SweepSettings& settings, const Model& model,
                           std::vector<SweptImpact<Dim>>& found) {
    bodies_ = bodies;
    time_step_ = time_step;
    settings_ = settings;
    model_ = model;
    found.clear();
    meetings_.clear();
    now_.assign(bodies.size(), 0);
    measured_.resize(bodies.size(), nullptr);
    thickness_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (measured_[i] == bodies[i].tree.get()) continue;
        measured_[i] = bodies[i].tree.get();
        thickness_[i] = thickness(*bodies[i].tree);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (is_fast(i)) find_those_of(i);
    for (int impacts = 0; !meetings_.empty(); ++impacts) {
        if (impacts == settings.most_impacts) {
            leave_waiting();
            break;
        }
        const auto next = std::ranges::min_element(meetings_, [](const auto& x, const auto& y) {
            return std::tie(x.time, x.a, x.b) < std::tie(y.time, y.a, y.b);
        });
        const Meeting meeting = std::move(*next);
        answer(meeting, found);
        forget_those_of(meeting.a, meeting.b);
        for (const std::int32_t body : {meeting.a, meeting.b})
            if (is_fast(static_cast<std::size_t>(body)))
                find_those_of(static_cast<std::size_t>(body));
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        integrate(bodies.subspan(i, 1), time_step - now_[i]);
}

/// Whether it moves further than its thickness in the whole step.
template <int Dim>
bool Sweeper<Dim>::is_fast(std::size_t body) const {
    return reach_of_motion(bodies_[body], time_step_) > thickness_[body];
}

template <int Dim>
Body<Dim> Sweeper<Dim>::at_time(std::size_t body, double time) const {
    return moved_freely(bodies_[body], time - now_[body], time_step_);
}

/// When the balls that hold them overlap, in what is left of the step. Centres move on lines.
template <int Dim>
bool Sweeper<Dim>::may_meet(std::size_t a, std::size_t b, Span& span) const {
    if (bodies_[a].is_static() && bodies_[b].is_static()) return false;
    const double radius = bodies_[a].tree->extent + bodies_[b].tree->extent;
    span = {std::max(now_[a], now_[b]), time_step_};
    const Vector<Dim> velocity = bodies_[b].velocity - bodies_[a].velocity;
    const Vector<Dim> between = bodies_[b].position + (span.begin - now_[b]) * bodies_[b].velocity -
                                bodies_[a].position - (span.begin - now_[a]) * bodies_[a].velocity;
    const double speed = velocity.norm();
    const double length = span.end - span.begin;
    if (!(length > 0)) return false;
    if (!(speed * length > 0)) return between.norm() <= radius;
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
    // A half-space has no other side.
    if (measured_[a]->is_half_space() || measured_[b]->is_half_space()) return false;
    Span span;
    if (!may_meet(a, b, span)) return false;
    meeting.a = static_cast<std::int32_t>(a);
    meeting.b = static_cast<std::int32_t>(b);
    const bool exactly = settings_.exact && bodies_[a].exact && bodies_[b].exact;
    return exactly ? exact_meeting(span, meeting) : swept_meeting(span, meeting);
}

template <int Dim>
bool Sweeper<Dim>::exact_meeting(const Span& span, Meeting& meeting) const {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    const TimeOfImpact<Dim> impact = time_of_impact(at_time(a, span.begin), at_time(b, span.begin),
                                                    {.horizon = span.end - span.begin,
                                                     .tolerance = settings_.tolerance,
                                                     .longest_turn = time_step_});
    if (impact.outcome != ImpactOutcome::touching) return false;
    meeting.time = span.begin + impact.time;
    meeting.contacts = impact.contacts;
    return true;
}

template <int Dim>
bool Sweeper<Dim>::meet_at(const Meeting& pair, double time, double step) {
    const Body<Dim> a = at_time(static_cast<std::size_t>(pair.a), time);
    const Body<Dim> b = at_time(static_cast<std::size_t>(pair.b), time);
    posed_a_.pose(a);
    posed_b_.pose(b);
    list_.clear();
    ListedFront front;
    test_roots(posed_a_, posed_b_, front, list_);
    const bool by_hulls = model_.contact_model == ContactModel::hull;
    const int deepest =
        std::max(settings_.deepest_level, entry_level(posed_a_, posed_b_, by_hulls));
    Budget enough = Budget::unlimited();
    while (front.level < deepest && !front.finest && front.pairs.count > 0)
        if (refine(posed_a_, posed_b_, enough, front, list_) == Refinement::interrupted) break;
    front_contacts_.model(posed_a_, posed_b_, list_.pairs_of(front), model_.contact_model,
                          model_.point_model, pair_motion(a, b, step), front_);
    return !front_.node_pairs.empty();
}

template <int Dim>
bool Sweeper<Dim>::swept_meeting(const Span& span, Meeting& meeting) {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    const double length = span.end - span.begin;
    const double way = length * (bodies_[b].velocity - bodies_[a].velocity).norm() +
                       length * (bodies_[a].spin.norm() * bodies_[a].tree->extent +
                                 bodies_[b].spin.norm() * bodies_[b].tree->extent);
    const double stride = steps_of_thickness * std::min(thickness_[a], thickness_[b]);
    const double instants = std::clamp(std::ceil(way / stride), 1.0, most_instants);
    const double step = length / instants;
    bool before = meet_at(meeting, span.begin, step);
    for (double instant = 1; instant <= instants; ++instant) {
        const double time = instant < instants ? span.begin + instant * step : span.end;
        const bool then = meet_at(meeting, time, step);
        if (before || !then) {
            before = then;
            continue;
        }
        double free = time - step;
        meeting.time = time;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (free + meeting.time);
            if (!(middle > free && middle < meeting.time)) break;
            (meet_at(meeting, middle, step) ? meeting.time : free) = middle;
        }
        before = meet_at(meeting, meeting.time, step);
        if (front_.contacts.empty()) continue;  // they meet, and part
        for (const auto& [contact, nodes] : front_.contacts) meeting.contacts.push_back(contact);
        return true;
    }
    return false;
}

template <int Dim>
void Sweeper<Dim>::forget_those_of(std::int32_t a, std::int32_t b) {
    std::erase_if(meetings_,
                  [&](const Meeting& m) { return m.a == a || m.b == a || m.a == b || m.b == b; });
}

/// The next meetings of a body with all others, but for pairs that are listed.
template <int Dim>
void Sweeper<Dim>::find_those_of(std::size_t body) {
    for (std::size_t other = 0; other < bodies_.size(); ++other) {
        if (other == body) continue;
        const auto [a, b] = std::minmax(body, other);
        const bool listed = std::ranges::any_of(meetings_, [a = a, b = b](const Meeting& m) {
            return static_cast<std::size_t>(m.a) == a && static_cast<std::size_t>(m.b) == b;
        });
        Meeting meeting;
        if (!listed && next_meeting(a, b, meeting)) meetings_.push_back(std::move(meeting));
    }
}

template <int Dim>
void Sweeper<Dim>::answer(const Meeting& meeting, std::vector<SweptImpact<Dim>>& found) {
    const auto a = static_cast<std::size_t>(meeting.a);
    const auto b = static_cast<std::size_t>(meeting.b);
    std::array<Body<Dim>, 2> two{at_time(a, meeting.time), at_time(b, meeting.time)};
    impacts_.clear();
    for (const Contact<Dim>& contact : meeting.contacts) impacts_.push_back({0, 1, 0, contact});
    impulses_.assign(impacts_.size(), 0);
    resolver_.resolve(model_.response, impacts_, two, impulses_);
    for (std::size_t i = 0; i < impacts_.size(); ++i)
        found.push_back({meeting.a, meeting.b, meeting.time, meeting.contacts[i], impulses_[i]});
    bodies_[a] = std::move(two[0]);
    bodies_[b] = std::move(two[1]);
    now_[a] = now_[b] = meeting.time;
}

/// Every body that would meet another goes no further than there.
template <int Dim>
void Sweeper<Dim>::leave_waiting() {
    std::ranges::sort(meetings_, {}, &Meeting::time);
    for (const Meeting& meeting : meetings_)
        for (const std::int32_t body : {meeting.a, meeting.b}) {
            const auto i = static_cast<std::size_t>(body);
            if (now_[i] == time_step_) continue;
            bodies_[i] = at_time(i, std::max(now_[i], meeting.time));
            now_[i] = time_step_;
        }
}

#define LOD_INSTANTIATE(Dim)                                   \
    template double thickness(const SphereTree<Dim>&);         \
    template double reach_of_motion(const Body<Dim>&, double); \
    template class Sweeper<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
