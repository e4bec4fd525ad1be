#include "lodlab/core/response/response.hpp"

#include <algorithm>
#include <numeric>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/response/gauss_seidel.hpp"

namespace lod {

template <int Dim>
ResponseReport Resolver<Dim>::resolve(Response response, Impacts impacts, Bodies bodies,
                                      Impulses& impulses, Executor* executor) {
    report_ = {};
    refill(impulses, impacts.size(), 0.0);
    if (impacts.empty()) return report_;
    if (response == Response::net) {
        net_.executor = executor;
        net_.budget = budget;
        return net_.resolve(impacts, bodies, impulses, most_visits);
    }
    inverse_inertia_.resize(bodies.size());
    each_part(executor, bodies.size(), bodies_of_a_part, [&](const Part& part) {
        for (std::size_t i = part.begin; i < part.end; ++i)
            inverse_inertia_[i] = world_inverse_inertia(bodies[i]);
    });
    switch (response) {
        case Response::sum:
            resolve_independently(false, impacts, bodies, impulses);
            break;
        case Response::mean:
            resolve_independently(true, impacts, bodies, impulses);
            break;
        default:
            resolve_islands(response, impacts, bodies, impulses);
            break;
    }
    return report_;
}

template <int Dim>
void Resolver<Dim>::resolve_islands(Response response, Impacts impacts, Bodies bodies,
                                    Impulses& impulses) {
    refill(target_, impacts.size(), 0.0);
    part_.resize(impacts.size());
    find_islands(impacts, bodies);
    for (const Island& island : islands_) {
        const double fastest = fastest_approach(island, impacts, bodies);
        if (fastest <= 0) continue;
        const double threshold = settled_share * fastest;
        if (response == Response::sequential)
            sequential_sweeps(island, threshold, impacts, bodies, impulses);
        else if (response == Response::lcp)
            resolve_lcp(island, impacts, bodies, impulses);
        else
            resolve_reflections(island, threshold, impacts, bodies, impulses);
        for (const std::int32_t contact : contacts_of(island)) {
            const Impact<Dim>& impact = impacts[at(contact)];
            const double speed =
                -closing_velocity(bodies[at(impact.a)], bodies[at(impact.b)], impact.contact);
            if (speed <= threshold) continue;
            ++report_.approaching;
            report_.fastest = std::max(report_.fastest, speed);
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
double Resolver<Dim>::gauss_seidel_tolerance(const Island& island, Impacts impacts,
                                             std::span<const Body<Dim>> bodies) const {
    double fastest = 0;
    for (std::int32_t contact : contacts_of(island)) {
        const Impact<Dim>& impact = impacts[at(contact)];
        for (const std::int32_t body : {impact.a, impact.b}) {
            const Vector<Dim> r = impact.contact.point - bodies[at(body)].position;
            fastest = std::max(fastest, velocity_at<Dim>(bodies[at(body)], r).norm());
        }
    }
    return gauss_seidel_share * fastest;
}

template <int Dim>
void Resolver<Dim>::resolve_lcp(const Island& island, Impacts impacts, Bodies bodies,
                                Impulses& impulses) {
    for (std::int32_t contact : contacts_of(island)) {
        const auto& [a, b, pair, touch] = impacts[at(contact)];
        const double u = closing_velocity(bodies[at(a)], bodies[at(b)], touch);
        target_[at(contact)] = -pair_restitution(bodies[at(a)], bodies[at(b)]) * u;
    }
    report_.most_visits = std::max(
        report_.most_visits,
        solve_by_gauss_seidel<Dim>({contacts_of(island), impacts, inverse_inertia_, target_,
                                    gauss_seidel_tolerance(island, impacts, bodies)},
                                   bodies, impulses));
}

template <int Dim>
void Resolver<Dim>::resolve_reflections(const Island& island, double threshold, Impacts impacts,
                                        Bodies bodies, Impulses& impulses) {
    for (int round = 0; round < most_reflections; ++round) {
        violated_.clear();
        for (std::int32_t contact : contacts_of(island)) {
            const auto& [a, b, pair, touch] = impacts[at(contact)];
            if (closing_velocity(bodies[at(a)], bodies[at(b)], touch) < -threshold)
                violated_.push_back(contact);
        }
        if (violated_.empty()) return;
        report_.most_visits = std::max(report_.most_visits, round + 1);
        // Onto the border of what is allowed, and e times as far beyond: a reflection at e = 1.
        solve_by_gauss_seidel<Dim>({violated_, impacts, inverse_inertia_, target_,
                                    gauss_seidel_tolerance(island, impacts, bodies)},
                                   bodies, part_);
        for (std::int32_t contact : violated_) {
            const auto& [a, b, pair, touch] = impacts[at(contact)];
            Body<Dim>& body_a = bodies[at(a)];
            Body<Dim>& body_b = bodies[at(b)];
            const double beyond = pair_restitution(body_a, body_b) * part_[at(contact)];
            apply_impulse<Dim>({body_a, inverse_inertia_[at(a)]}, {body_b, inverse_inertia_[at(b)]},
                               touch, beyond);
            impulses[at(contact)] += part_[at(contact)] + beyond;
        }
    }
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
