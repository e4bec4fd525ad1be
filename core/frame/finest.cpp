#include "lodlab/core/frame/finest.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

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
        if (found.size() < most && std::none_of(found.begin(), found.end(), known))
            found.push_back(normal);
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
    std::stable_sort(
        normals.found.begin(), normals.found.end(),
        [&](const Vector<Dim>& p, const Vector<Dim>& q) { return p.dot(apart) > q.dot(apart); });
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

/// A front that the true shapes proved wrong: the nodes overlap, the bodies don't.
void clear_contacts(ListedFront& front) {
    front.pairs.count = 0;
    front.verdict = Verdict::apart;
}

bool collides(const Fronts& fronts, std::size_t pair) {
    return fronts.of_pair[pair].pairs.count > 0;
}

}  // namespace

template <int Dim>
void TrueShapePass<Dim>::refine(const TrueShapeTask<Dim>& task, Budget& budget, Fronts& fronts) {
    found_.clear();
    steps_ = 0;
    if (task.detail.level == Finest::leaves) return;
    node_pairs_ = 0;
    for (const ListedFront& front : fronts.of_pair)
        node_pairs_ += static_cast<std::uint64_t>(front.pairs.count);
    int asked = 0;
    for (const std::int32_t i : task.order) {
        ++steps_;
        const ListedFront& front = fronts.of_pair[at(i)];
        const bool ripe = front.finest && front.verdict == Verdict::true_collision;
        const CandidatePair& pair = task.pairs[at(i)];
        if (!ripe || !task.bodies[at(pair.a)].exact || !task.bodies[at(pair.b)].exact) continue;
        if (asked == task.detail.most_pairs) break;
        ++asked;
        if (!ask(task, i, budget, fronts)) break;
    }
    settle_backtracking(task, fronts);
    std::sort(found_.begin(), found_.end(),
              [](const FinestPair<Dim>& x, const FinestPair<Dim>& y) { return x.pair < y.pair; });
}

/// The exact level of one pair. Returns false where the budget ended before it.
template <int Dim>
bool TrueShapePass<Dim>::ask(const TrueShapeTask<Dim>& task, std::int32_t pair, Budget& budget,
                             Fronts& fronts) {
    ListedFront& front = fronts.of_pair[at(pair)];
    budget.reserve(node_pairs_);
    budget.begin(pair, front.level + 1);
    const std::uint64_t paid = budget.grant(task.detail.cost);
    front.tests += paid;
    if (paid < task.detail.cost) return false;
    auto touch = exact_contact(task.bodies[at(task.pairs[at(pair)].a)],
                               task.bodies[at(task.pairs[at(pair)].b)], task.time_step,
                               task.detail.tolerance);
    // A contact of the true shapes costs what a node pair does.
    const std::uint64_t fewer = static_cast<std::uint64_t>(front.pairs.count);
    const std::uint64_t more =
        touch.verdict == ExactVerdict::unresolved ? fewer : touch.contacts.size();
    if (!budget.keeps_level(more > fewer ? more - fewer : 0)) return false;
    if (touch.verdict == ExactVerdict::unresolved) return true;
    node_pairs_ += more;
    node_pairs_ -= fewer;
    if (touch.verdict == ExactVerdict::apart) clear_contacts(front);
    found_.push_back({pair, false, std::move(touch), {}});
    return true;
}

template <int Dim>
void TrueShapePass<Dim>::settle_backtracking(const TrueShapeTask<Dim>& task, const Fronts& fronts) {
    if (task.detail.level == Finest::backtrack && !found_.empty()) count_collisions(task, fronts);
    for (FinestPair<Dim>& pair : found_) {
        ++steps_;
        if (pair.touch.verdict == ExactVerdict::apart) continue;
        const std::size_t p = at(pair.pair);
        pair.backtracked = task.detail.level == Finest::backtrack && pair.touch.time <= 0 &&
                           pair.touch.time >= -task.time_step &&
                           !collides_elsewhere(task, fronts, p);
        pair.contacts = pair.backtracked
                            ? pair.touch.contacts
                            : carried_contacts(pair.touch, task.bodies[at(task.pairs[p].a)],
                                               task.bodies[at(task.pairs[p].b)]);
    }
}

template <int Dim>
void TrueShapePass<Dim>::count_collisions(const TrueShapeTask<Dim>& task, const Fronts& fronts) {
    refill(collisions_, task.bodies.size(), 0);
    for (std::size_t p = 0; p < task.pairs.size(); ++p) {
        ++steps_;
        if (!collides(fronts, p)) continue;
        ++collisions_[at(task.pairs[p].a)];
        ++collisions_[at(task.pairs[p].b)];
    }
}

/// Whether a body that moves is in a collision of the frame beside the pair's own.
template <int Dim>
bool TrueShapePass<Dim>::collides_elsewhere(const TrueShapeTask<Dim>& task, const Fronts& fronts,
                                            std::size_t own) const {
    const std::int32_t its_own = collides(fronts, own) ? 1 : 0;
    const auto elsewhere = [&](std::int32_t body) {
        return !task.bodies[at(body)].is_static() && collisions_[at(body)] > its_own;
    };
    return elsewhere(task.pairs[own].a) || elsewhere(task.pairs[own].b);
}

#define LOD_INSTANTIATE(Dim)                                                                      \
    template ExactContact<Dim> exact_contact(const Body<Dim>&, const Body<Dim>&, double, double); \
    template std::vector<Contact<Dim>> carried_contacts(const ExactContact<Dim>&,                 \
                                                        const Body<Dim>&, const Body<Dim>&);      \
    template class TrueShapePass<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
