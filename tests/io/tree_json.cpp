#include "lodlab/io/tree_json.hpp"

#include <bit>
#include <cstdlib>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/builder/fit_hull.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace io;

namespace {

/// Any finite double, of any size, denormals and both zeros included.
double any_number(lodtest::Random& random) {
    for (;;) {
        const double x = std::bit_cast<double>(random.bits());
        if (random.below(20) == 0) return random.below(2) == 0 ? 0.0 : -0.0;
        if (std::isfinite(x) && std::abs(x) < 1e150) return x;
    }
}

template <int Dim>
lod::SphereTree<Dim> random_tree(std::uint64_t seed, int size) {
    lodtest::Random random(seed);
    std::vector<lod::TreeNode<Dim>> nodes(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        auto& node = nodes[static_cast<std::size_t>(i)];
        for (int d = 0; d < Dim; ++d) {
            node.sphere.centre[d] = any_number(random);
            node.mean_normal[d] = random.in(-0.5, 0.5);
        }
        node.sphere.radius = std::abs(any_number(random));
        if (i > 0) nodes[static_cast<std::size_t>(random.below(i))].children.push_back(i);
    }
    return lod::lay_out<Dim>(nodes);
}

std::vector<std::uint64_t> bits_of(const std::vector<double>& numbers) {
    std::vector<std::uint64_t> bits;
    for (const double x : numbers) bits.push_back(std::bit_cast<std::uint64_t>(x));
    return bits;
}

const std::string good = R"({"format": "lodlab tree", "version": 2, "dim": 2, "nodes": 3,
 "levels": [1, 2], "tree": [
  {"centre": [0, 0], "radius": 2, "normal": [0, 0], "children": [1, 2]},
  {"centre": [1, 0], "radius": 1, "normal": [1, 0], "children": []},
  {"centre": [-1, 0], "radius": 1, "normal": [-1, 0], "children": []}]})";

/// The good tree with one passage replaced is refused with `why`, in one line that names the file.
void check_refused(const std::string& passage, const std::string& by, const std::string& why) {
    INFO(passage << " -> " << by);
    std::string text = good;
    const auto at = text.find(passage);
    REQUIRE(at != std::string::npos);
    text.replace(at, passage.size(), by);
    try {
        (void)tree_from_json<2>(text, "some.json");
        FAIL_CHECK("it was read");
    } catch (const lod::Error& e) {
        CHECK(e.kind() == lod::ErrorKind::input_refused);
        const std::string line = e.what();
        INFO(line);
        CHECK(line.find("some.json: ") == 0);
        CHECK(line.find(why) != std::string::npos);
        CHECK(line.find('\n') == std::string::npos);
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a tree read back from JSON is the same to the last bit", "[tree_json]",
                       ((int Dim), Dim), 2, 3) {
    for (const int size : {1, 2, 50, 1000}) {
        const auto tree = random_tree<Dim>(static_cast<std::uint64_t>(size), size);
        const std::string text = tree_to_json(tree);
        const auto read = tree_from_json<Dim>(text, "memory");
        for (std::size_t d = 0; d < Dim; ++d) {
            CHECK(bits_of(read.centre[d]) == bits_of(tree.centre[d]));
            CHECK(bits_of(read.normal[d]) == bits_of(tree.normal[d]));
        }
        CHECK(bits_of(read.radius) == bits_of(tree.radius));
        CHECK(read.first_child == tree.first_child);
        CHECK(read.child_count == tree.child_count);
        CHECK(read.parent == tree.parent);
        CHECK(read.level_begin == tree.level_begin);
        CHECK(tree_to_json(read) == text);
    }
}

TEST_CASE("a tree is saved whole and loaded again", "[tree_json]") {
    const std::string path = "tree_json_test.json";
    const auto tree = random_tree<2>(9, 20);
    save_tree(path, tree);
    CHECK(load_tree<2>(path).radius == tree.radius);
    CHECK_THROWS_AS(load_tree<2>(path, 10), lod::Error);
    std::filesystem::remove(path);
    CHECK_THROWS_AS(load_tree<2>(path), lod::Error);
    CHECK_THROWS_AS(save_tree("no/such/folder/tree.json", tree), lod::Error);
}

TEST_CASE("a file that is not such a tree is refused in one line", "[tree_json]") {
    CHECK(tree_from_json<2>(good, "good").size() == 3);
    check_refused("lodlab tree", "some tree", "format");
    check_refused("\"version\": 2", "\"version\": 3", "version 3");
    check_refused("\"version\": 2, ", "", "\"version\" is missing");
    check_refused("\"dim\": 2", "\"dim\": 3", "dimension 3");
    check_refused("\"nodes\": 3", "\"nodes\": 353000000000", "\"nodes\" is not 3");
    check_refused("\"nodes\": 3", "\"nodes\": -3", "not a whole number");
    check_refused("\"levels\": [1, 2]", "\"levels\": [1, 1, 1]", "\"levels\" is not [1,2]");
    check_refused("\"radius\": 2", "\"radius\": NaN", "not JSON");
    check_refused("\"radius\": 2", "\"radius\": 1e999", "not JSON");
    check_refused("\"radius\": 2", "\"radius\": null", "node 0: the radius is not a number");
    check_refused("\"radius\": 2", "\"radius\": -2", "node 0: the radius is negative");
    check_refused("\"radius\": 2, ", "", "node 0: the key \"radius\" is missing");
    check_refused("[1, 0], \"radius\"", "[1, 0, 0], \"radius\"", "node 1: the centre");
    check_refused("\"normal\": [1, 0]", "\"normal\": [1, 1]", "node 1: the normal is longer");
    check_refused("[1, 2]}", "[1, 3]}", "child 3 does not exist");
    check_refused("[1, 2]}", "[1, 1]}", "child 1 where 2");
    check_refused("[1, 2]}", "[1, 0]}", "child 0 where 2");
    check_refused("[1, 2]}", "[1]}", "node 2 is nobody's child");
    check_refused("[1, 2]}", "[1, -2]}", "not a whole number");
    check_refused("[1, 2]}", "[1, 2.5]}", "not a whole number");
    check_refused("\"children\": []},", "\"children\": [1]},", "child 1 where 3");
    check_refused("\"tree\": [", "\"tree\": {\"a\": [", "not JSON");
    check_refused("{\"format\"", "[{\"format\"", "not JSON");
    CHECK_THROWS_AS(tree_from_json<2>("", "empty"), lod::Error);
    CHECK_THROWS_AS(tree_from_json<2>("[]", "list"), lod::Error);
    CHECK_THROWS_AS(tree_from_json<2>(std::string(100000, '['), "deep"), lod::Error);
}

TEST_CASE("a tree's hulls come back to the last bit", "[tree_json]") {
    lodtest::Random random(77);
    for (int trial = 0; trial < 20; ++trial) {
        lod::SphereTree<3> tree = random_tree<3>(static_cast<std::uint64_t>(800 + trial), 9);
        std::vector<char> covered(9, 0);
        for (int node = 0; node < tree.size(); ++node) {
            const auto at = tree.index(node);
            if (node > 0) covered[at] = covered[tree.index(tree.parent[at])];
            if (covered[at] != 0) {
                tree.hulls.add({});
                continue;
            }
            std::vector<lod::Vector<3>> points;
            for (int i = 0; i < 12; ++i)
                points.push_back({random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)});
            lod::Hull<3> hull = lod::fit_hull<3>(points, points, {}, 1e-9);
            hull.inner.assign(hull.faces.size(), false);
            hull.inner[0] = random.below(2) == 0;
            hull.cut.assign(hull.corners.size(), false);
            hull.cut[1] = random.below(2) == 0;
            hull.tight = random.below(4) == 0;
            covered[at] = hull.tight;
            tree.hulls.add(hull);
        }
        tree.hulls.find_best(tree.parent);
        tree.hulls.entry_level = 1;
        const std::string text = tree_to_json(tree);
        const lod::SphereTree<3> again = tree_from_json<3>(text, "hulls.json");
        CHECK(lod::tree_hash(again) == lod::tree_hash(tree));
        CHECK(tree_to_json(again) == text);
    }
}

TEST_CASE("a hull that is none is refused by the node that has it", "[tree_json]") {
    const std::string hull = R"("children": [1, 2], "hull": {"corners": [[0, 0], [1, 0], [0, 1]],
     "faces": [[0, 1], [1, 2], [2, 0]], "tight": true, "inner": []}})";
    std::string text = good;
    const std::string before = R"("children": [1, 2]})";
    text.replace(text.find(before), before.size(), hull);
    const std::string levels = R"("levels": [1, 2],)";
    text.replace(text.find(levels), levels.size(), levels + R"( "entry_level": 0,)");
    CHECK(tree_from_json<2>(text, "some.json").hulls.best(2) == 0);
    const auto refused = [&](const std::string& passage, const std::string& by,
                             const std::string& why) {
        std::string bad = text;
        REQUIRE(bad.find(passage) != std::string::npos);
        bad.replace(bad.find(passage), passage.size(), by);
        CHECK_THROWS_WITH(tree_from_json<2>(bad, "some.json"), lodtest::contains(why));
    };
    refused("[2, 0]]", "[3, 0]]", "node 0: the hull: corner 3 does not exist");
    refused("[2, 0]]", "[2]]", "node 0: the hull: a face has too few corners");
    refused("[[0, 0], ", "[", "node 0: the hull: it encloses nothing");
    refused("\"inner\": []", "\"inner\": [7]", "node 0: the hull: face 7 does not exist");
    refused("\"inner\": []", "\"inner\": [], \"cut\": [3]",
            "node 0: the hull: corner 3 does not exist");
    refused("\"tight\": true, ", "", "node 1: the key \"hull\" is missing");
    refused("\"entry_level\": 0", "\"entry_level\": 2", "the entry level is 2");
}
