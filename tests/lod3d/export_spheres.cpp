#include "lodlab/lod3d/solid/export_spheres.hpp"

#include <sstream>

#include "tests/catch.hpp"

using namespace lod3d;

namespace {

/// A root with two children, one of which has one child.
lod::SphereTree<3> small_tree() {
    std::vector<lod::TreeNode<3>> nodes(4);
    nodes[0] = {{Point(0, 0, 0), 4}, Point::Zero(), {1, 2}};
    nodes[1] = {{Point(-1, 0, 0), 2}, Point::Zero(), {3}};
    nodes[2] = {{Point(1, 0, 0), 2.5}, Point::Zero(), {}};
    nodes[3] = {{Point(-1, 0.1, 0), 1}, Point::Zero(), {}};
    return lod::lay_out<3>(nodes);
}

}  // namespace

TEST_CASE("a .sph file lists the complete tree in the mesh's frame", "[export]") {
    std::istringstream text(spheres_to_sph(small_tree(), Point(10, 20, 30)));
    int levels = 0;
    int branching = 0;
    text >> levels >> branching;
    CHECK(levels == 3);
    CHECK(branching == 2);
    std::vector<std::array<double, 5>> lines;
    for (std::array<double, 5> n; text >> n[0] >> n[1] >> n[2] >> n[3] >> n[4];) lines.push_back(n);
    REQUIRE(lines.size() == 1 + 2 + 4);
    CHECK(lines[0] == std::array<double, 5>{10, 20, 30, 4, 1});
    CHECK(lines[2] == std::array<double, 5>{11, 20, 30, 2.5, 1});
    CHECK(lines[3] == std::array<double, 5>{9, 20.1, 30, 1, 1});
    CHECK(lines[4][3] == 0);  // no such node
    CHECK(lines[6][3] == 0);
}

TEST_CASE("JSON and URDF list each level's spheres and the leaves above it", "[export]") {
    const std::string json = spheres_to_json(small_tree(), Point::Zero());
    CHECK_THAT(json, lodtest::contains("\"frame\": \"mesh\""));
    CHECK_THAT(json, lodtest::contains("{\"centre\": [-1, 0.1, 0], \"radius\": 1}"));
    const std::string urdf = spheres_to_urdf(small_tree(), Point::Zero(), 2, "a<b");
    CHECK_THAT(urdf, lodtest::contains("<robot name=\"a&lt;b\">"));
    CHECK_THAT(urdf,
               lodtest::contains("<origin xyz=\"1 0 0\"/><geometry><sphere radius=\"2.5\"/>"));
    CHECK_THAT(urdf, lodtest::contains("<sphere radius=\"1\"/>"));
    CHECK_THAT(urdf, !lodtest::contains("<sphere radius=\"4\"/>"));
}

TEST_CASE("a name that is no text, or has letters that XML has not, gives good XML", "[export]") {
    const auto named = [](const std::string& name) {
        const std::string urdf = spheres_to_urdf(small_tree(), Point::Zero(), 2, name);
        const std::string begin = "<?xml version=\"1.0\"?>\n<robot name=\"";
        REQUIRE(urdf.starts_with(begin));
        return urdf.substr(begin.size(), urdf.find("\">\n") - begin.size());
    };
    const std::string unknown = "\xEF\xBF\xBD";
    CHECK(named("b\xC3\xB6x \xF0\x9F\x8E\xB2") == "b\xC3\xB6x \xF0\x9F\x8E\xB2");
    CHECK(named("n\xFF\xC3") == "n" + unknown + unknown);
    CHECK(named("\x01\n&\"") == unknown + unknown + "&amp;&quot;");
    CHECK(named("\xED\xA0\x80") == unknown + unknown + unknown);  // half of a pair
    CHECK(named("\xC0\xAF") == unknown + unknown);                // longer than needed
    CHECK(named("\xEF\xBF\xBF") == unknown);
}
