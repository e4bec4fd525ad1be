#include "lodlab/core/frame/finest.hpp"

#include <algorithm>

namespace lod {
namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

template <int Dim>
Body<Dim> reversed(Body<Dim> body) {
    body.velocity = -body.velocity;
    body.spin = -body.spin;
    return body;
}

/// The moment of touch on the way from a moment `seconds` ago, if the bodies were apart then. With
/// reversed bodies: the moment ahead at which they part. Returns whether there is one.
template <int Dim>
bool touch_since(const Body<Dim>& a, const Body<Dim>& b, double seconds, double tolerance,
                 ExactContact<Dim>& found) {
    const Body<Dim> a_then = reversed(moved_freely(reversed(a), seconds, seconds));
    const Body<Dim> b_then = reversed(moved_freely(reversed(b), seconds, seconds));
    auto touch = time_of_impact(
        a_then, b_then, {.horizon = seconds, .tolerance = tolerance, .longest_turn = seconds});
    if (touch.outcome != ImpactOutcome::touching) return false;
    found.verdict = ExactVerdict::touched;
    found.time = touch.time - seconds;
    found.a = std::move(touch.a);
    found.b = std::move(touch.b);
    found.contacts = std::move(touch.contacts);
    return true;
}

template <int Dim>
void touch_now(const Body<Dim>& a, const Body<Dim>& b, double tolerance, ExactContact<Dim>& found) {
    const double gap = separation(a, b).distance;
    if (gap > tolerance) return;
    found.verdict = ExactVerdict::touched;
    found.a = a;
    found.b = b;
    touching_contacts(a, b, gap + tolerance, found.contacts);
}

/// The normals along which two shapes that share a point may be apart by a hair. Frame of A.
template <int Dim>
class Normals final : public PartVisitor<Dim> {
  public:
    explicit Normals(double reach) : reach_(reach) {}

    bool skips(const ConvexPart<Dim>&, const ConvexPart<Dim>&, const Vector<Dim>&,
               double gap) const override {
        return gap > reach_ || found.size() >= most;
    }
    void visit(const PartPair<Dim>& pair) override {
        if (pair.distance > reach_) return;
        // Parts that share a point have no direction of their own.
        for (std::size_t k = 0; k < pair.firm_directions; ++k) add(pair.direction[k]);
        add_facet(pair.a);
        add_facet(pair.b);
    }

    static constexpr std::size_t most = 32;
    std::vector<Vector<Dim>> found;

  private:
    void add(const Vector<Dim>& normal) {
        const auto known = [&](const Vector<Dim>& n) { return n.dot(normal) > 1 - 1e-9; };
        if (found.size() < most && std::ranges::none_of(found, known)) found.push_back(normal);
    }
    /// Either way: which is right, a shift shows.
    void add_facet(const ConvexPart<Dim>& part) {
        if (part.count != Dim) return;
        const Vector<Dim> normal = Space<Dim>::area_vector(part.corners()).normalized();
        add(normal);
        add(-normal);
    }

    double reach_;
};

/// Bodies whose boundaries share points, but which a shift by two tolerances would part: they
/// touch. Of several ways to part, as corner and corner have, the one that they take soonest.
template <int Dim>
bool touch_within(const Body<Dim>& a, const Body<Dim>& b, double tolerance,
                  ExactContact<Dim>& found) {
    Normals<Dim> normals(tolerance);
    const Placement<Dim> at_a = placement(a);
    a.exact->visit_pairs(*b.exact, seen_from(at_a, placement(b)), normals);
    for (Vector<Dim>& normal : normals.found) normal = at_a.rotation * normal;
    const Vector<Dim> apart = b.velocity - a.velocity;
    std::ranges::stable_sort(normals.found, std::ranges::greater{},
                             [&](const Vector<Dim>& normal) { return normal.dot(apart); });
    for (const Vector<Dim>& normal : normals.found) {
        Body<Dim> shifted = b;
        shifted.position += 2 * tolerance * normal;
        if (exactly_overlap(a, shifted)) continue;
        touch_now(a, shifted, 4 * tolerance, found);
        found.a = a;
        found.b = b;
        return found.verdict == ExactVerdict::touched;
    }
    return false;
}

}  // namespace

template <int Dim>
ExactContact<Dim> exact_contact(const Body<Dim>& a, const Body<Dim>& b, double look_back,
                                double tolerance) {
    ExactContact<Dim> found;
    if (!exactly_overlap(a, b)) {
        touch_now(a, b, tolerance, found);
        return found;
    }
    if (touch_since(a, b, look_back, tolerance, found)) return found;
    if (touch_since(reversed(a), reversed(b), look_back, tolerance, found)) {
        found.time = -found.time;
        found.a = reversed(found.a);
        found.b = reversed(found.b);
        return found;
    }
    if (!touch_within(a, b, tolerance, found)) found.verdict = ExactVerdict::unresolved;
    return found;
}

template <int Dim>
std::vector<Contact<Dim>> carried_contacts(const ExactContact<Dim>& touch, const Body<Dim>& a,
                                           const Body<Dim>& b) {
    const auto path = [](const Body<Dim>& then, const Body<Dim>& now) {
        const Placement<Dim> from = placement(then);
        const Placement<Dim> to = placement(now);
        const Matrix<Dim> turn = to.rotation * from.rotation.transpose();
        return Placement<Dim>{turn, to.position - turn * from.position};
    };
    const Placement<Dim> with_a = path(touch.a, a);
    const Placement<Dim> with_b = path(touch.b, b);
    std::vector<Contact<Dim>> carried;
    for (const Contact<Dim>& contact : touch.contacts) {
        const Vector<Dim> half_gap = -0.5 * contact.depth * contact.normal;
        const Vector<Dim> on_a = with_a.carry(contact.point - half_gap);
        const Vector<Dim> on_b = with_b.carry(contact.point + half_gap);
        const Vector<Dim> normal =
            ((with_a.rotation + with_b.rotation) * contact.normal).normalized();
        carried.push_back({0.5 * (on_a + on_b), normal, -normal.dot(on_b - on_a)});
    }
    return carried;
}

namespace {

/// Whether a body that moves is in a collision of the frame beside the pair's own.
template <int Dim>
bool collides_elsewhere(std::span<const Body<Dim>> bodies, std::span<const CandidatePair> pairs,
                        const Fronts& fronts, std::size_t own) {
    const auto shares = [&](std::int32_t body, const CandidatePair& other) {
        return !bodies[at(body)].is_static() && (other.a == body || other.b == body);
    };
    for (std::size_t p = 0; p < pairs.size(); ++p)
        if (p != own && fronts.of_pair[p].pairs.count > 0 &&
            (shares(pairs[own].a, pairs[p]) || shares(pairs[own].b, pairs[p])))
            return true;
    return false;
}

/// A front that the true shapes proved wrong: the nodes overlap, the bodies don't.
void clear_contacts(ListedFront& front) {
    front.pairs.count = 0;
    front.verdict = Verdict::apart;
}

template <int Dim>
void settle_backtracking(std::span<const Body<Dim>> bodies, std::span<const CandidatePair> pairs,
                         const FinestDetail& detail, double time_step, const Fronts& fronts,
                         std::vector<FinestPair<Dim>>& found) {
    for (FinestPair<Dim>& pair : found) {
        if (pair.touch.verdict == ExactVerdict::apart) continue;
        const std::size_t p = at(pair.pair);
        pair.backtracked = detail.level == Finest::backtrack && pair.touch.time <= 0 &&
                           pair.touch.time >= -time_step &&
                           !collides_elsewhere(bodies, pairs, fronts, p);
        pair.contacts = pair.backtracked ? pair.touch.contacts
                                         : carried_contacts(pair.touch, bodies[at(pairs[p].a)],
                                                            bodies[at(pairs[p].b)]);
    }
}

}  // namespace

template <int Dim>
void refine_finest(std::span<const Body<Dim>> bodies, std::span<const CandidatePair> pairs,
                   std::span<const std::int32_t> order, const FinestDetail& detail,
                   double time_step, Budget& budget, Fronts& fronts,
                   std::vector<FinestPair<Dim>>& found) {
    found.clear();
    if (detail.level == Finest::leaves) return;
    std::uint64_t node_pairs = 0;
    for (const ListedFront& front : fronts.of_pair)
        node_pairs += static_cast<std::uint64_t>(front.pairs.count);
    int asked = 0;
    for (std::int32_t i : order) {
        ListedFront& front = fronts.of_pair[at(i)];
        const Body<Dim>& a = bodies[at(pairs[at(i)].a)];
        const Body<Dim>& b = bodies[at(pairs[at(i)].b)];
        const bool ripe = front.finest && front.verdict == Verdict::true_collision;
        if (!ripe || !a.exact || !b.exact) continue;
        if (asked == detail.most_pairs) break;
        ++asked;
        budget.reserve(node_pairs);
        budget.begin(i, front.level + 1);
        const std::uint64_t paid = budget.grant(detail.cost);
        front.tests += paid;
        if (paid < detail.cost) break;
        auto touch = exact_contact(a, b, time_step, detail.tolerance);
        // A contact of the true shapes costs what a node pair does.
        const std::uint64_t fewer = static_cast<std::uint64_t>(front.pairs.count);
        const std::uint64_t more =
            touch.verdict == ExactVerdict::unresolved ? fewer : touch.contacts.size();
        if (!budget.keeps_level(more > fewer ? more - fewer : 0)) break;
        if (touch.verdict == ExactVerdict::unresolved) continue;
        node_pairs += more;
        node_pairs -= fewer;
        if (touch.verdict == ExactVerdict::apart) clear_contacts(front);
        found.push_back({i, false, std::move(touch), {}});
    }
    settle_backtracking(bodies, pairs, detail, time_step, fronts, found);
    std::ranges::sort(found, {}, &FinestPair<Dim>::pair);
}

#define LOD_INSTANTIATE(Dim)                                                                      \
    template ExactContact<Dim> exact_contact(const Body<Dim>&, const Body<Dim>&, double, double); \
    template std::vector<Contact<Dim>> carried_contacts(const ExactContact<Dim>&,                 \
                                                        const Body<Dim>&, const Body<Dim>&);      \
    template void refine_finest(std::span<const Body<Dim>>, std::span<const CandidatePair>,       \
                                std::span<const std::int32_t>, const FinestDetail&, double,       \
                                Budget&, Fronts&, std::vector<FinestPair<Dim>>&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
