#include <cmath>

#include "lessons/exercises/tasks/cases.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/core/response/impact.hpp"

namespace exercises {
namespace {

constexpr std::size_t body_size = 10;

struct Spec {
    double mass = 0;  ///< 0: it cannot move
    double inertia = 0;
    double e = 1;
    double x = 0, y = 0;
    double v_x = 0, v_y = 0;
    double spin = 0;
};

Numbers told_in(const Spec& spec) {
    const bool moves = spec.mass > 0;
    return {moves ? 1 / spec.mass : 0,
            spec.inertia,
            moves ? 1 / spec.inertia : 0,
            spec.e,
            spec.x,
            spec.y,
            0,
            spec.v_x,
            spec.v_y,
            spec.spin};
}

std::vector<Numbers> edges() {
    const Spec wall{0, 0, 1, 0, -5, 0, 0, 0};
    const Spec lift{0, 0, 1, 0, -5, 0, 1, 0};
    const Spec box{1, 1.0 / 6, 1, 0, 0.5, 0, -1, 0};
    const Spec still{1, 1.0 / 6, 0.5, 0, 0.5, 0, 0, 0};
    return {
        joined(
            {told_in({1, 1, 1, -1, 0, 2, 0, 0}), told_in({3, 1, 1, 1, 0, -1, 0, 0}), {0, 0, 1, 0}}),
        joined({told_in({1, 1, 0.5, -1, 0, 2, 0, 0}),
                told_in({3, 1, 1, 1, 0, -1, 0, 0}),
                {0, 0, 1, 0}}),
        joined(
            {told_in({1, 1, 1, -1, 0, -2, 0, 0}), told_in({3, 1, 1, 1, 0, 1, 0, 0}), {0, 0, 1, 0}}),
        joined({told_in({1, 1.0 / 6, 1, 0, 0, 1, 0, 2}),
                told_in({2, 1.0 / 3, 1, 1.3, 0.1, -0.5, 0.2, -1}),
                {0.6, 0.3, 1, 0}}),
        joined({told_in(wall), told_in(box), {0.25, 0, 0, 1}}),
        joined({told_in(box), told_in(wall), {0.25, 0, 0, -1}}),
        joined({told_in(wall), told_in(still), {0.25, 0, 0, 1}}),
        joined({told_in(lift), told_in(wall), {0, -4, 0, 1}})};
}

Spec random_body(lod::Random& random) {
    const bool moves = random.next() < 0.85;
    return {moves ? random.next(0.5, 4) : 0,
            moves ? random.next(0.1, 3) : 0,
            random.next(),
            random.next(-3, 3),
            random.next(-3, 3),
            random.next(-2, 2),
            random.next(-2, 2),
            random.next(-3, 3)};
}

Numbers random_case(lod::Random& random) {
    const lod::SineCosine of = lod::sine_cosine(random.next(0, lod::full_turn));
    const Numbers a = told_in(random_body(random));
    const Numbers b = told_in(random_body(random));
    return joined({a, b, {random.next(-3, 3), random.next(-3, 3), of.cosine, of.sine}});
}

lod::Body<2> body_in(const Numbers& asked, std::size_t at) {
    lod::Body<2> body;
    body.inverse_mass = asked[at];
    body.inverse_inertia(0, 0) = asked[at + 2];
    body.restitution = asked[at + 3];
    body.position = {asked[at + 4], asked[at + 5]};
    body.velocity = {asked[at + 7], asked[at + 8]};
    body.spin[0] = asked[at + 9];
    return body;
}

/// By what impulses do: those of 0 and 1 N s tell which one turns v_c into -e v_c.
Numbers truth(const Numbers& asked) {
    lod::Body<2> a = body_in(asked, 0);
    lod::Body<2> b = body_in(asked, body_size);
    const std::size_t at = 2 * body_size;
    const lod::Contact<2> contact{{asked[at], asked[at + 1]}, {asked[at + 2], asked[at + 3]}, 0};
    const double e = lod::pair_restitution(a, b);
    const double before = lod::closing_velocity(a, b, contact);
    if (before >= 0 || (a.is_static() && b.is_static())) return {0};
    lod::apply_impulse(a, b, contact, 1);
    return {(-e * before - before) / (lod::closing_velocity(a, b, contact) - before)};
}

}  // namespace

Task make_impulse() {
    return {edges, random_case, truth};
}

}  // namespace exercises
