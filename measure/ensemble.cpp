#include "lodlab/measure/ensemble.hpp"

#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/response/impact.hpp"
#include "lodlab/measure/exact_shapes.hpp"
#include "lodlab/measure/free_flight.hpp"

namespace measure {
namespace {

constexpr int most_draws = 1000;

/// A stream of its own for each number: both are mixed, so that neither neighbouring seeds nor
/// neighbouring numbers share a part of their streams.
lod::Random stream(std::uint64_t seed, std::uint64_t number) {
    lod::Random of_seed(seed);
    lod::Random of_number(of_seed.next_bits() ^ (number * 0xd1342543de82ef95u));
    return lod::Random(of_number.next_bits());
}

/// Even over all directions: a point of the ball, by rejection.
template <int Dim>
lod::Vector<Dim> direction(lod::Random& random) {
    for (;;) {
        lod::Vector<Dim> v;
        for (double& x : v) x = random.next(-1, 1);
        const double length = v.norm();
        if (length > 0.1 && length <= 1) return v / length;
    }
}

template <int Dim>
void turn(lod::Body<Dim>& body, lod::Random& random, double most_spin) {
    // Three turns of up to half a turn each leave no orientation out and none preferred much.
    for (int i = 0; i < 3; ++i) {
        lod::Spin<Dim> angle;
        for (double& x : angle) x = random.next(-std::numbers::pi, std::numbers::pi);
        body.orientation = lod::Space<Dim>::turned(body.orientation, angle);
    }
    for (double& w : body.spin) w = random.next(-most_spin, most_spin);
}

template <int Dim>
Approach<Dim> draw(std::span<const MeasuredShape<Dim>> shapes, const EnsembleSettings& settings,
                   lod::Random& random) {
    Approach<Dim> drawn;
    const auto any = [&] {
        return static_cast<int>(random.next() * static_cast<double>(shapes.size()));
    };
    drawn.shape_a = any();
    drawn.shape_b = any();
    drawn.a = shapes[static_cast<std::size_t>(drawn.shape_a)].body;
    drawn.b = shapes[static_cast<std::size_t>(drawn.shape_b)].body;
    turn(drawn.a, random, settings.spin);
    turn(drawn.b, random, settings.spin);
    const lod::Vector<Dim> ahead = direction<Dim>(random);
    // Aside: what of another direction is square to the approach.
    lod::Vector<Dim> aside = direction<Dim>(random);
    aside -= aside.dot(ahead) * ahead;
    const double reach = drawn.a.tree->extent + drawn.b.tree->extent;
    const double offset = random.next(0, settings.aim) * reach;
    if (aside.norm() > 0) aside *= offset / aside.norm();
    drawn.b.position = 1.05 * reach * ahead + aside;
    drawn.a.velocity = settings.speed / 2 * ahead;
    drawn.b.velocity = -settings.speed / 2 * ahead;
    drawn.a.restitution = drawn.b.restitution = settings.restitution;
    return drawn;
}

/// Whether something pushes as they touch.
template <int Dim>
bool pushes(const lod::TimeOfImpact<Dim>& touch) {
    if (touch.outcome != lod::ImpactOutcome::touching) return false;
    return std::any_of(touch.contacts.begin(), touch.contacts.end(),
                       [&](const lod::Contact<Dim>& contact) {
                           return lod::closing_velocity(touch.a, touch.b, contact) < 0;
                       });
}

/// The first touch at which something pushes, frame by frame: first while the trees keep the bodies
/// apart, then while the shapes do, then to the time of impact. Returns whether there is one.
template <int Dim>
bool find_touch(Approach<Dim>& approach, double horizon, double step) {
    constexpr int frames_looked_ahead = 4;
    FreeFlight<Dim> flight({0, {approach.a, approach.b}}, step);
    lod::ImpactSettings look;
    look.horizon = frames_looked_ahead * step;
    look.tolerance = touching_within;
    look.longest_turn = step;
    constexpr int leaves = 1000;
    if (!flight.to_front(leaves, horizon)) return false;
    while (flight.to_near(horizon)) {
        lod::check_interrupted();
        approach.touch = lod::time_of_impact(flight.now().bodies[0], flight.now().bodies[1], look);
        if (approach.touch.outcome == lod::ImpactOutcome::overlapping) return false;
        approach.time = flight.time() + approach.touch.time;
        if (pushes(approach.touch)) return true;
        flight.step(frames_looked_ahead - 1);
    }
    return false;
}

}  // namespace

template <int Dim>
MeasuredShape<Dim> measured_shape(const std::string& name, const scenes::Shape<Dim>& shape,
                                  const scenes::TreeChoice& tree, const io::TreeCache& cache) {
    using Shapes = scenes::Shapes<Dim>;
    MeasuredShape<Dim> result;
    result.name = name;
    lod::set_mass(result.body, Shapes::measure(shape), Shapes::second_moment(shape));
    result.body.tree = std::make_shared<const lod::SphereTree<Dim>>(
        scenes::tree_of<Dim>(shape, Shapes::settings(tree), cache));
    result.body.exact = exact_shape(shape);
    for (const lod::LevelReport& level : Shapes::report(shape, *result.body.tree).levels)
        result.protrusion.push_back(level.worst_protrusion);
    return result;
}

template <int Dim>
Approach<Dim> draw_approach(std::span<const MeasuredShape<Dim>> shapes,
                            const EnsembleSettings& settings, std::uint64_t number, double step) {
    lod::Random random = stream(settings.seed, number);
    for (int attempt = 0; attempt < most_draws; ++attempt) {
        lod::check_interrupted();
        Approach<Dim> drawn = draw<Dim>(shapes, settings, random);
        // By then the centres have passed each other.
        const double horizon = 2.2 * (drawn.a.tree->extent + drawn.b.tree->extent) / settings.speed;
        if (find_touch(drawn, horizon, step)) return drawn;
    }
    throw lod::Error(lod::ErrorKind::input_refused,
                     "the shapes do not meet in " + std::to_string(most_draws) +
                         " random approaches; aim closer or choose other shapes");
}

#define MEASURE_INSTANTIATE(Dim)                                                                 \
    template MeasuredShape<Dim> measured_shape(const std::string&, const scenes::Shape<Dim>&,    \
                                               const scenes::TreeChoice&, const io::TreeCache&); \
    template Approach<Dim> draw_approach(std::span<const MeasuredShape<Dim>>,                    \
                                         const EnsembleSettings&, std::uint64_t, double);
MEASURE_INSTANTIATE(2)
MEASURE_INSTANTIATE(3)
#undef MEASURE_INSTANTIATE

}  // namespace measure
