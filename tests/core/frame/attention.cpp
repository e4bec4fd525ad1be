#include "lodlab/core/frame/schedule/attention.hpp"

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// The attention of pairs of bodies (0, 1), (2, 3), ...
template <int Dim>
std::vector<double> attention_of(const std::vector<Body<Dim>>& bodies, const Viewer& viewer = {}) {
    std::vector<CandidatePair> pairs;
    for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(bodies.size()); i += 2)
        pairs.push_back({i, i + 1});
    std::vector<double> attention;
    Attention<Dim>().weigh(viewer, bodies, pairs, attention);
    return attention;
}

/// Two discs of radius .5 that lie on each other.
template <int Dim>
void add_couple(std::vector<Body<Dim>>& bodies, Planar x, double speed = 0, double radius = 0.5) {
    bodies.push_back(disc<Dim>(1, radius, {x.x() - 0.1, x.y()}, {speed, 0}));
    bodies.push_back(disc<Dim>(1, radius, {x.x() + 0.1, x.y()}));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("attention is size times speed over angle, worked by hand", "[attention]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies;
    add_couple<Dim>(bodies, {0, 0});         // in the middle: tangent .5 / 10
    add_couple<Dim>(bodies, {2, 0});         // tangent .2, twice the half: a third
    add_couple<Dim>(bodies, {0, 3}, 2);      // a quarter, but three times for 2 m/s
    add_couple<Dim>(bodies, {-4, 0}, 0, 1);  // a fifth, but twice as large
    const auto attention = attention_of<Dim>(bodies);
    CHECK(attention[0] == Approx(0.05));
    CHECK(attention[1] == Approx(0.05 / 3));
    CHECK(attention[2] == Approx(0.05 * 3 / 4));
    CHECK(attention[3] == Approx(0.05 * 2 / 5));
}

TEMPLATE_TEST_CASE_SIG("attention follows the point of fixation", "[attention]", ((int Dim), Dim),
                       2, 3) {
    std::vector<Body<Dim>> bodies;
    add_couple<Dim>(bodies, {0, 0});
    add_couple<Dim>(bodies, {5, 0});
    const auto left = attention_of<Dim>(bodies, {.fixation = {0, 0, 0}});
    const auto right = attention_of<Dim>(bodies, {.fixation = {5, 0, 0}});
    CHECK(left[0] > left[1]);
    CHECK(right[1] > right[0]);
    CHECK(left[0] == Approx(right[1]));
}

TEMPLATE_TEST_CASE_SIG("other bodies near by distract", "[attention]", ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies;
    add_couple<Dim>(bodies, {0.5, 0.5});
    const double alone = attention_of<Dim>(bodies)[0];
    for (int i = 0; i < 10; ++i) bodies.push_back(disc<Dim>(1, 0.01, {0.6, 0.6}));
    CHECK(attention_of<Dim>(bodies)[0] == Approx(alone / 2));
}

TEST_CASE("what another body hides has a tenth of the attention left", "[attention]") {
    std::vector<Body<3>> bodies;
    add_couple<3>(bodies, {0.5, 0.5});
    const double seen = attention_of<3>(bodies)[0];
    bodies.push_back(disc<3>(1, 1, {0.25, 0.25}));
    bodies.push_back(disc<3>(1, 1, {0.5, 0.5}));
    bodies[2].position.z() = 5;   // between the eye at 10 and the pair
    bodies[3].position.z() = 20;  // behind the eye
    CHECK(attention_of<3>(bodies)[0] == Approx(0.1 * seen / 1.1));  // and one distractor
    bodies[2].position = {0.75, 0.75, -5};
    CHECK(attention_of<3>(bodies)[0] == Approx(seen / 1.1));
}

TEST_CASE("the eye of a viewer may stand anywhere", "[attention]") {
    std::vector<Body<3>> bodies;
    add_couple<3>(bodies, {0, 0});
    const double before = attention_of<3>(bodies)[0];
    for (const Viewer::Point eye : {Viewer::Point{10, 0, 0}, {0, 10, 0}, {0, 0, -10}, {6, 0, 8}})
        CHECK(attention_of<3>(bodies, {.eye = eye})[0] == Approx(before));
    // Who looks away sees nothing; who stands at the point looked at looks along -z.
    CHECK(attention_of<3>(bodies, {.fixation = {0, 0, 20}, .eye = Viewer::Point{0, 0, 10}})[0] ==
          0);
    CHECK(attention_of<3>(bodies, {.fixation = {0, 0, 10}, .eye = Viewer::Point{0, 0, 10}})[0] ==
          Approx(before));
}

TEMPLATE_TEST_CASE_SIG("a half-space has the attention of what meets it", "[attention]",
                       ((int Dim), Dim), 2, 3) {
    std::vector<Body<Dim>> bodies(1);
    make_static(bodies[0]);
    bodies[0].position = planar<Dim>(100, 0);
    bodies[0].tree = std::make_shared<SphereTree<Dim>>(half_space<Dim>(planar<Dim>(0, 1)));
    bodies.push_back(disc<Dim>(1, 0.5, {0, 0}));
    CHECK(attention_of<Dim>(bodies)[0] == Approx(0.05));
}
