#include "core/response.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lod {
namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

template <int Dim>
double pair_restitution(const Body<Dim>& a, const Body<Dim>& b) {
    return std::min(a.restitution, b.restitution);
}

/// What a unit impulse along n at arm r adds to the body's velocity there, along n.
template <int Dim>
double compliance(const Body<Dim>& body, const Inertia<Dim>& inverse_inertia, const Vector<Dim>& r,
                  const Vector<Dim>& n) {
    const Spin<Dim> turning = Space<Dim>::moment(r, n);
    return body.inverse_mass + turning.dot(inverse_inertia * turning);
}

template <int Dim>
void push(Body<Dim>& body, const Inertia<Dim>& inverse_inertia, const Vector<Dim>& impulse,
          const Spin<Dim>& moment) {
    body.velocity += body.inverse_mass * impulse;
    body.spin += inverse_inertia * moment;
}

}  // namespace

template <int Dim>
double closing_velocity(const Body<Dim>& a, const Body<Dim>& b, const Contact<Dim>& contact) {
    const Vector<Dim> r_a = contact.point - a.position;
    const Vector<Dim> r_b = contact.point - b.position;
    return contact.normal.dot(velocity_at(b, r_b) - velocity_at(a, r_a));
}

template <int Dim>
double inverse_effective_mass(const Body<Dim>& a, const Body<Dim>& b,
                              const Contact<Dim>& contact) {
    const Vector<Dim> r_a = contact.point - a.position;
    const Vector<Dim> r_b = contact.point - b.position;
    return compliance<Dim>(a, world_inverse_inertia(a), r_a, contact.normal) +
           compliance<Dim>(b, world_inverse_inertia(b), r_b, contact.normal);
}

template <int Dim>
double single_impulse(const Body<Dim>& a, const Body<Dim>& b, const Contact<Dim>& contact) {
    const double v_c = closing_velocity(a, b, contact);
    if (v_c >= 0) return 0;  // already parting
    const double K = inverse_effective_mass(a, b, contact);
    if (K == 0) return 0;  // neither can move
    return -(1 + pair_restitution(a, b)) * v_c / K;
}

template <int Dim>
void apply_impulse(Body<Dim>& a, Body<Dim>& b, const Contact<Dim>& contact, double j) {
    const Vector<Dim> impulse = j * contact.normal;
    const Vector<Dim> r_a = contact.point - a.position;
    const Vector<Dim> r_b = contact.point - b.position;
    push<Dim>(a, world_inverse_inertia(a), -impulse, -Space<Dim>::moment(r_a, impulse));
    push<Dim>(b, world_inverse_inertia(b), impulse, Space<Dim>::moment(r_b, impulse));
}

template <int Dim>
void Resolver<Dim>::resolve(Response response, std::span<const Impact<Dim>> impacts,
                            std::span<Body<Dim>> bodies, std::vector<double>& impulses) {
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
        case Response::net:
            find_islands(impacts, bodies);
            for (const Island& island : islands_) resolve_net(island, impacts, bodies, impulses);
            break;
        case Response::sum: resolve_independently(false, impacts, bodies, impulses); break;
        case Response::mean: resolve_independently(true, impacts, bodies, impulses); break;
    }
}

template <int Dim>
void Resolver<Dim>::find_islands(std::span<const Impact<Dim>> impacts,
                                 std::span<const Body<Dim>> bodies) {
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
    std::sort(order_.begin(), order_.end(), [&](std::int32_t x, std::int32_t y) {
        const std::int32_t island_x = island_of(x);
        const std::int32_t island_y = island_of(y);
        return island_x != island_y ? island_x < island_y : x < y;
    });
    islands_.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(order_.size()); ++i) {
        if (i == 0 || island_of(order_[at(i)]) != island_of(order_[at(i - 1)]))
            islands_.push_back({i, 0});
        ++islands_.back().count;
    }
}

template <int Dim>
void Resolver<Dim>::resolve_net(const Island& island, std::span<const Impact<Dim>> impacts,
                                std::span<Body<Dim>> bodies, std::vector<double>& impulses) {
    double fastest = 0;
    for (std::int32_t i = island.first; i < island.first + island.count; ++i) {
        const Impact<Dim>& impact = impacts[at(order_[at(i)])];
        fastest = std::max(fastest, -closing_velocity(bodies[at(impact.a)], bodies[at(impact.b)],
                                                      impact.contact));
    }
    if (fastest <= 0) return;
    const double threshold = settled_share * fastest;
    int round = 0;
    while (round < most_net_rounds && net_round(island, threshold, impacts, bodies, impulses))
        ++round;
    rounds_ = std::max(rounds_, round);
    if (round == most_net_rounds) sequential_sweeps(island, threshold, impacts, bodies, impulses);
}

/// Returns false when no contact of the island approaches any more.
template <int Dim>
bool Resolver<Dim>::net_round(const Island& island, double threshold,
                              std::span<const Impact<Dim>> impacts, std::span<Body<Dim>> bodies,
                              std::vector<double>& impulses) {
    const auto contacts = std::span(order_).subspan(at(island.first), at(island.count));
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
        const double K = compliance<Dim>(body_a, inverse_inertia_[at(a)], r_a, touch.normal) +
                         compliance<Dim>(body_b, inverse_inertia_[at(b)], r_b, touch.normal);
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
        push<Dim>(bodies[i], inverse_inertia_[i], s * push_[i].linear, s * push_[i].angular);
    });
    for (std::int32_t contact : contacts) impulses[at(contact)] += s * direction_[at(contact)];
    return true;
}

template <int Dim>
void Resolver<Dim>::sequential_sweeps(const Island& island, double threshold,
                                      std::span<const Impact<Dim>> impacts,
                                      std::span<Body<Dim>> bodies,
                                      std::vector<double>& impulses) {
    for (int sweep = 0; sweep < most_sequential_sweeps; ++sweep) {
        bool approaching = false;
        for (std::int32_t i = island.first; i < island.first + island.count; ++i) {
            const std::int32_t contact = order_[at(i)];
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
void Resolver<Dim>::resolve_independently(bool mean, std::span<const Impact<Dim>> impacts,
                                          std::span<Body<Dim>> bodies,
                                          std::vector<double>& impulses) {
    // All impulses from the velocities before the first of them is applied.
    for (std::size_t i = 0; i < impacts.size(); ++i)
        impulses[i] = single_impulse(bodies[at(impacts[i].a)], bodies[at(impacts[i].b)],
                                     impacts[i].contact);
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

#define LOD_INSTANTIATE(Dim)                                                                     \
    template double closing_velocity(const Body<Dim>&, const Body<Dim>&, const Contact<Dim>&);   \
    template double inverse_effective_mass(const Body<Dim>&, const Body<Dim>&,                   \
                                           const Contact<Dim>&);                                 \
    template double single_impulse(const Body<Dim>&, const Body<Dim>&, const Contact<Dim>&);     \
    template void apply_impulse(Body<Dim>&, Body<Dim>&, const Contact<Dim>&, double);            \
    template class Resolver<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
