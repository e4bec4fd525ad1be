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
                                        std::span<Body<Dim>> bodies, std::span<double> impulses,
                                        int most_visits) {
    report_ = {};
    touched_.gather(impacts, bodies, executor);
    prepare(impacts);
    list_neighbours();
    asked_.resize(pairs_.size());
    std::iota(asked_.begin(), asked_.end(), 0);
    for (std::int32_t rounds = 1; !asked_.empty(); ++rounds) {
        ++round_;
        const std::size_t asked = asked_.size();
        ask();
        round(impulses);
        ask_neighbours(most_visits);
        if (!goes_on(rounds, asked)) break;
    }
    report_rest(most_visits);
    touched_.give_back(bodies);
    return report_;
}

template <int Dim>
void NetImpulse<Dim>::prepare(std::span<const Impact<Dim>> impacts) {
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
    const auto fetch = [&](std::int32_t contact) {
        prefetch(touched_[touched_.number(impacts[at(contact)].a)]);
        prefetch(touched_[touched_.number(impacts[at(contact)].b)]);
    };
    each_fetched(order_, fetch, [&](std::int32_t contact, std::size_t i) {
        const Impact<Dim>& impact = impacts[at(contact)];
        if (i == 0 || impacts[at(order_[i - 1])].pair != impact.pair) {
            Pair& pair = pairs_.emplace_back();
            pair.a = touched_.number(impact.a);
            pair.b = touched_.number(impact.b);
            pair.first = static_cast<std::int32_t>(i);
            pair.restitution = pair_restitution(touched_[pair.a], touched_[pair.b]);
            pair.moves_a = !touched_[pair.a].is_static();
            pair.moves_b = !touched_[pair.b].is_static();
        }
        pairs_.back().end = static_cast<std::int32_t>(i) + 1;
    });
    rows_.resize(order_.size());
    each_part(executor, rows_.size(), rows_of_a_part, [&](const Part& part) {
        const auto some = std::span(order_).subspan(part.begin, part.end - part.begin);
        each_fetched(some, fetch, [&](std::int32_t contact, std::size_t i) {
            rows_[part.begin + i] = row(impacts[at(contact)]);
            rows_[part.begin + i].contact = contact;
        });
    });
    body_.resize(std::max(body_.size(), touched_.size()));
    if (queued_.size() < pairs_.size()) queued_.resize(pairs_.size(), 0);
}

template <int Dim>
auto NetImpulse<Dim>::row(const Impact<Dim>& impact) const -> Row {
    const std::int32_t a = touched_.number(impact.a);
    const std::int32_t b = touched_.number(impact.b);
    Row row;
    const Vector<Dim>& normal = row.normal = impact.contact.normal;
    const Vector<Dim>& point = impact.contact.point;
    row.moment_a = Space<Dim>::moment(point - touched_[a].position, normal);
    row.moment_b = Space<Dim>::moment(point - touched_[b].position, normal);
    const double K =
        inverse_norm(a, {normal, row.moment_a}) + inverse_norm(b, {normal, row.moment_b});
    row.mass = K > 0 ? 1 / K : 0;
    return row;
}

template <int Dim>
void NetImpulse<Dim>::list_neighbours() {
    neighbours_.list(touched_.size(), [&](const auto& visit) {
        for (std::size_t p = 0; p < pairs_.size(); ++p) {
            if (pairs_[p].moves_a) visit(pairs_[p].a, static_cast<std::int32_t>(p));
            if (pairs_[p].moves_b) visit(pairs_[p].b, static_cast<std::int32_t>(p));
        }
    });
}

/// Which pairs of this round approach.
template <int Dim>
void NetImpulse<Dim>::ask() {
    asked_parts_.resize(parts_of(executor, asked_.size(), pairs_of_a_part));
    approaching_.resize(asked_.size());
    each_part(executor, asked_.size(), pairs_of_a_part, [&](const Part& part) {
        Asked done;
        done.begin = part.begin;
        const auto fetch = [&](std::int32_t p) {
            prefetch(touched_[pairs_[at(p)].a]);
            prefetch(touched_[pairs_[at(p)].b]);
        };
        const auto some = std::span(asked_).subspan(part.begin, part.end - part.begin);
        each_fetched(some, fetch, [&](std::int32_t p, std::size_t) {
            Pair& pair = pairs_[at(p)];
            done.most_visits = std::max(done.most_visits, ++pair.visits);
            done.row_visits += static_cast<std::uint64_t>(pair.end - pair.first);
            if (approaches(pair)) approaching_[done.begin + done.approaching++] = p;
        });
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
bool NetImpulse<Dim>::approaches(Pair& pair) {
    pair.push_a = {};
    pair.push_b = pair.push_a;
    double work = 0;
    for (std::int32_t r = pair.first; r < pair.end; ++r) {
        Row& row = rows_[at(r)];
        double size = 0;
        const double u = row.closing(touched_[pair.a], touched_[pair.b], size);
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
    pair.norm_a = inverse_norm(pair.a, pair.push_a);
    pair.norm_b = inverse_norm(pair.b, pair.push_b);
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

/// A set is named by its first body, whatever the order of the pairs.
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
void NetImpulse<Dim>::join(Pair& pair) {
    pair.cluster = pair.moves_a ? pair.a : pair.b;
    if (!pair.moves_a || !pair.moves_b) return;
    unite(&BodyRound::group, pair.a, pair.b);
    if (leans(pair, pair.a, pair.norm_a))
        pair.cluster = pair.b;
    else if (!leans(pair, pair.b, pair.norm_b))
        unite(&BodyRound::cluster, pair.a, pair.b);
}

/// Pairs of this round.
template <int Dim>
template <class Visit>
void NetImpulse<Dim>::each_pair(std::span<const std::int32_t> pairs, const Visit& visit) {
    const auto fetch = [&](std::int32_t p) {
        prefetch(body_[at(pairs_[at(p)].a)]);
        prefetch(body_[at(pairs_[at(p)].b)]);
    };
    each_fetched(pairs, fetch, [&](std::int32_t p, std::size_t) { visit(pairs_[at(p)]); });
}

/// Adds up s D on these bodies, which are all that the pairs move.
template <int Dim>
void NetImpulse<Dim>::add_pushes(std::span<const std::int32_t> to,
                                 std::span<const std::int32_t> of_pairs) {
    for (const std::int32_t body : to) body_[at(body)].push = {};
    each_pair(of_pairs, [&](const Pair& pair) {
        const double s = body_[at(pair.cluster)].scale;
        const auto add = [&](std::int32_t body, const Push& by) {
            body_[at(body)].push.linear += s * by.linear;
            body_[at(body)].push.angular += s * by.angular;
        };
        if (pair.moves_a) add(pair.a, pair.push_a);
        if (pair.moves_b) add(pair.b, pair.push_b);
    });
}

/// The inverse-mass product of a pair's push and all that the round pushes the body with.
template <int Dim>
double NetImpulse<Dim>::product(std::int32_t body, const Push& push) const {
    const TouchedBody<Dim>& touched = touched_[body];
    if (touched.is_static()) return 0;
    const Push& all = body_[at(body)].push;
    return touched.inverse_mass * push.linear.dot(all.linear) +
           push.angular.dot(touched.inverse_inertia * all.angular);
}

/// The scales of clusters that lean on common bodies: few, as a rule, in a crowd.
template <int Dim>
void NetImpulse<Dim>::relax() {
    const auto leaning = [&](std::int32_t body) {
        return body_[at(root_of(&BodyRound::group, body))].leans;
    };
    leaning_bodies_.clear();
    for (const std::int32_t body : changed_)
        if (leaning(body)) leaning_bodies_.push_back(body);
    if (leaning_bodies_.empty()) return;
    leaning_pairs_.clear();
    for (const std::int32_t p : approaching_)
        if (leaning(pairs_[at(p)].cluster)) leaning_pairs_.push_back(p);
    for (int sweep = 0; sweep <= lean_sweeps; ++sweep) {
        add_pushes(leaning_bodies_, leaning_pairs_);
        for (const std::int32_t body : leaning_bodies_) body_[at(body)].reaction = 0;
        for (const std::int32_t p : leaning_pairs_) {
            const Pair& pair = pairs_[at(p)];
            body_[at(pair.cluster)].reaction +=
                product(pair.a, pair.push_a) + product(pair.b, pair.push_b);
        }
        for (const std::int32_t body : leaning_bodies_) {
            BodyRound& cluster = body_[at(body)];
            if (cluster.squares == 0) continue;
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
void NetImpulse<Dim>::round(std::span<double> impulses) {
    changed_.clear();
    each_pair(approaching_, [&](const Pair& pair) {
        if (pair.moves_a) enter(pair.a, pair.norm_a);
        if (pair.moves_b) enter(pair.b, pair.norm_b);
    });
    each_pair(approaching_, [&](Pair& pair) { join(pair); });
    each_pair(approaching_, [&](Pair& pair) {
        pair.cluster = root_of(&BodyRound::cluster, pair.cluster);
        body_[at(pair.cluster)].squares += pair.norm_a + pair.norm_b;
        const std::int32_t group = root_of(&BodyRound::group, pair.cluster);
        if (root_of(&BodyRound::cluster, group) != pair.cluster) body_[at(group)].leans = true;
    });
    relax();
    add_pushes(changed_, approaching_);
    apply(impulses);
}

template <int Dim>
template <class Visit>
void NetImpulse<Dim>::each_changed(const Visit& visit) {
    const auto fetch = [&](std::int32_t body) {
        prefetch(body_[at(body)]);
        prefetch(touched_[body]);
    };
    each_fetched(changed_, fetch, [&](std::int32_t body, std::size_t) { visit(body); });
}

/// Changes the bodies, and with them the impulses, by what makes the energy of each group exact.
template <int Dim>
void NetImpulse<Dim>::apply(std::span<double> impulses) {
    each_changed([&](std::int32_t body) {
        const BodyRound& entry = body_[at(body)];
        BodyRound& group = body_[at(root_of(&BodyRound::group, body))];
        group.group_norm += inverse_norm(body, entry.push);
        group.group_squares += entry.scale * entry.squares;
    });
    const auto scale = [&](std::int32_t body) {
        const BodyRound& group = body_[at(root_of(&BodyRound::group, body))];
        return group.group_norm > 0 ? group.group_squares / group.group_norm : 0;
    };
    each_changed([&](std::int32_t body) {
        const double s = scale(body);
        const Push& push = body_[at(body)].push;
        TouchedBody<Dim>& touched = touched_[body];
        touched.velocity += touched.inverse_mass * (s * push.linear);
        touched.spin += touched.inverse_inertia * (s * push.angular);
    });
    each_pair(approaching_, [&](const Pair& pair) {
        const double s = scale(pair.cluster) * body_[at(pair.cluster)].scale * pair.scale;
        for (std::int32_t r = pair.first; r < pair.end; ++r)
            impulses[at(rows_[at(r)].contact)] += s * rows_[at(r)].direction;
    });
}

/// The pairs of the next round: those of all bodies that this one has changed.
template <int Dim>
void NetImpulse<Dim>::ask_neighbours(int most_visits) {
    asked_.clear();
    for (const std::int32_t body : changed_)
        for (const std::int32_t p : neighbours_.of(body)) {
            if (pairs_[at(p)].visits >= most_visits) continue;
            if (std::exchange(queued_[at(p)], round_) != round_) asked_.push_back(p);
        }
    std::sort(asked_.begin(), asked_.end());
}

/// Whether the next round fits.
template <int Dim>
bool NetImpulse<Dim>::goes_on(std::int32_t rounds, std::size_t before) {
    const bool more = !budget || asked_.empty() || budget->goes_on(rounds, asked_.size(), before);
    if (!more) report_.unasked = static_cast<std::int32_t>(asked_.size());
    return more;
}

/// What goes on approaching; only a pair that was not asked to its end can.
template <int Dim>
void NetImpulse<Dim>::report_rest(int most_visits) {
    for (const Pair& pair : pairs_) {
        if (pair.visits < most_visits) continue;
        report_.row_visits += static_cast<std::uint64_t>(pair.end - pair.first);
        for (std::int32_t r = pair.first; r < pair.end; ++r) {
            double size = 0;
            const double speed = -rows_[at(r)].closing(touched_[pair.a], touched_[pair.b], size);
            if (rows_[at(r)].mass == 0 || speed <= pair.threshold) continue;
            ++report_.approaching;
            report_.fastest = std::max(report_.fastest, speed);
        }
    }
}

template class NetImpulse<2>;
template class NetImpulse<3>;

}  // namespace lod
