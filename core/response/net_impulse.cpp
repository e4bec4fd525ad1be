#include "lodlab/core/response/net_impulse.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// A contact approaches only beyond this share of the terms that its closing velocity is the sum
/// of: some thousand units of rounding.
constexpr double settled_share = 1e-12;

/// A pair leans on a body where all pairs at it together change its own answer by no more than this
/// share. Jacobi's method on the scales then gains about two digits a sweep.
constexpr double lean_share = 0.01;
constexpr int lean_sweeps = 8;

constexpr std::size_t rows_of_a_part = 256;

}  // namespace

template <int Dim>
ResponseReport NetImpulse<Dim>::resolve(std::span<const Impact<Dim>> impacts,
                                        std::span<const Inertia<Dim>> world_inverse_inertia,
                                        Bodies bodies, std::span<double> impulses,
                                        int most_visits) {
    report_ = {};
    inverse_inertia_ = world_inverse_inertia;
    prepare(impacts, bodies);
    list_neighbours(bodies);
    asked_.resize(pairs_.size());
    std::iota(asked_.begin(), asked_.end(), 0);
    while (!asked_.empty()) {
        ++round_;
        ask(bodies);
        round(bodies, impulses);
        ask_neighbours(most_visits);
    }
    report_rest(bodies, most_visits);
    return report_;
}

template <int Dim>
void NetImpulse<Dim>::prepare(std::span<const Impact<Dim>> impacts,
                              std::span<const Body<Dim>> bodies) {
    order_.resize(impacts.size());
    std::iota(order_.begin(), order_.end(), 0);
    const auto before = [&](std::int32_t x, std::int32_t y) {
        return impacts[at(x)].pair != impacts[at(y)].pair
                   ? impacts[at(x)].pair < impacts[at(y)].pair
                   : x < y;
    };
    // A frame's contacts stand pair by pair already.
    if (!std::is_sorted(order_.begin(), order_.end(), before))
        std::sort(order_.begin(), order_.end(), before);
    pairs_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const Impact<Dim>& impact = impacts[at(order_[i])];
        if (i == 0 || impacts[at(order_[i - 1])].pair != impact.pair) {
            Pair& pair = pairs_.emplace_back();
            pair.a = impact.a;
            pair.b = impact.b;
            pair.first = static_cast<std::int32_t>(i);
            pair.restitution = pair_restitution(bodies[at(impact.a)], bodies[at(impact.b)]);
        }
        pairs_.back().end = static_cast<std::int32_t>(i) + 1;
    }
    rows_.resize(order_.size());
    each_part(executor, rows_.size(), rows_of_a_part, [&](const Part& part) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
            rows_[i] = row(impacts[at(order_[i])], bodies);
            rows_[i].contact = order_[i];
        }
    });
    body_.resize(std::max(body_.size(), bodies.size()));
    if (queued_.size() < pairs_.size()) queued_.resize(pairs_.size(), 0);
}

template <int Dim>
auto NetImpulse<Dim>::row(const Impact<Dim>& impact, std::span<const Body<Dim>> bodies) const
    -> Row {
    const auto& [point, normal, depth] = impact.contact;
    Row row;
    row.normal = normal;
    row.moment_a = Space<Dim>::moment(point - bodies[at(impact.a)].position, normal);
    row.moment_b = Space<Dim>::moment(point - bodies[at(impact.b)].position, normal);
    const double K = inverse_norm(impact.a, {normal, row.moment_a}, bodies) +
                     inverse_norm(impact.b, {normal, row.moment_b}, bodies);
    row.mass = K > 0 ? 1 / K : 0;
    return row;
}

/// The pairs of each body that can move, by counting.
template <int Dim>
void NetImpulse<Dim>::list_neighbours(std::span<const Body<Dim>> bodies) {
    refill(neighbour_begin_, bodies.size() + 1, 0);
    const auto each = [&](const auto& visit) {
        for (std::size_t p = 0; p < pairs_.size(); ++p)
            for (const std::int32_t body : {pairs_[p].a, pairs_[p].b})
                if (!bodies[at(body)].is_static()) visit(at(body), static_cast<std::int32_t>(p));
    };
    each([&](std::size_t body, std::int32_t) { ++neighbour_begin_[body + 1]; });
    std::partial_sum(neighbour_begin_.begin(), neighbour_begin_.end(), neighbour_begin_.begin());
    neighbours_.resize(at(neighbour_begin_.back()));
    each([&](std::size_t body, std::int32_t p) { neighbours_[at(neighbour_begin_[body]++)] = p; });
    // Every begin has moved on to its end, the next one's begin.
    std::shift_right(neighbour_begin_.begin(), neighbour_begin_.end(), 1);
    neighbour_begin_.front() = 0;
}

/// Equation (3), and the size of the terms that it is the sum of.
template <int Dim>
double NetImpulse<Dim>::closing(const Pair& pair, const Row& row, std::span<const Body<Dim>> bodies,
                                double& size) const {
    const Body<Dim>& a = bodies[at(pair.a)];
    const Body<Dim>& b = bodies[at(pair.b)];
    const double linear_a = row.normal.dot(a.velocity);
    const double linear_b = row.normal.dot(b.velocity);
    const double angular_a = row.moment_a.dot(a.spin);
    const double angular_b = row.moment_b.dot(b.spin);
    size = std::abs(linear_a) + std::abs(linear_b) + std::abs(angular_a) + std::abs(angular_b);
    return (linear_b - linear_a) + (angular_b - angular_a);
}

/// The push's square by the body's inverse mass and inertia.
template <int Dim>
double NetImpulse<Dim>::inverse_norm(std::int32_t body, const Push& push,
                                     std::span<const Body<Dim>> bodies) const {
    return bodies[at(body)].inverse_mass * push.linear.squaredNorm() +
           push.angular.dot(inverse_inertia_[at(body)] * push.angular);
}

/// Which pairs of this round approach.
template <int Dim>
void NetImpulse<Dim>::ask(std::span<const Body<Dim>> bodies) {
    asked_parts_.resize(parts_of(executor, asked_.size(), pairs_of_a_part));
    approaching_.resize(asked_.size());
    each_part(executor, asked_.size(), pairs_of_a_part, [&](const Part& part) {
        Asked done;
        done.begin = part.begin;
        for (std::size_t i = part.begin; i < part.end; ++i) {
            Pair& pair = pairs_[at(asked_[i])];
            done.most_visits = std::max(done.most_visits, ++pair.visits);
            done.row_visits += static_cast<std::uint64_t>(pair.end - pair.first);
            if (approaches(pair, bodies)) approaching_[done.begin + done.approaching++] = asked_[i];
        }
        asked_parts_[part.number] = done;
    });
    auto end = approaching_.begin();
    for (const Asked& part : asked_parts_) {
        const auto begin = approaching_.begin() + static_cast<std::ptrdiff_t>(part.begin);
        end = std::copy(begin, begin + static_cast<std::ptrdiff_t>(part.approaching), end);
        report_.most_visits = std::max(report_.most_visits, part.most_visits);
        report_.row_visits += part.row_visits;
    }
    approaching_.erase(end, approaching_.end());
}

/// Whether the pair approaches now; then its push and its scale are those of this round.
template <int Dim>
bool NetImpulse<Dim>::approaches(Pair& pair, std::span<const Body<Dim>> bodies) {
    pair.push_a = {};
    pair.push_b = pair.push_a;
    double work = 0;
    for (std::int32_t r = pair.first; r < pair.end; ++r) {
        Row& row = rows_[at(r)];
        double size = 0;
        const double u = closing(pair, row, bodies, size);
        pair.threshold = std::max(pair.threshold, settled_share * size);
        row.direction = u < -pair.threshold ? -u * row.mass : 0;
        if (row.direction == 0) continue;
        work += row.direction * -u;
        pair.push_a.linear -= row.direction * row.normal;
        pair.push_a.angular -= row.direction * row.moment_a;
        pair.push_b.linear += row.direction * row.normal;
        pair.push_b.angular += row.direction * row.moment_b;
    }
    if (work == 0) return false;
    pair.norm_a = inverse_norm(pair.a, pair.push_a, bodies);
    pair.norm_b = inverse_norm(pair.b, pair.push_b, bodies);
    pair.scale = (1 + pair.restitution) * (work / (pair.norm_a + pair.norm_b));
    for (Push* push : {&pair.push_a, &pair.push_b}) {
        push->linear = pair.scale * push->linear;
        push->angular = pair.scale * push->angular;
    }
    pair.norm_a *= pair.scale * pair.scale;
    pair.norm_b *= pair.scale * pair.scale;
    return true;
}

template <int Dim>
std::int32_t NetImpulse<Dim>::root_of(Set set, std::int32_t body) {
    while (body_[at(body)].*set != body) {
        std::int32_t& root = body_[at(body)].*set;
        body = root = body_[at(root)].*set;
    }
    return body;
}

/// A set is named by its first body, so that its name does not depend on the order of the pairs.
template <int Dim>
void NetImpulse<Dim>::unite(Set set, std::int32_t a, std::int32_t b) {
    const std::int32_t root_a = root_of(set, a);
    const std::int32_t root_b = root_of(set, b);
    body_[at(std::max(root_a, root_b))].*set = std::min(root_a, root_b);
}

/// A body that this round changes, with the norm of a pair at it.
template <int Dim>
void NetImpulse<Dim>::enter(std::int32_t body, double norm) {
    BodyRound& entry = body_[at(body)];
    if (entry.round != round_) {
        entry = {};
        entry.round = round_;
        entry.group = body;
        entry.cluster = body;
        changed_.push_back(body);
    }
    entry.strain += std::sqrt(norm);
}

/// Whether all that goes on at the body hardly acts on the pair.
template <int Dim>
bool NetImpulse<Dim>::leans(const Pair& pair, std::int32_t body, double norm) const {
    return std::sqrt(norm) * body_[at(body)].strain <= lean_share * (pair.norm_a + pair.norm_b);
}

/// Puts the pair and its bodies into one group, and into one cluster where it does not lean. Of two
/// bodies it leans on one at most, for their norms add up to its own.
template <int Dim>
void NetImpulse<Dim>::join(Pair& pair, std::span<const Body<Dim>> bodies) {
    const bool moves_a = !bodies[at(pair.a)].is_static();
    const bool moves_b = !bodies[at(pair.b)].is_static();
    pair.cluster = moves_a ? pair.a : pair.b;
    if (!moves_a || !moves_b) return;
    unite(&BodyRound::group, pair.a, pair.b);
    if (leans(pair, pair.a, pair.norm_a))
        pair.cluster = pair.b;
    else if (!leans(pair, pair.b, pair.norm_b))
        unite(&BodyRound::cluster, pair.a, pair.b);
}

/// Adds up s D on each body.
template <int Dim>
void NetImpulse<Dim>::add_pushes(std::span<const Body<Dim>> bodies, bool leaning_only) {
    const auto meant = [&](std::int32_t body) {
        return !leaning_only || body_[at(root_of(&BodyRound::group, body))].leans;
    };
    for (const std::int32_t body : changed_)
        if (meant(body)) body_[at(body)].push = {};
    for (const std::int32_t p : approaching_) {
        const Pair& pair = pairs_[at(p)];
        if (!meant(pair.cluster)) continue;
        const double s = body_[at(pair.cluster)].scale;
        const auto add = [&](std::int32_t body, const Push& by) {
            if (bodies[at(body)].is_static()) return;
            body_[at(body)].push.linear += s * by.linear;
            body_[at(body)].push.angular += s * by.angular;
        };
        add(pair.a, pair.push_a);
        add(pair.b, pair.push_b);
    }
}

/// The inverse-mass product of a pair's push and all that the round pushes the body with.
template <int Dim>
double NetImpulse<Dim>::product(std::int32_t body, const Push& push,
                                std::span<const Body<Dim>> bodies) const {
    if (bodies[at(body)].is_static()) return 0;
    const Push& all = body_[at(body)].push;
    return bodies[at(body)].inverse_mass * push.linear.dot(all.linear) +
           push.angular.dot(inverse_inertia_[at(body)] * all.angular);
}

/// The scales of clusters that lean on common bodies.
template <int Dim>
void NetImpulse<Dim>::relax(std::span<const Body<Dim>> bodies) {
    const auto leaning = [&](std::int32_t body) {
        return body_[at(root_of(&BodyRound::group, body))].leans;
    };
    if (std::none_of(changed_.begin(), changed_.end(), leaning)) return;
    for (int sweep = 0; sweep <= lean_sweeps; ++sweep) {
        add_pushes(bodies, true);
        for (const std::int32_t body : changed_) body_[at(body)].reaction = 0;
        for (const std::int32_t p : approaching_) {
            const Pair& pair = pairs_[at(p)];
            if (leaning(pair.cluster))
                body_[at(pair.cluster)].reaction +=
                    product(pair.a, pair.push_a, bodies) + product(pair.b, pair.push_b, bodies);
        }
        for (const std::int32_t body : changed_) {
            BodyRound& cluster = body_[at(body)];
            if (cluster.squares == 0 || !leaning(body)) continue;
            // The first time all scales are 1, and what the others add is little.
            if (sweep == 0) cluster.diagonal = cluster.reaction;
            if (cluster.diagonal > 0)
                cluster.scale += (cluster.squares - cluster.reaction) / cluster.diagonal;
            cluster.scale = std::max(0.0, cluster.scale);
        }
    }
}

/// One round: the net impulse of all pairs that approach.
template <int Dim>
void NetImpulse<Dim>::round(Bodies bodies, std::span<double> impulses) {
    changed_.clear();
    for (const std::int32_t p : approaching_) {
        const Pair& pair = pairs_[at(p)];
        if (!bodies[at(pair.a)].is_static()) enter(pair.a, pair.norm_a);
        if (!bodies[at(pair.b)].is_static()) enter(pair.b, pair.norm_b);
    }
    for (const std::int32_t p : approaching_) join(pairs_[at(p)], bodies);
    for (const std::int32_t p : approaching_) {
        Pair& pair = pairs_[at(p)];
        pair.cluster = root_of(&BodyRound::cluster, pair.cluster);
        body_[at(pair.cluster)].squares += pair.norm_a + pair.norm_b;
        const std::int32_t group = root_of(&BodyRound::group, pair.cluster);
        if (root_of(&BodyRound::cluster, group) != pair.cluster) body_[at(group)].leans = true;
    }
    relax(bodies);
    add_pushes(bodies, false);
    apply(bodies, impulses);
}

/// Changes the bodies, and with them the impulses, by what makes the energy of each group exact.
template <int Dim>
void NetImpulse<Dim>::apply(Bodies bodies, std::span<double> impulses) {
    for (const std::int32_t body : changed_) {
        const BodyRound& entry = body_[at(body)];
        BodyRound& group = body_[at(root_of(&BodyRound::group, body))];
        group.group_norm += inverse_norm(body, entry.push, bodies);
        group.group_squares += entry.scale * entry.squares;
    }
    const auto scale = [&](std::int32_t body) {
        const BodyRound& group = body_[at(root_of(&BodyRound::group, body))];
        return group.group_norm > 0 ? group.group_squares / group.group_norm : 0;
    };
    for (const std::int32_t body : changed_) {
        const double s = scale(body);
        const Push& push = body_[at(body)].push;
        bodies[at(body)].velocity += bodies[at(body)].inverse_mass * (s * push.linear);
        bodies[at(body)].spin += inverse_inertia_[at(body)] * (s * push.angular);
    }
    for (const std::int32_t p : approaching_) {
        const Pair& pair = pairs_[at(p)];
        const double s = scale(pair.cluster) * body_[at(pair.cluster)].scale * pair.scale;
        for (std::int32_t r = pair.first; r < pair.end; ++r)
            impulses[at(rows_[at(r)].contact)] += s * rows_[at(r)].direction;
    }
}

/// The pairs of the next round: those of all bodies that this one has changed.
template <int Dim>
void NetImpulse<Dim>::ask_neighbours(int most_visits) {
    asked_.clear();
    for (const std::int32_t body : changed_)
        for (std::int32_t n = neighbour_begin_[at(body)]; n < neighbour_begin_[at(body) + 1]; ++n) {
            const std::int32_t p = neighbours_[at(n)];
            if (pairs_[at(p)].visits >= most_visits) continue;
            if (std::exchange(queued_[at(p)], round_) != round_) asked_.push_back(p);
        }
    std::sort(asked_.begin(), asked_.end());
}

/// What goes on approaching; only a pair that was not asked to its end can.
template <int Dim>
void NetImpulse<Dim>::report_rest(std::span<const Body<Dim>> bodies, int most_visits) {
    for (const Pair& pair : pairs_) {
        if (pair.visits < most_visits) continue;
        report_.row_visits += static_cast<std::uint64_t>(pair.end - pair.first);
        for (std::int32_t r = pair.first; r < pair.end; ++r) {
            double size = 0;
            const double speed = -closing(pair, rows_[at(r)], bodies, size);
            if (rows_[at(r)].mass == 0 || speed <= pair.threshold) continue;
            ++report_.approaching;
            report_.fastest = std::max(report_.fastest, speed);
        }
    }
}

template class NetImpulse<2>;
template class NetImpulse<3>;

}  // namespace lod
