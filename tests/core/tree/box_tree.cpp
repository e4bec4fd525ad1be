#include "lodlab/core/math/box_tree.hpp"

#include <set>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/property.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// Balls in a row along an axis, each of which touches the next.
template <int Dim>
std::vector<Sphere<Dim>> row(int count, int axis) {
    std::vector<Sphere<Dim>> balls;
    for (int i = 0; i < count; ++i) balls.push_back({i * Vector<Dim>::Unit(axis), 0.5});
    return balls;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a tree of balls' boxes names every ball that overlaps one, once",
                       "[box_tree]", ((int Dim), Dim), 2, 3) {
    check_property(41, 100, [](std::uint64_t seed) {
        Random random(seed);
        std::vector<Sphere<Dim>> balls;
        for (int i = random.below(50); i >= 0; --i)
            balls.push_back({random_vector<Dim>(random, 2), std::ldexp(1.0, -random.below(8))});
        balls.push_back(balls.front());
        balls.push_back({Vector<Dim>::Zero(), 0});
        const std::vector<Box<Dim>> boxes = boxes_of<Dim>(balls);
        BoxTree<Dim> tree(boxes);
        for (std::size_t k = 0; k < balls.size(); ++k) {
            std::multiset<std::size_t> named;
            tree.each_meeting(boxes[k], [&](std::size_t i) { named.insert(i); });
            for (std::size_t i = 0; i < balls.size(); ++i) {
                if (overlap(balls[k], balls[i])) RC_ASSERT(named.count(i) == 1u);
                RC_ASSERT(named.count(i) == (boxes[k].meets(boxes[i]) ? 1u : 0u));
            }
        }
    });
    BoxTree<Dim> none({});
    none.each_meeting(Box<Dim>(Vector<Dim>::Zero(), Vector<Dim>::Zero()),
                      [](std::size_t) { FAIL("named a ball of none"); });
}

TEMPLATE_TEST_CASE_SIG("to find each ball's neighbours takes n log n steps, however they lie",
                       "[box_tree]", ((int Dim), Dim), 2, 3) {
    const int axis = GENERATE(range(0, Dim));
    int logarithm = 10;
    for (const int count : {1024, 2048, 4096}) {
        std::vector<Sphere<Dim>> balls = row<Dim>(count, axis);
        balls.back().radius = count;  // one that meets all
        const std::vector<Box<Dim>> boxes = boxes_of<Dim>(balls);
        BoxTree<Dim> tree(boxes);
        std::size_t named = 0;
        for (const Box<Dim>& own : boxes) tree.each_meeting(own, [&](std::size_t) { ++named; });
        CHECK(named == static_cast<std::size_t>(5 * count - 6));
        CHECK(tree.steps() <= static_cast<std::uint64_t>(8 * count * logarithm));
        ++logarithm;
    }
}
