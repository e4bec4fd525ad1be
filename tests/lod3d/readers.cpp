// Each reader by itself, on bytes in memory.
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "lodlab/lod3d/source/mesh_readers.hpp"
#include "lodlab/lod3d/source/text_words.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

using Reader = FileMesh (*)(std::string_view, const std::string&, const ImportLimits&);

std::string refusal(Reader read, const std::string& bytes, const ImportLimits& limits = {}) {
    try {
        static_cast<void>(read(bytes, "dir/it.x", limits));
    } catch (const lod::Error& error) {
        const std::string line = error.what();
        CHECK(line.starts_with("dir/it.x"));
        CHECK(line.find('\n') == std::string::npos);
        return line;
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a word is a number as a whole or none", "[readers]") {
    CHECK(number_in("1.5") == 1.5);
    CHECK(number_in("+2") == 2);
    CHECK(number_in("-.5e3") == -500);
    CHECK(number_in("1e003") == 1000);
    CHECK(number_in("0,5") == 0.5);
    CHECK(number_in("0.1") == 0.1);
    CHECK(number_in("1e-400") == 0);
    CHECK(number_in("-1e400") == -std::numeric_limits<double>::infinity());
    for (const char* word : {"nan", "-nan", "-nan(ind)", "1.#QNAN", "NaN"}) {
        INFO(word);
        const auto value = number_in(word);
        REQUIRE(value);
        CHECK(std::isnan(*value));
    }
    for (const char* word : {"", "-", "+", "--1", "1x", "0,5,5", "v", "1/2", "0x10"}) {
        INFO(word);
        CHECK_FALSE(number_in(word));
    }
    const auto digits = [](const char* word) {
        return std::pair{digits_of(word).significant, digits_of(word).decimals};
    };
    CHECK(digits("-0.0250") == std::pair{3, 4});
    CHECK(digits("500000") == std::pair{6, 0});
    CHECK(digits("1.000000e+06") == std::pair{7, 0});
    CHECK(digits("25E-2") == std::pair{2, 2});
    CHECK(digits("1e99999999999") == std::pair{1, -400});
    CHECK(integer_in("-3") == -3);
    CHECK_FALSE(integer_in("3.0"));
    CHECK_FALSE(integer_in("99999999999999999999"));
}

TEST_CASE("words know their lines, whatever ends a line", "[readers]") {
    TextWords words("a b # c\r\n\rd\n e", TextWords::Comments::after_hash);
    CHECK(words.next() == "a");
    CHECK(words.next_on_line() == "b");
    CHECK(words.next_on_line().empty());
    CHECK(words.next() == "d");
    CHECK(words.line() == 3);
    CHECK(words.next() == "e");
    CHECK(words.line() == 4);
    CHECK(words.next().empty());
    CHECK(in_quotes("a\nb\x01") == "\"a?b?\"");
}

TEST_CASE("a double of a text and of a binary file arrives to the bit", "[readers]") {
    const double x = 500000.1234567890123;
    const FileMesh obj = read_obj("v 500000.1234567890123 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", "a");
    CHECK(obj.mesh.vertices[0].x() == x);
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\n"
        "property double y\nproperty double z\nelement face 1\n"
        "property list uchar uchar vertex_indices\nend_header\n";
    for (const double value : {x, 0., 0., 0., 1., 0., 0., 0., 1.}) ply += bytes_of(value);
    ply += std::string("\3\0\1\2", 4);
    const FileMesh binary = read_ply(ply, "a");
    CHECK(binary.mesh.vertices[0].x() == x);
    CHECK(binary.step == Approx(5.8e-11).epsilon(0.01));
    CHECK(binary.remarks.empty());
}

TEST_CASE("vertices come in the order of their use, and unused ones hold anything", "[readers]") {
    const FileMesh file = read_obj("v 9 nan 9\nv 0 0 1\nv 1 0 0\nv 0 1 0\nf 4 3 2\n", "a");
    CHECK(file.mesh.vertices == std::vector<Point>{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
    CHECK(file.mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("a refusal of an OBJ file says the line, why and the mend", "[readers]") {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    CHECK(
        refusal(read_obj, three + "\nf 1 2 9\n") ==
        "dir/it.x, line 5: a face names the vertex index 9, but the file has 3 vertices, numbered "
        "from 1; mend the face");
    CHECK_THAT(refusal(read_obj, three + "f 1 2 -4\n"), contains("line 4") && contains("index -4"));
    CHECK_THAT(refusal(read_obj, three + "f 1 0 2\n"), contains("line 4") && contains("index 0"));
    CHECK_THAT(refusal(read_obj, three + "f 1 b 2\n"), contains("line 4") && contains("\"b\""));
    CHECK_THAT(refusal(read_obj, "v 0 0\nf 1 1 1\n"), contains("line 1") && contains("2 numbers"));
    CHECK_THAT(refusal(read_obj, "v 0 x 0\n"), contains("line 1") && contains("\"x\""));
    CHECK_THAT(refusal(read_obj, three + "v 1 1 inf\nf 1 2 4\n"),
               contains("line 4") && contains("(1, 1, inf)"));
    CHECK_THAT(refusal(read_obj, three), contains("begin with f"));
    CHECK_THAT(refusal(read_obj, three + "surf 0 1 0 1 1 2 3\n"), contains("free-form"));
    CHECK_THAT(refusal(read_obj, std::string("\xff\xfev\0 \0", 6)), contains("UTF-16"));
}

TEST_CASE("a refusal of an STL file says what is promised and what is there", "[readers]") {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    CHECK_THAT(refusal(read_stl, binary_stl(one, 5)), contains("promises 5 triangles") &&
                                                          contains("hold 2") &&
                                                          contains("bytes 80 to 83"));
    CHECK_THAT(refusal(read_stl, binary_stl(one, 1)),
               contains("promises 1 triangles") && contains("there are 2"));
    CHECK(read_stl(binary_stl(one, 0), "a").mesh.triangles.size() == 2);
    CHECK_THAT(read_stl(binary_stl(one, 0), "a").remarks.at(0), contains("promises 0 triangles"));
    CHECK_THAT(read_stl(binary_stl(one, 2) + "made by", "a").remarks.at(0),
               contains("passed over 7 bytes"));
    CHECK_THAT(refusal(read_stl, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
               contains("line 2") && contains("cut short"));
    CHECK_THAT(refusal(read_stl,
                       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n"
                       "endfacet\n"),
               contains("line 2") && contains("1 corners"));
    CHECK_THAT(refusal(read_stl, "solid a\nfacet\nvertex 0 y 0\n"),
               contains("line 3") && contains("\"y\""));
    CHECK_THAT(refusal(read_stl, "# made by\nsolid a\n"), contains("no STL"));
    CHECK_THAT(refusal(read_stl, std::string("\0\1\2", 3)), contains("no STL"));
}

TEST_CASE("a refusal of a PLY file says the line or byte", "[readers]") {
    const std::string points =
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces =
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string ascii = "ply\nformat ascii 1.0\n" + points + faces;
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
    CHECK(read_ply(ascii + corners + "3 0 1 2\n", "a").mesh.triangles.size() == 1);
    CHECK_THAT(refusal(read_ply, ascii + corners + "3 0 1 3\n"),
               contains("line 13") && contains("index 3"));
    CHECK_THAT(refusal(read_ply, ascii + corners + "3 0 1 -1\n"), contains("index -1"));
    CHECK_THAT(refusal(read_ply, ascii + corners + "-3 0 1 2\n"), contains("negative length"));
    CHECK_THAT(refusal(read_ply, ascii + corners + "3 0 1 1.5\n"), contains("no whole number"));
    CHECK_THAT(refusal(read_ply, ascii + corners + "3 0 1\n"), contains("cut short"));
    CHECK_THAT(refusal(read_ply, ascii + "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"),
               contains("line 11") && contains("\"zero\""));
    CHECK_THAT(refusal(read_ply, ascii + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
               contains("line 11") && contains("(1, nan, 0)"));
    CHECK_THAT(refusal(read_ply, "ply\n" + points + faces), contains("no format"));
    CHECK_THAT(refusal(read_ply, "ply\nformat asci 1.0\n"), contains("line 2"));
    CHECK_THAT(refusal(read_ply, "ply\nformat ascii 1.0\nelement vertex many\n"),
               contains("line 3") && contains("\"many\""));
    CHECK_THAT(refusal(read_ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n"),
               contains("line 4") && contains("\"real\""));
    CHECK_THAT(refusal(read_ply, "ply\nformat ascii 1.0\nelement vertex 1\n"),
               contains("header does not end"));
    CHECK_THAT(refusal(read_ply,
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                       "end_header\n0\n"),
               contains("no property y"));
    CHECK_THAT(refusal(read_ply, "ply\nformat ascii 1.0\n" + points + "end_header\n" + corners),
               contains("holds no triangles"));
    CHECK_THAT(read_ply(ascii + corners + "3 0 1 2\n3 0 1 2\n", "a").remarks.at(0),
               contains("from line 14"));
}

TEST_CASE("a refusal of an OFF file says the line", "[readers]") {
    CHECK(read_off("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", "a").mesh.triangles.size() == 1);
    CHECK_THAT(refusal(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
               contains("line 6") && contains("index 3"));
    CHECK_THAT(refusal(read_off, "OFF\n3 1 0\n0 0 0\n1 a 0\n0 1 0\n3 0 1 2\n"),
               contains("line 4") && contains("\"a\""));
    CHECK_THAT(refusal(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
               contains("cut short"));
    CHECK_THAT(refusal(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
               contains("line 6") && contains("-3 corners"));
    CHECK_THAT(refusal(read_off, "OFF\nmany\n"), contains("line 2") && contains("vertices"));
    CHECK_THAT(refusal(read_off, "OFF\n-3 1 0\n"), contains("negative number of vertices"));
    CHECK_THAT(refusal(read_off, "OFF BINARY\n3 1 0\n"), contains("binary"));
    CHECK_THAT(refusal(read_off, "4nOFF\n5\n"), contains("nOFF"));
    CHECK_THAT(refusal(read_off, "mesh\n"), contains("no OFF") && contains("\"mesh\""));
    CHECK_THAT(refusal(read_off, "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), contains("no triangles"));
    CHECK_THAT(read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2 9\n", "a").remarks.at(0),
               contains("from line 7"));
}

TEST_CASE("no reader takes more than the limits allow", "[readers]") {
    const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n";
    CHECK_THAT(refusal(read_obj, faces, {.most_triangles = 1}), contains("limit of 1"));
    CHECK_THAT(refusal(read_obj, faces, {.most_seconds = 0}), contains("longer than"));
    CHECK_THAT(refusal(read_obj, faces, {.most_memory = 10}), contains("more than the limit of 0"));
    std::string wheel = "v 0 0 0\nf";
    for (int i = 0; i < 5000; ++i) wheel += " 1";
    CHECK_THAT(refusal(read_obj, wheel, {.most_triangles = 100}), contains("limit of 100"));
    CHECK_THAT(refusal(read_off, "OFF\n1 1 0\n0 0 0\n2000000000 0\n", {.most_triangles = 100}),
               contains("limit of 100"));
    CHECK_THAT(refusal(read_ply,
                       "ply\nformat ascii 1.0\nelement face 1\n"
                       "property list int int vertex_indices\nend_header\n2000000000 1 2\n"),
               contains("2000000000") || contains("1999999998"));
}

TEST_CASE("every beginning of a good file is read or refused", "[readers]") {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 3, 2}}};
    const std::pair<Reader, std::string> files[] = {{read_obj, text_of(one, "obj")},
                                                    {read_stl, text_of(one, "stl")},
                                                    {read_ply, text_of(one, "ply")},
                                                    {read_off, text_of(one, "off")}};
    for (const auto& [read, text] : files)
        for (std::size_t size = 0; size < text.size(); ++size)
            static_cast<void>(refusal(read, text.substr(0, size)));
}

TEST_CASE("bytes changed at random are read or refused", "[readers]") {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 3, 2}}};
    const std::pair<Reader, const char*> readers[] = {
        {read_obj, "obj"}, {read_stl, "stl"}, {read_ply, "ply"}, {read_off, "off"}};
    std::uint32_t state = 1;
    const auto below = [&](std::size_t count) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::size_t>(state >> 8) % count;
    };
    std::string likely = " \n\r#\\/-+.,0123456789efvnOFFinda\t\xff";
    likely += '\0';
    for (const auto& [read, format] : readers) {
        const std::string good = text_of(one, format);
        for (int round = 0; round < 3000; ++round) {
            std::string bad = good;
            for (std::size_t changes = 1 + below(4); changes > 0; --changes)
                bad[below(bad.size())] = likely[below(likely.size())];
            static_cast<void>(refusal(read, bad));
        }
    }
}
