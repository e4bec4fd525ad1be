#include <algorithm>

#include "lessons/course/06_interruption/lesson.hpp"

namespace lessons::interruption {
namespace {

using lod::Front;
using lod::NodePair;

/// The tests of the next level, one after another.
std::vector<NodePair> tests_after(const Pair& pair, const Front& front) {
    const auto next = [](const lod::SphereTree<2>& tree, int node) {
        std::vector<int> nodes;
        const auto i = lod::SphereTree<2>::index(node);
        for (int child = 0; child < tree.child_count[i]; ++child)
            nodes.push_back(tree.first_child[i] + child);
        return nodes.empty() ? std::vector<int>{node} : nodes;
    };
    std::vector<NodePair> tests;
    for (const NodePair& met : front.pairs)
        for (const int a : next(*pair.a.body.tree, met.a))
            for (const int b : next(*pair.b.body.tree, met.b)) tests.push_back({a, b});
    return tests;
}

bool meet(const Pair& pair, const NodePair& nodes) {
    return lod::overlap(viz::carried_node(pair.a.body, nodes.a),
                        viz::carried_node(pair.b.body, nodes.b));
}

/// The tests so far, and what they met.
viz::Panel draw_tests(const Pair& pair, const std::vector<NodePair>& tests) {
    viz::Panel panel;
    panel.view = viz::grown(
        box_round({viz::carried_node(pair.a.body, 0), viz::carried_node(pair.b.body, 0)}), 0.01);
    add_body(panel, pair.a, 0);
    add_body(panel, pair.b, 1);
    for (const NodePair& nodes : tests) {
        const std::array<int, 1> a{nodes.a};
        const std::array<int, 1> b{nodes.b};
        viz::add_nodes<2>(panel, pair.a.body, a, viz::Role::node, 0);
        viz::add_nodes<2>(panel, pair.b.body, b, viz::Role::node, 1);
    }
    for (const NodePair& nodes : tests)
        if (meet(pair, nodes)) {
            add_ball(panel, viz::carried_node(pair.a.body, nodes.a),
                     style(viz::Role::meeting_node, 0));
            add_ball(panel, viz::carried_node(pair.b.body, nodes.b),
                     style(viz::Role::meeting_node, 1));
        }
    return panel;
}

}  // namespace

void give_part(Lesson& lesson, const Pair& pair, const Turn& cut) {
    std::vector<NodePair> tests =
        tests_after(pair, pair.levels[static_cast<std::size_t>(cut.level - 1)]);
    const auto found = std::find_if(tests.begin(), tests.end(),
                                    [&](const NodePair& nodes) { return meet(pair, nodes); });
    give(lesson, "first overlap", count(found - tests.begin() + 1));
    give(lesson, "whole", draw_tests(pair, tests));
    tests.resize(cut.tests);
    give(lesson, "met in part", count(std::count_if(tests.begin(), tests.end(), [&](const auto& t) {
             return meet(pair, t);
         })));
    give(lesson, "part", draw_tests(pair, tests));
    give(lesson, "outlines", words(pair.touch ? "touch" : "do not touch"));
}

}  // namespace lessons::interruption
