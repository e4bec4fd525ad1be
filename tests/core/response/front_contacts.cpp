#include "lodlab/core/contact/front_contacts.hpp"

#include <algorithm>
#include <set>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// A body at rest in the origin with a root and leaves of radius 1 around `middles`, whose surfaces
/// face along `normals`.
template <int Dim>
Body<Dim> body_of(const std::vector<Planar>& middles, const std::vector<Planar>& normals) {
    std::vector<TreeNode<Dim>> nodes(1);
    nodes[0].sphere.radius = 100;
    for (std::size_t i = 0; i < middles.size(); ++i) {
        nodes[0].children.push_back(static_cast<int>(i) + 1);
        nodes.push_back({{planar<Dim>(middles[i].x(), middles[i].y()), 1.0},
                         planar<Dim>(normals[i].x(), normals[i].y()),
                         {}});
    }
    Body<Dim> body = planar_body<Dim>(1, 1);
    body.tree = std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
    return body;
}

/// The contacts of the leaves.
template <int Dim>
std::vector<Contact<Dim>> contacts(const Body<Dim>& a, const Body<Dim>& b,
                                   ContactModel model = ContactModel::node_normal) {
    return contacts_of_front<Dim>(a, b, traverse_levels(a, b).back(), {model});
}

/// A turned body of random nodes, some of which have no surface.
template <int Dim>
Body<Dim> scattered(Random& random) {
    std::vector<Planar> middles;
    std::vector<Planar> normals;
    for (int node = 0; node < 5 + random.below(20); ++node) {
        middles.emplace_back(random.in(-6, 6), random.in(-6, 6));
        const double coherence = random.below(4) == 0 ? 0 : random.in(0.8, 1);
        normals.push_back(coherence * random_unit<2>(random));
    }
    Body<Dim> body = body_of<Dim>(middles, normals);
    body.orientation = Space<Dim>::turned(body.orientation, planar_spin<Dim>(random.in(-3, 3)));
    return body;
}

/// The mean normal of one body's nodes that are connected with a node pair by pairs that share a
/// node: a flood from the pair, with sets.
template <int Dim>
std::pair<Vector<Dim>, Vector<Dim>> flooded(const Body<Dim>& a, const Body<Dim>& b,
                                            const std::vector<NodePair>& pairs, NodePair start) {
    std::set<int> of_a{start.a};
    std::set<int> of_b{start.b};
    for (std::size_t before = 0; before != of_a.size() + of_b.size();) {
        before = of_a.size() + of_b.size();
        for (const NodePair& pair : pairs)
            if (of_a.contains(pair.a) || of_b.contains(pair.b)) {
                of_a.insert(pair.a);
                of_b.insert(pair.b);
            }
    }
    const auto mean = [](const Body<Dim>& body, const std::set<int>& nodes) {
        Vector<Dim> sum = Vector<Dim>::Zero();
        double count = 0;
        for (const int node : nodes) {
            sum += body.tree->mean_normal(node);
            count += body.tree->mean_normal(node).norm() > 0;
        }
        return Vector<Dim>(Space<Dim>::rotation(body.orientation) * sum / std::max(count, 1.0));
    };
    return {mean(a, of_a), mean(b, of_b)};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a corner that sank into a face is pushed off along the face's normal",
                       "[front_contacts]", ((int Dim), Dim), 2, 3) {
    const double half = std::sqrt(0.5);
    // The two sides of A's upward corner, each flat; the underside of B above it.
    const auto corner = body_of<Dim>({{-0.5, 0}, {0.5, 0}}, {{-half, half}, {half, half}});
    const auto face = body_of<Dim>({{0.1, 1.5}}, {{0, -1}});
    const auto found = contacts(corner, face);
    REQUIRE(found.size() == 2);
    for (const Contact<Dim>& contact : found)
        CHECK((contact.normal - planar<Dim>(0, 1)).norm() < 1e-15);

    const auto by_line = contacts(corner, face, ContactModel::centre_line);
    CHECK((by_line[0].normal - planar<Dim>(0.6, 1.5).normalized()).norm() < 1e-15);
    CHECK(by_line[0].point == found[0].point);
    CHECK(by_line[0].depth == found[0].depth);
}

TEMPLATE_TEST_CASE_SIG("two places where bodies touch keep their own normals", "[front_contacts]",
                       ((int Dim), Dim), 2, 3) {
    const auto a = body_of<Dim>({{-10, 0}, {10, 0}}, {{0, 1}, {1, 0}});
    const auto b = body_of<Dim>({{-10, 1.5}, {11.5, 0}}, {{0, 0}, {0, 0}});
    const auto found = contacts(a, b);
    REQUIRE(found.size() == 2);
    CHECK(found[0].normal == planar<Dim>(0, 1));
    CHECK(found[1].normal == planar<Dim>(1, 0));
}

TEMPLATE_TEST_CASE_SIG("nodes without a surface do not blur their patch", "[front_contacts]",
                       ((int Dim), Dim), 2, 3) {
    const auto inner = body_of<Dim>({{0, 0}, {0.5, 0}, {-0.5, 0}}, {{0, 1}, {0, 0}, {0, 0}});
    const auto corner = body_of<Dim>({{0.5, 1}}, {{0.2, -0.2}});
    const auto found = contacts(inner, corner);
    REQUIRE(found.size() == 3);
    for (const Contact<Dim>& contact : found)
        CHECK((contact.normal - planar<Dim>(0, 1)).norm() < 1e-8);
}

TEMPLATE_TEST_CASE_SIG("a patch is what a flood over shared nodes reaches", "[front_contacts]",
                       ((int Dim), Dim), 2, 3) {
    Random random(41);
    FrontContacts<Dim> modeller;  // used again, for trees of any size
    int patchy = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const Body<Dim> a = scattered<Dim>(random);
        const Body<Dim> b = scattered<Dim>(random);
        const Front front = traverse_levels(a, b).back();
        PosedTree<Dim> world_a;
        PosedTree<Dim> world_b;
        world_a.pose(a);
        world_b.pose(b);
        FrontModel<Dim> found;
        modeller.model({world_a, world_b, front.pairs}, {ContactModel::node_normal},
                       pair_motion(a, b, 0), found);
        std::set<double> normals;
        for (const auto& [contact, behind] : found.contacts) {
            REQUIRE(behind.count == 1);
            const NodePair nodes = found.node_pairs[static_cast<std::size_t>(behind.first)];
            const auto [side_a, side_b] = flooded(a, b, front.pairs, nodes);
            normals.insert(side_a[0]);
            const auto expected = model_surface_contact<Dim>({world_a.sphere(nodes.a), side_a},
                                                             {world_b.sphere(nodes.b), side_b});
            CHECK((contact.normal - expected.value().normal).norm() < 1e-12);
        }
        patchy += normals.size() > 1;
    }
    CHECK(patchy > 3);
}

TEMPLATE_TEST_CASE_SIG("a face that falls flat on a face is pushed straight up at every level",
                       "[front_contacts]", ((int Dim), Dim), 2, 3) {
    // Three nodes in a row on each face, the outer ones round the corner.
    const auto low = body_of<Dim>({{-1.5, 0}, {0, 0}, {1.5, 0}}, {{-0.5, 0.5}, {0, 1}, {0.5, 0.5}});
    const auto high =
        body_of<Dim>({{-1.5, 1.9}, {0, 1.9}, {1.5, 1.9}}, {{-0.5, -0.5}, {0, -1}, {0.5, -0.5}});
    const auto found = contacts(low, high);
    REQUIRE(found.size() == 3);
    for (const Contact<Dim>& contact : found)
        CHECK((contact.normal - planar<Dim>(0, 1)).norm() < 1e-15);
}
