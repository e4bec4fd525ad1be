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

TEMPLATE_TEST_CASE_SIG("a box that grew is named where it is and where it was", "[box_tree]",
                       ((int Dim), Dim), 2, 3) {
    check_property(43, 60, [](std::uint64_t seed) {
        Random random(seed);
        BoxTree<Dim> tree({});
        for (int build = 0; build < 2; ++build) {  // the second one into the storage of the first
            std::vector<Box<Dim>> boxes;
            for (int i = random.below(40); i >= 0; --i) {
                const Vector<Dim> low = random_vector<Dim>(random, 3);
                boxes.push_back({low, low + Vector<Dim>::Constant(random.in(0, 1))});
            }
            tree.build(boxes);
            for (int change = 0; change < 5; ++change) {
                const auto grown =
                    static_cast<std::size_t>(random.below(static_cast<int>(boxes.size())));
                const Vector<Dim> place = random_vector<Dim>(random, 6);
                tree.grow(grown, {place, place});
                boxes[grown].hold(place);
                for (const Box<Dim>& box : boxes) {
                    std::vector<std::size_t> expected;
                    for (std::size_t i = 0; i < boxes.size(); ++i)
                        if (boxes[i].meets(box)) expected.push_back(i);
                    std::vector<std::size_t> named;
                    tree.each_meeting(box, [&](std::size_t i) { named.push_back(i); });
                    std::ranges::sort(named);
                    RC_ASSERT(named == expected);
                }
            }
        }
    });
}
