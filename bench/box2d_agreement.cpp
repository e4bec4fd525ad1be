// How well lodlab's exact impact and Box2D agree on the first impact of random pairs, and where
// they do not, why. The difference is that of both bodies' velocities after the impact [m/s];
// bodies of 1 m close at some 2 m/s and spin at up to 2 rad/s.
//
// bench_box2d_agreement [PAIRS [SEED]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lodlab/core/base/random.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/measure/first_impact.hpp"
#include "lodlab/measure/plane_bodies.hpp"

namespace {

struct Kind {
    lod2d::Shape shape;
    std::shared_ptr<const lod2d::ExactOutline> outline;
};

std::vector<Kind> kinds() {
    std::vector<Kind> list;
    for (const char* spec : {"box", "L", "star:5", "star:9", "triangle", "T", "cross", "gear:9",
                             "arrow", "U", "polygon:7"}) {
        const lod2d::Shape shape = lod2d::generate(spec);
        list.push_back({shape, std::make_shared<lod2d::ExactOutline>(shape)});
    }
    return list;
}

lod::Body<2> body_of(const Kind& kind, double mass, lod::Random& random) {
    lod::Body<2> body;
    lod::set_mass<2>(body, mass,
                     lod::Inertia<2>::Constant(mass * kind.shape.second_moment / kind.shape.area));
    body.orientation = lod::wrapped_angle(random.next(-3, 3));
    body.spin[0] = random.next(-2, 2);
    body.exact = kind.outline;
    return body;
}

const Kind& any(const std::vector<Kind>& list, lod::Random& random) {
    return list[random.next_bits() % list.size()];
}

struct Pair {
    const Kind* a = nullptr;
    const Kind* b = nullptr;
    std::vector<lod::Body<2>> bodies;
};

Pair random_pair(const std::vector<Kind>& list, lod::Random& random) {
    Pair pair{&any(list, random), &any(list, random), {}};
    pair.bodies = {body_of(*pair.a, 1, random), body_of(*pair.b, 2, random)};
    pair.bodies[0].position = {-1.5, random.next(-0.3, 0.3)};
    pair.bodies[0].velocity = {random.next(0.5, 1.5), random.next(-0.2, 0.2)};
    pair.bodies[1].position = {0, random.next(-0.3, 0.3)};
    pair.bodies[1].velocity = {random.next(-1, 0), random.next(-0.2, 0.2)};
    return pair;
}

/// What becomes of one pair by both.
struct Compared {
    std::string why;          ///< what tells the two apart
    double difference = 0;    ///< [m/s]
    double of_change = 0;     ///< over the change of velocity
    double milliseconds = 0;  ///< Box2D's impact after lodlab's
};

std::string reason(const lod::TimeOfImpact<2>& exact, const lod2d::Box2dImpact& box2d) {
    constexpr double grazing = 0.005;  // [s] what skins of a millimetre do to no other impact
    if (exact.time - box2d.time > grazing) return "skins meet, shapes pass or meet later";
    if (exact.contacts.size() > 1) return "a face on a face in both";
    if (box2d.contacts.size() > 1) return "two points only within Box2D's skin";
    const lod::Contact<2>& e = exact.contacts[0];
    const lod2d::Box2dContact& b = box2d.contacts[0];
    if (e.normal.dot(b.normal) < std::cos(0.05)) return "another normal: a corner on a corner";
    if ((e.point - b.point).norm() > 0.05) return "another corner first";
    return "one contact, the same";
}

std::optional<Compared> compare(const Pair& pair, lod2d::Box2dSettings settings) {
    const std::vector<lod::Body<2>>& bodies = pair.bodies;
    const auto touch = lod::time_of_impact(bodies[0], bodies[1]);
    const auto exact = measure::exact_collision(bodies[0], bodies[1], lod::Response::net, 1);
    const lod2d::Shape* const shapes[] = {&pair.a->shape, &pair.b->shape};
    settings.most_steps = static_cast<int>(1 / settings.time_step);
    const lod2d::Box2dImpact box2d = lod2d::run_to_impact(bodies, shapes, settings);
    if (!exact || !box2d.happened) return {};
    Compared result;
    result.why = reason(touch, box2d);
    double squared = 0;
    double change = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        squared += (box2d.after[i].velocity - exact->after[i].velocity).squaredNorm();
        change += (exact->after[i].velocity - exact->before[i].velocity).squaredNorm();
    }
    result.difference = std::sqrt(squared);
    result.of_change = std::sqrt(squared / change);
    result.milliseconds = 1e3 * (box2d.time - exact->time);
    return result;
}

double at_share(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(const std::string& name, const std::vector<Compared>& list) {
    std::vector<double> difference;
    std::vector<double> of_change;
    std::vector<double> late;
    for (const Compared& one : list) {
        difference.push_back(one.difference);
        of_change.push_back(one.of_change);
        late.push_back(one.milliseconds);
    }
    std::printf("%-38s %5zu  %.2e %.2e %.2e  %.2e  %6.2f ms\n", name.c_str(), list.size(),
                at_share(difference, 0.5), at_share(difference, 0.9), at_share(difference, 1),
                at_share(of_change, 0.5), at_share(late, 0.5));
}

/// The same pairs by a step and a scale of Box2D.
void measure_all(int wanted, std::uint64_t seed, const lod2d::Box2dSettings& settings) {
    lod::Random random(seed);
    const std::vector<Kind> list = kinds();
    std::map<std::string, std::vector<Compared>> by_reason;
    std::vector<Compared> all;
    int missed = 0;
    while (static_cast<int>(all.size()) < wanted) {
        const auto result = compare(random_pair(list, random), settings);
        if (!result) {
            ++missed;
            continue;
        }
        by_reason[result->why].push_back(*result);
        all.push_back(*result);
    }
    std::printf("%d pairs that meet (%d miss), step 1/%.0f s, skin %.2f mm: difference [m/s]\n",
                wanted, missed, 1 / settings.time_step, 10 / settings.units_per_metre);
    std::printf("%-38s %5s  %-8s %-8s %-8s  %-8s  %s\n", "", "pairs", "median", "90 %", "worst",
                "of change", "late");
    print("all", all);
    for (const auto& [why, results] : by_reason) print(why, results);
}

}  // namespace

int main(int argc, char** argv) {
    const int wanted = argc > 1 ? std::atoi(argv[1]) : 1000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    measure_all(wanted, seed, {});
    lod2d::Box2dSettings thin;
    thin.units_per_metre = 128;
    measure_all(wanted, seed, thin);
    lod2d::Box2dSettings fine = thin;
    fine.time_step = 1.0 / 7680;
    measure_all(wanted, seed, fine);
}
