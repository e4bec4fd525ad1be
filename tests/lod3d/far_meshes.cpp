// A part far from the origin keeps the digits that its file holds.
#include <cmath>
#include <iomanip>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/sphere_files.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

/// A cube of side 1, turned, with its centre at (by, by, by).
Mesh turned_cube(double by) {
    Mesh cube = lod::make_from_spec(generators(), "box:1,1,1");
    // Rows of a rotation: two thirds and a third, exact but for the rounding of a third.
    const Point x = Point(2, -1, 2) / 3;
    const Point y = Point(2, 2, -1) / 3;
    const Point z = Point(-1, 2, 2) / 3;
    for (Point& p : cube.vertices) p = Point(x.dot(p), y.dot(p), z.dot(p)) + Point(by, by, by);
    return cube;
}

std::string all_digits(const Mesh& mesh, const std::string& format, int digits = 17) {
    std::ostringstream out;
    out << std::setprecision(digits);
    const auto corner = [&](const Point& p) {
        out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    };
    const auto triangle = [&](const Triangle& t, int first) {
        out << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
    };
    if (format == "stl") {
        out << "solid\n";
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            out << "facet normal 0 0 0 outer loop\n";
            for (int k = 0; k < 3; ++k) {
                out << "vertex ";
                corner(mesh.corner(t, k));
            }
            out << "endloop endfacet\n";
        }
        return out.str();
    }
    const bool obj = format == "obj";
    if (format == "off") out << "OFF\n8 12 0\n";
    if (format == "ply")
        out << "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
               "property double z\nelement face 12\nproperty list uchar int "
               "vertex_index\nend_header\n";
    for (const Point& p : mesh.vertices) {
        if (obj) out << "v ";
        corner(p);
    }
    for (const Triangle& t : mesh.triangles) {
        out << (obj ? "f " : "3 ");
        triangle(t, obj ? 1 : 0);
    }
    return out.str();
}

}  // namespace

TEST_CASE("a turned cube far away has its volume, or a remark says what its file holds", "[far]") {
    const Folder folder;
    for (const std::string format : {"obj", "ply", "stl", "off"})
        for (int power = 0; power <= 8; ++power) {
            INFO(format << " at 1e" << power);
            const Mesh cube = turned_cube(std::pow(10.0, power));
            const FileMesh file =
                read_mesh(folder.write("far." + format, all_digits(cube, format)));
            const Solid solid = make_solid("far", file.mesh);
            // 8 corners, each within half a step: a face of area 1 moves by no more than that.
            const double step = std::ldexp(1.0, std::ilogb(std::pow(10.0, power) + 1) - 52);
            CHECK(std::abs(solid.volume - 1) < 1e-14 + 6 * step);
            CHECK(file.remarks.empty() == (power <= 6));
        }
}

TEST_CASE("32-bit numbers far away are said to hold few digits", "[far]") {
    const Folder folder;
    const auto remarks = [&](double by) {
        return read_mesh(folder.write("stl", turned_cube(by))).remarks;
    };
    CHECK(remarks(0).empty());
    REQUIRE(remarks(1e4).size() == 1);
    CHECK_THAT(remarks(1e4)[0], contains("0.00098 m apart") && contains("far from the origin"));
    try {
        static_cast<void>(make_solid("it", load_mesh(folder.write("stl", turned_cube(1e9)))));
        FAIL("accepted");
    } catch (const lod::Error& error) {
        CHECK_THAT(error.what(), contains("two equal corners") && contains("write more digits"));
    }
}

TEST_CASE("a text that writes few digits far away is said to hold few", "[far]") {
    const Folder folder;
    const auto remarks = [&](double by, int digits) {
        std::string text = all_digits(turned_cube(by), "obj", digits);
        return read_mesh(folder.write("few.obj", text)).remarks;
    };
    CHECK(remarks(0, 7).empty());
    CHECK(remarks(1e4, 17).empty());
    REQUIRE(remarks(1e4, 7).size() == 1);  // 9999.543 and 10000.12
    CHECK_THAT(remarks(1e4, 7)[0], contains("are 0.001 m apart"));
    const Mesh box = lod::make_from_spec(generators(), "box:1,1,1");
    Mesh meant = box;
    for (Point& p : meant.vertices) p += Point::Constant(250);
    CHECK(read_mesh(folder.write("few.obj", all_digits(meant, "obj", 17))).remarks.empty());
}

TEST_CASE("whole numbers far away are exact, those that %g rounded to whole ones are not",
          "[far]") {
    const Folder folder;
    const auto remarks = [&](const std::string& first) {
        std::string text = "v " + first + " 0 0\n";
        for (const char* rest : {"1000002 0 0", "1000000 3 0", "1000002 3 0", "1000000 0 4",
                                 "1000002 0 4", "1000000 3 4", "1000002 3 4"})
            text += "v " + std::string(rest) + "\n";
        return read_mesh(folder.write("whole.obj", text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\n"
                                                          "f 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"))
            .remarks;
    };
    CHECK(remarks("1000000").empty());
    REQUIRE(remarks("1e+06").size() == 1);
    CHECK_THAT(remarks("1e+06")[0], contains("are 1 m apart"));
}

TEST_CASE("what assimp reads is said to be in 32-bit numbers", "[far]") {
    const Folder folder;
    const FileMesh file = read_mesh(folder.write("gltf", turned_cube(0)));
    REQUIRE(file.remarks.size() == 1);
    CHECK_THAT(file.remarks[0], contains("32-bit") && contains("certificate"));
}

TEST_CASE("a solid far away is the solid at the origin, moved", "[far]") {
    // Steps of 1/1024 are kept exactly up to 2^42.
    Mesh ball = lod::make_from_spec(generators(), "gear:7");
    for (Point& p : ball.vertices)
        for (int d = 0; d < 3; ++d) p[d] = std::round(1024 * p[d]) / 1024;
    const Point far(4e6, -3e9, 1e5);
    Mesh moved = ball;
    for (Point& p : moved.vertices) p += far;
    const Solid here = make_solid("here", ball);
    const Solid there = make_solid("there", moved);
    CHECK(there.volume == Approx(here.volume).epsilon(1e-13));
    CHECK((there.centroid - far - here.centroid).cwiseAbs().maxCoeff() < 1e-6);
    for (std::size_t v = 0; v < here.mesh.vertices.size(); ++v) {
        CHECK((there.mesh.vertices[v] - here.mesh.vertices[v]).norm() < 1e-6);
        CHECK(there.mesh.vertices[v] + there.centroid == moved.vertices[v]);  // to the bit
    }
}

TEST_CASE("exported spheres cover a mesh in the frame of its file, however far", "[far]") {
    const double by = 1e8;
    const Mesh mesh = turned_cube(by);
    const Solid solid = make_solid("far", mesh);
    TreeSettings settings;
    settings.builder = Builder::octree;
    settings.depth = 2;
    const lod::SphereTree<3> tree = build_tree(solid, settings);
    const std::string text =
        io::sphere_format_of("far.sph")->text({tree, solid.centroid, 0, solid.name});
    std::istringstream in(text);
    int levels = 0;
    int branching = 0;
    in >> levels >> branching;
    std::vector<lod::Sphere<3>> leaves;
    int number = 0;
    for (double x, y, z, r, one; in >> x >> y >> z >> r >> one; ++number)
        if (number >= 9 && r > 0) leaves.push_back({Point(x, y, z), r});
    for (const Point& p : mesh.vertices)
        CHECK(std::any_of(leaves.begin(), leaves.end(), [&](const auto& ball) {
            return (p - ball.centre).norm() <= ball.radius;
        }));
}

TEST_CASE("a size asked for does not cost a far part its digits", "[far]") {
    SolidOptions options;
    options.longest_side = 2;
    Mesh box = lod::make_from_spec(generators(), "box:1,1,1");
    for (Point& p : box.vertices) p += Point::Constant(1e6);
    const Solid solid = make_solid("it", box, options);
    CHECK(solid.volume == Approx(8).epsilon(1e-15));
    CHECK(solid.centroid.isApprox(Point::Constant(2e6), 1e-15));
}
