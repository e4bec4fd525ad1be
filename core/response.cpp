#include "lodlab/core/response.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lodlab/core/newton.hpp"

namespace lod {
namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

template <int Dim>
void Resolver<Dim>::resolve(Response response, Impacts impacts, Bodies bodies, Impulses& impulses) {
    rounds_ = 0;
    impulses.assign(impacts.size(), 0.0);
    if (impacts.empty()) return;
    inverse_inertia_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        inverse_inertia_[i] = world_inverse_inertia(bodies[i]);
    direction_.resize(impacts.size());
    push_.resize(bodies.size());
    marked_.resize(bodies.size(), 0);
    switch (response) {
        case Response::sum:
            return resolve_independently(false, impacts, bodies, impulses);
        case Response::mean:
            return resolve_independently(true, impacts, bodies, impulses);
        default:
            break;
    }
    find_islands(impacts, bodies);
    for (const Island& island : islands_) {
        const double fastest = fastest_approach(island, impacts, bodies);
        if (fastest <= 0) continue;
        const double threshold = settled_share * fastest;
        switch (response) {
            case Response::sequential:
                sequential_sweeps(island, threshold, impacts, bodies, impulses);
                break;
            case Response::lcp:
                resolve_lcp(island, impacts, bodies, impulses);
                break;
            case Response::reflections:
                resolve_reflections(island, threshold, impacts, bodies, impulses);
                break;
            default:
                resolve_net(island, threshold, impacts, bodies, impulses);
                break;
        }
    }
}

template <int Dim>
void Resolver<Dim>::find_islands(Impacts impacts, std::span<const Body<Dim>> bodies) {
    root_.resize(bodies.size());
    std::iota(root_.begin(), root_.end(), 0);
    const auto find = [&](std::int32_t body) {
        while (root_[at(body)] != body) body = root_[at(body)] = root_[at(root_[at(body)])];
        return body;
    };
    for (const Impact<Dim>& impact : impacts) {
        if (bodies[at(impact.a)].is_static() || bodies[at(impact.b)].is_static()) continue;
        const std::int32_t a = find(impact.a);
        const std::int32_t b = find(impact.b);
        root_[at(std::max(a, b))] = std::min(a, b);
    }
    // An island is named by its first moving body, so the order does not depend on the contacts'.
    const auto island_of = [&](std::int32_t contact) {
        const Impact<Dim>& impact = impacts[at(contact)];
        return find(bodies[at(impact.a)].is_static() ? impact.b : impact.a);
    };
    order_.resize(impacts.size());
    std::iota(order_.begin(), order_.end(), 0);
    const auto before = [&](std::int32_t x, std::int32_t y) {
        const std::int32_t island_x = island_of(x);
        const std::int32_t island_y = island_of(y);
        return island_x != island_y ? island_x < island_y : x < y;
    };
    // Contacts of one collision stand together already, however many: then time stays linear.
    if (!std::is_sorted(order_.begin(), order_.end(), before))
        std::sort(order_.begin(), order_.end(), before);
    islands_.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(order_.size()); ++i) {
        if (i == 0 || island_of(order_[at(i)]) != island_of(order_[at(i - 1)]))
            islands_.push_back({i, 0});
        ++islands_.back().count;
    }
}

template <int Dim>
double Resolver<Dim>::fastest_approach(const Island& island, Impacts impacts,
                                       std::span<const Body<Dim>> bodies) const {
    double fastest = 0;
    for (std::int32_t contact : contacts_of(island)) {
        const Impact<Dim>& impact = impacts[at(contact)];
        fastest = std::max(
            fastest, -closing_velocity(bodies[at(impact.a)], bodies[at(impact.b)], impact.contact));
    }
    return fastest;
}

template <int Dim>
double Resolver<Dim>::newton_tolerance(const Island& island, Impacts impacts,
                                       std::span<const Body<Dim>> bodies) const {
    double fastest = 0;
    for (std::int32_t contact : contacts_of(island)) {
        const Impact<Dim>& impact = impacts[at(contact)];
        for (const std::int32_t body : {impact.a, impact.b}) {
            const Vector<Dim> r = impact.contact.point - bodies[at(body)].position;
            fastest = std::max(fastest, velocity_at<Dim>(bodies[at(body)], r).norm());
        }
    }
    return newton_share * fastest;
}

template <int Dim>
void Resolver<Dim>::resolve_net(const Island& island, double threshold, Impacts impacts,
                                Bodies bodies, Impulses& impulses) {
    int round = 0;
    while (round < most_net_rounds && net_round(island, threshold, impacts, bodies, impulses))
        ++round;
    rounds_ = std::max(rounds_, round);
    if (round == most_net_rounds) sequential_sweeps(island, threshold, impacts, bodies, impulses);
}

template <int Dim>
void Resolver<Dim>::resolve_lcp(const Island& island, Impacts impacts, Bodies bodies,
                                Impulses& impulses) {
    target_.resize(impacts.size());
    for (std::int32_t contact : contacts_of(island)) {
        const auto& [a, b, pair, touch] = impacts[at(contact)];
        const double u = closing_velocity(bodies[at(a)], bodies[at(b)], touch);
        target_[at(contact)] = -pair_restitution(bodies[at(a)], bodies[at(b)]) * u;
    }
    rounds_ = std::max(
        rounds_, solve_newton<Dim>(contacts_of(island), impacts, inverse_inertia_, target_,
                                   newton_tolerance(island, impacts, bodies), bodies, impulses));
}

template <int Dim>
void Resolver<Dim>::resolve_reflections(const Island& island, double threshold, Impacts impacts,
                                        Bodies bodies, Impulses& impulses) {
    target_.assign(impacts.size(), 0.0);
    for (int round = 0; round < most_reflections; ++round) {
        violated_.clear();
        for (std::int32_t contact : contacts_of(island)) {
            const auto& [a, b, pair, touch] = impacts[at(contact)];
            if (closing_velocity(bodies[at(a)], bodies[at(b)], touch) < -threshold)
                violated_.push_back(contact);
        }
        if (violated_.empty()) return;
        rounds_ = std::max(rounds_, round + 1);
        // Onto the border of what is allowed, and e times as far beyond: a reflection at e = 1.
        solve_newton<Dim>(violated_, impacts, inverse_inertia_, target_,
                          newton_tolerance(island, impacts, bodies), bodies, direction_);
        for (std::int32_t contact : violated_) {
            const auto& [a, b, pair, touch] = impacts[at(contact)];
            Body<Dim>& body_a = bodies[at(a)];
            Body<Dim>& body_b = bodies[at(b)];
            const double beyond = pair_restitution(body_a, body_b) * direction_[at(contact)];
            apply_impulse(body_a, inverse_inertia_[at(a)], body_b, inverse_inertia_[at(b)], touch,
                          beyond);
            impulses[at(contact)] += direction_[at(contact)] + beyond;
        }
    }
}

/// Returns false when no contact of the island approaches any more.
template <int Dim>
bool Resolver<Dim>::net_round(const Island& island, double threshold, Impacts impacts,
                              Bodies bodies, Impulses& impulses) {
    const auto contacts = contacts_of(island);
    for (std::int32_t contact : contacts) {
        push_[at(impacts[at(contact)].a)] = {Vector<Dim>::Zero(), Spin<Dim>::Zero()};
        push_[at(impacts[at(contact)].b)] = {Vector<Dim>::Zero(), Spin<Dim>::Zero()};
    }
    double work = 0;  // -(1 + e)(d.u), summed with each contact's own e
    for (std::int32_t contact : contacts) {
        const auto& [a, b, pair, touch] = impacts[at(contact)];
        const Body<Dim>& body_a = bodies[at(a)];
        const Body<Dim>& body_b = bodies[at(b)];
        direction_[at(contact)] = 0;
        const double u = closing_velocity(body_a, body_b, touch);
        if (u >= -threshold) continue;
        const Vector<Dim> r_a = touch.point - body_a.position;
        const Vector<Dim> r_b = touch.point - body_b.position;
        const double K = inverse_effective_mass(body_a, inverse_inertia_[at(a)], body_b,
                                                inverse_inertia_[at(b)], touch);
        if (K == 0) continue;
        const double d = -u / K;
        direction_[at(contact)] = d;
        work += (1 + pair_restitution(body_a, body_b)) * d * -u;
        push_[at(a)].linear -= d * touch.normal;
        push_[at(a)].angular -= d * Space<Dim>::moment(r_a, touch.normal);
        push_[at(b)].linear += d * touch.normal;
        push_[at(b)].angular += d * Space<Dim>::moment(r_b, touch.normal);
    }
    if (work <= 0) return false;
    // d^T A d from the net pushes, each body once: a body is marked by the round it was counted in.
    const auto each_body_once = [&](auto&& visit) {
        ++mark_;
        for (std::int32_t contact : contacts)
            for (std::int32_t body : {impacts[at(contact)].a, impacts[at(contact)].b})
                if (std::exchange(marked_[at(body)], mark_) != mark_) visit(at(body));
    };
    double dAd = 0;
    each_body_once([&](std::size_t i) {
        dAd += bodies[i].inverse_mass * push_[i].linear.squaredNorm() +
               push_[i].angular.dot(inverse_inertia_[i] * push_[i].angular);
    });
    if (dAd <= 0) return false;
    const double s = work / dAd;
    each_body_once([&](std::size_t i) {
        bodies[i].velocity += bodies[i].inverse_mass * (s * push_[i].linear);
        bodies[i].spin += inverse_inertia_[i] * (s * push_[i].angular);
    });
    for (std::int32_t contact : contacts) impulses[at(contact)] += s * direction_[at(contact)];
    return true;
}

template <int Dim>
void Resolver<Dim>::sequential_sweeps(const Island& island, double threshold, Impacts impacts,
                                      Bodies bodies, Impulses& impulses) {
    for (int sweep = 0; sweep < most_sequential_sweeps; ++sweep) {
        bool approaching = false;
        for (std::int32_t contact : contacts_of(island)) {
            const auto& [a, b, pair, touch] = impacts[at(contact)];
            if (closing_velocity(bodies[at(a)], bodies[at(b)], touch) >= -threshold) continue;
            const double j = single_impulse(bodies[at(a)], bodies[at(b)], touch);
            apply_impulse(bodies[at(a)], bodies[at(b)], touch, j);
            impulses[at(contact)] += j;
            approaching = true;
        }
        if (!approaching) return;
    }
}

template <int Dim>
void Resolver<Dim>::resolve_independently(bool mean, Impacts impacts, Bodies bodies,
                                          Impulses& impulses) {
    // All impulses from the velocities before the first of them is applied.
    for (std::size_t i = 0; i < impacts.size(); ++i)
        impulses[i] =
            single_impulse(bodies[at(impacts[i].a)], bodies[at(impacts[i].b)], impacts[i].contact);
    for (std::size_t first = 0; first < impacts.size();) {
        std::size_t end = first;
        int approaching = 0;
        for (; end < impacts.size() && impacts[end].pair == impacts[first].pair; ++end)
            approaching += impulses[end] > 0;
        for (; first < end; ++first) {
            if (mean && approaching > 0) impulses[first] /= approaching;
            apply_impulse(bodies[at(impacts[first].a)], bodies[at(impacts[first].b)],
                          impacts[first].contact, impulses[first]);
        }
    }
}

template class Resolver<2>;
template class Resolver<3>;

}  // namespace lod
