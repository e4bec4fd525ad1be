#include "lodlab/io/sphere_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/catch.hpp"

using namespace io;

namespace {

const lod::Vector<3> zero = lod::Vector<3>::Zero();

/// A root with two children, one of which has one child.
lod::SphereTree<3> small_tree() {
    std::vector<lod::TreeNode<3>> nodes(4);
    nodes[0] = {{lod::Vector<3>(0, 0, 0), 4}, zero, {1, 2}};
    nodes[1] = {{lod::Vector<3>(-1, 0, 0), 2}, zero, {3}};
    nodes[2] = {{lod::Vector<3>(1, 0, 0), 2.5}, zero, {}};
    nodes[3] = {{lod::Vector<3>(-1, 0.1, 0), 1}, zero, {}};
    return lod::lay_out<3>(nodes);
}

std::string text_of(const std::string& file, const lod::Vector<3>& centroid, int level = 0,
                    const std::string& name = "it") {
    const lod::SphereTree<3> tree = small_tree();
    const SphereFormat* format = sphere_format_of(file);
    REQUIRE(format);
    return format->text({tree, centroid, level, name});
}

}  // namespace

TEST_CASE("a .sph file lists the complete tree in the mesh's frame", "[export]") {
    std::istringstream text(text_of("a.sph", {10, 20, 30}));
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
    const std::string json = text_of("a.spheres.json", zero);
    CHECK_THAT(json, lodtest::contains("{\"frame\":\"mesh\",\"levels\":["));
    CHECK_THAT(json, lodtest::contains("{\"centre\":[-1.0,0.1,0.0],\"radius\":1.0}"));
    const std::string urdf = text_of("a.urdf", zero, 2, "a<b");
    CHECK_THAT(urdf, lodtest::contains("<robot name=\"a&lt;b\">"));
    CHECK_THAT(urdf, lodtest::contains("<origin xyz=\"1 0 0\" />"));
    CHECK_THAT(urdf, lodtest::contains("<sphere radius=\"2.5\" />"));
    CHECK_THAT(urdf, lodtest::contains("<sphere radius=\"1\" />"));
    CHECK_THAT(urdf, !lodtest::contains("<sphere radius=\"4\" />"));
}

TEST_CASE("a name that is no text, or has letters that XML has not, gives good XML", "[export]") {
    const auto named = [](const std::string& name) {
        const std::string urdf = text_of("a.urdf", zero, 2, name);
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

TEST_CASE("exported numbers read back to the same bits", "[export]") {
    const lod::Vector<3> centroid(0.1 + 0.2, 1e-300, -12345678.9);
    for (const SphereFormat& format : sphere_formats()) {
        const std::string text = text_of("a" + std::string(format.ending), centroid);
        std::vector<double> numbers;
        for (const char* at = text.c_str(); *at != 0;) {
            char* end = nullptr;
            numbers.push_back(std::strtod(at, &end));
            at = end == at ? at + 1 : end;
        }
        INFO(text);
        for (const double x : centroid) CHECK(std::ranges::count(numbers, x) > 0);
    }
}

TEST_CASE("the manual of the program names every format of spheres", "[export]") {
    std::ifstream file(LODLAB_SOURCE_DIR "/cli/README.md");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    for (const SphereFormat& format : sphere_formats())
        CHECK_THAT(manual, lodtest::contains("`" + std::string(format.ending) + "`"));
}
