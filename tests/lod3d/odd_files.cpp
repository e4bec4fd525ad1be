// What programs write beyond what the formats say.
#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/solid/solid.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "lodlab/lod3d/source/mesh_readers.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"
#include "tests/text.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

const Mesh& box() {
    static const Mesh made = lod::make_from_spec(generators(), "box:2,3,4");
    return made;
}

std::string stl_text() {
    std::ostringstream out;
    out << "solid box\n";
    for (std::size_t t = 0; t < box().triangles.size(); ++t) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (int k = 0; k < 3; ++k) {
            const Point p = box().corner(t, k);
            out << "vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid box\n";
    return out.str();
}

template <class Index>
std::string binary_ply(const std::string& type) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty int64 id\nproperty "
        "double x\nproperty double y\nproperty double z\nelement face 12\nproperty uint64 "
        "id\nproperty list uchar " +
        type + " vertex_indices\nend_header\n";
    for (const Point& p : box().vertices) {
        bytes += bytes_of(std::int64_t{-1});
        for (int d = 0; d < 3; ++d) bytes += bytes_of(p[d]);
    }
    for (const Triangle& t : box().triangles) {
        bytes += bytes_of(~std::uint64_t{0}) + '\3';
        for (const std::int32_t v : t) bytes += bytes_of(static_cast<Index>(v));
    }
    return bytes;
}

double volume_of(const FileMesh& file) {
    CHECK(file.remarks.empty());
    const Solid solid = make_solid("it", file.mesh);
    CHECK(solid.mended.empty());
    return solid.volume;
}

template <class Read>
std::string refusal(const Read& read, const std::string& bytes) {
    try {
        static_cast<void>(read(bytes, "it.x", ImportLimits()));
    } catch (const lod::Error& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("PLY's whole numbers of 64 bits are read, or passed over, in their eight bytes",
          "[odd_files]") {
    CHECK(volume_of(read_ply(binary_ply<std::int32_t>("int"), "it.ply")) == Approx(24));
    CHECK(volume_of(read_ply(binary_ply<std::int64_t>("int64"), "it.ply")) == Approx(24));
    CHECK(volume_of(read_ply(binary_ply<std::uint64_t>("uint64"), "it.ply")) == Approx(24));
    const std::string text = replaced(text_of(box(), "ply"), "float", "int64");
    CHECK_THAT(refusal(read_ply, replaced(text, "int64 z", "int128 z")),
               contains("line 6: a property has the type \"int128\""));
}

TEST_CASE("the ends of STL may be two words", "[odd_files]") {
    const std::string two = replaced(stl_text(), "\nend", "\nend ");
    CHECK(volume_of(read_stl(two, "it.stl")) == Approx(24));
    CHECK(volume_of(read_stl(replaced(two, "\nend ", " END\t"), "it.stl")) == Approx(24));
    CHECK_THAT(refusal(read_stl, replaced(two, "end facet\n", "")),
               contains("line 2: a facet does not end before the next"));
}

TEST_CASE("a semicolon may end a line of OBJ, and no statement follows it there", "[odd_files]") {
    const std::string text = text_of(box(), "obj");
    for (const char* end : {";\n", " ;\n", "; # note\n"})
        CHECK(volume_of(read_obj(replaced(text, "\n", end), "it.obj")) == Approx(24));
    CHECK_THAT(refusal(read_obj, "v 0 0 0; v 1 0 0\n"),
               contains("line 1: has \"v\" after a semicolon; begin a new line there"));
}

TEST_CASE("strips that repeat a PLY file's faces are passed over, others are read", "[odd_files]") {
    const auto with_strips = [](const std::string& strips) {
        return replaced(text_of(box(), "ply"), "end_header",
                        "element tristrips 1\nproperty list int int vertex_indices\nend_header") +
               strips;
    };
    const Triangle first = box().triangles[0];
    const std::string one = "3 " + std::to_string(first[0]) + ' ' + std::to_string(first[1]) + ' ' +
                            std::to_string(first[2]) + '\n';
    const FileMesh repeated = read_ply(with_strips(one), "it.ply");
    REQUIRE(repeated.remarks.size() == 1);
    CHECK_THAT(repeated.remarks[0], contains("passed over its tristrips"));
    CHECK(repeated.mesh.triangles.size() == 12);
    // A strip of its own: three corners that no face has together.
    const FileMesh other = read_ply(with_strips("3 0 7 3\n"), "it.ply");
    CHECK(other.remarks.empty());
    CHECK(other.mesh.triangles.size() == 13);
}
