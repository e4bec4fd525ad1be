// What programs write into mesh files: a box of 2 x 3 x 4 in many ways, and what refuses it.
#include <functional>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/solid.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/mesh_files.hpp"
#include "tests/text.hpp"

using namespace lod3d;
using namespace lodtest;

namespace {

/// A file by its ending and bytes, and what becomes of it: a volume, or words of the refusal.
struct Case {
    std::string what;
    std::string ending;
    std::string bytes;
    double volume = 0;       ///< 0: refused
    std::string words = {};  ///< of the refusal, or of a remark
};

const std::vector<std::vector<int>> quads{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

const Mesh quads_cut = [] {
    Mesh mesh;
    for (int v = 0; v < 8; ++v) mesh.vertices.emplace_back(v % 2 * 2, v / 2 % 2 * 3, v / 4 * 4);
    for (const std::vector<int>& q : quads) {
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}();

/// Every vertex as "BEFORE x y z AFTER".
std::string points(const std::string& before = "", const std::string& after = "\n") {
    std::string text;
    for (const Point& p : quads_cut.vertices) {
        text += before;
        for (int d = 0; d < 3; ++d)
            text += std::to_string(static_cast<int>(p[d])) + (d < 2 ? " " : "");
        text += after;
    }
    return text;
}

/// Every face as "BEFORE a b c d AFTER", a corner as word(its number).
std::string faces(const std::string& before, const std::function<std::string(int)>& word,
                  const std::string& after = "\n") {
    std::string text;
    for (const std::vector<int>& quad : quads) {
        text += before;
        for (const int corner : quad) text.append(" ").append(word(corner));
        text += after;
    }
    return text;
}

const auto from_zero = [](int corner) { return std::to_string(corner); };
const auto from_one = [](int corner) { return std::to_string(corner + 1); };

/// The faces of an OBJ file turned over, each from the given corner of it on.
std::string other_sides(std::size_t first) {
    std::string text;
    for (const std::vector<int>& quad : quads) {
        text += "f";
        for (std::size_t k = 4; k > 0; --k)
            text.append(" ").append(from_one(quad[(first + k) % 4]));
        text += "\n";
    }
    return text;
}

const std::string obj_faces = faces("f", from_one);
const std::string off_faces = faces("4", from_zero);

/// The box as an STL text, by what stands around the vertices.
std::string stl_text(const std::string& first, const std::string& facet_end = "endfacet\n",
                     const std::string& last = "endsolid\n", const std::string& vertex = "vertex ",
                     const std::string& vertex_end = "\n") {
    std::string text = first;
    for (std::size_t t = 0; t < quads_cut.triangles.size(); ++t) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (int k = 0; k < 3; ++k) {
            const Point& p = quads_cut.corner(t, k);
            text += vertex + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                    std::to_string(p.z()) + vertex_end;
        }
        text += "endloop\n" + facet_end;
    }
    return text + last;
}

std::string ply_head(const std::string& format, const std::string& vertex_count,
                     const std::string& more_vertex = "",
                     const std::string& face_list = "uchar int") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertex_count +
           "\nproperty double x\nproperty double y\nproperty double z\n" + more_vertex +
           "element face 6\nproperty list " + face_list + " vertex_indices\n";
}

template <class Index, class Count>
std::string ply_binary(const std::string& format, const std::string& list, bool turned) {
    std::string bytes = ply_head(format, "8", "", list) + "end_header\n";
    const auto add = [&](auto value) {
        std::string own = bytes_of(value);
        if (turned) own = std::string(own.rbegin(), own.rend());
        bytes += own;
    };
    for (const Point& p : quads_cut.vertices)
        for (int d = 0; d < 3; ++d) add(p[d]);
    for (const std::vector<int>& quad : quads) {
        add(static_cast<Count>(4));
        for (const int corner : quad) add(static_cast<Index>(corner));
    }
    return bytes;
}

std::vector<Case> obj_cases() {
    const std::string v = points("v ");
    return {
        {"plain", "obj", v + obj_faces, 24},
        {"byte order mark", "obj", "\xef\xbb\xbf" + v + obj_faces, 24},
        {"carriage returns only", "obj", replaced(v + obj_faces, "\n", "\r"), 24},
        {"CR LF and blank lines", "obj", replaced(v + obj_faces, "\n", "\r\n\r\n"), 24},
        {"tabs", "obj", replaced(v + obj_faces, " ", "\t"), 24},
        {"indented", "obj", "   " + replaced(v + obj_faces, "\n", "\n  \t"), 24},
        {"comments after everything", "obj", replaced(v + obj_faces, "\n", " # 1 2 3\n"), 24},
        {"a comment that ends in a backslash", "obj", "# C:\\parts\\\n" + v + obj_faces, 24},
        {"names that end in a backslash", "obj", "o a\\\n" + v + "usemtl b\\\n" + obj_faces, 24},
        {"every statement continued", "obj",
         replaced(replaced(v + obj_faces, " 0 ", " \\\n 0 \\\n "), "f 1 ", "f \\\n1 "), 24},
        {"a continuation glued to a word", "obj", v + replaced(obj_faces, "f 1 ", "f 1\\\n "), 24},
        {"continuation with CR LF", "obj",
         replaced(v + replaced(obj_faces, "f 1 ", "f 1 \\\n "), "\n", "\r\n"), 24},
        {"v/vt", "obj", v + "vt 0 0\n" + faces("f", [](int c) { return from_one(c) + "/1"; }), 24},
        {"v//vn", "obj", v + "vn 0 0 1\n" + faces("f", [](int c) { return from_one(c) + "//1"; }),
         24},
        {"missing v/vt/vn", "obj", v + faces("f", [](int c) { return from_one(c) + "/9/9"; }), 24},
        {"negative", "obj", v + faces("f", [](int c) { return std::to_string(c - 8); }), 24},
        {"colours", "obj", points("v ", " 0.5 0.25 1\n") + obj_faces, 24},
        {"a weight of two halves all", "obj", points("v ", " 2\n") + obj_faces, 3},
        {"a weight of 0", "obj", points("v ", " 0\n") + obj_faces, 0, "not finite"},
        {"the keyword fo", "obj", v + replaced(obj_faces, "f", "fo"), 24},
        {"curves and surfaces besides", "obj",
         v + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nvp 1 2\n" + obj_faces, 24},
        {"lines and points besides", "obj", v + obj_faces + "l 1 8\np 3\n", 24},
        {"faces before vertices", "obj", obj_faces + v, 24},
        {"decimal commas", "obj", replaced(points("v ", ",0\n"), " ", " ") + obj_faces, 24},
        {"no end of the last line", "obj", v + obj_faces.substr(0, obj_faces.size() - 1), 24},
        {"an unused vertex that is no number", "obj", v + "v nan inf 1e999\n" + obj_faces, 24},
        {"a used vertex that is no number", "obj", replaced(v, "v 2 3 4", "v 2 nan 4") + obj_faces,
         0, "line 8: vertex 8 is (2, nan, 4)"},
        {"a corner twice", "obj", v + replaced(obj_faces, "f 1 3 4 2", "f 1 1 3 4 2 1"), 24},
        {"two numbers", "obj", "v 0 0 0\nv 2 0 0\nv 1 2\n" + obj_faces, 0,
         "line 3: a vertex has 2"},
        {"vertices only", "obj", v, 0, "holds no triangles"},
        {"UTF-16", "obj", std::string("\xff\xfe") + v + obj_faces, 0, "UTF-16"},
        {"a PLY file", "obj", ply_head("ascii", "8"), 0, "end in .ply"},
        {"an open box", "obj", v + obj_faces.substr(0, obj_faces.rfind("f")), 0,
         "4 edges with one triangle only, the first from (2, 3, 0) to (2, 0, 0)"},
        {"both sides of every face", "obj", v + obj_faces + other_sides(0), 24, "doubled"},
        {"both sides, cut otherwise", "obj", v + obj_faces + other_sides(1), 0, "doubled"},
        {"both sides, open", "obj", v + "f 1 3 4 2\nf 1 2 4 3\nf 5 6 8 7\nf 5 7 8 6\n", 0,
         "its faces are doubled"},
        {"both sides of one square", "obj", v + "f 1 3 4 2\nf 3 1 2 4\n", 0, "flat"},
    };
}

std::vector<Case> stl_cases() {
    const std::string binary = binary_stl(quads_cut, 12);
    std::string solid = binary;
    solid.replace(0, 11, "solid thing");
    const auto upper = [](std::string text) {
        for (char& c : text) c = static_cast<char>(std::toupper(c));
        return text;
    };
    return {
        {"plain text", "stl", stl_text("solid a\n"), 24},
        {"upper case", "stl", upper(stl_text("solid a\n")), 24},
        {"Solid", "stl", stl_text("Solid a\n"), 24},
        {"blank lines and blanks first", "stl", stl_text("\n\n   solid a\n"), 24},
        {"byte order mark", "stl", stl_text("\xef\xbb\xbfsolid a\n"), 24},
        {"tab after solid, CR LF", "stl", replaced(stl_text("solid\ta\n"), "\n", "\r\n"), 24},
        {"no name, no end", "stl", stl_text("solid\n", "endfacet\n", ""), 24},
        {"a name like the keywords", "stl", stl_text("solid facet vertex endloop\n"), 24},
        {"all in one line", "stl", replaced(stl_text("solid a\n"), "\n", " "), 24},
        {"numbers after a vertex", "stl",
         stl_text("solid a\n", "endfacet\n", "endsolid\n", "vertex ", " 0.5 0.5 1\n"), 24},
        {"two solids", "stl", stl_text("solid a\n") + stl_text("solid b\n"), 24, "repeated"},
        {"an attribute after a facet", "stl", stl_text("solid a\n", "endfacet # 7\n"), 24},
        {"a facet that does not end", "stl", stl_text("solid a\n", "\n"), 0, "does not end"},
        {"plain binary", "stl", binary, 24},
        {"binary that begins with solid", "stl", solid, 24},
        {"binary with a tail", "stl", solid + "made by", 24, "passed over 7 bytes"},
        {"binary with a tail of a record's length", "stl", binary + std::string(50, '\0'), 24,
         "passed over 50 bytes"},
        {"binary that counts none", "stl", binary_stl(quads_cut, 0), 24, "promises 0 triangles"},
        {"binary that counts too few", "stl", binary_stl(quads_cut, 11), 0, "there are 12"},
        {"binary that counts too many", "stl", binary_stl(quads_cut, 13), 0, "hold 12"},
        {"binary cut short", "stl", solid.substr(0, solid.size() - 2), 0, "hold 11"},
        {"only a header", "stl", binary.substr(0, 80), 0, "no STL"},
        {"another text", "stl", "# made by\n" + stl_text("solid a\n"), 0, "no STL"},
    };
}

std::vector<Case> ply_cases() {
    const std::string head = ply_head("ascii", "8");
    const std::string body = points() + off_faces;
    const std::string end = "end_header\n";
    return {
        {"plain", "ply", head + end + body, 24},
        {"CR LF", "ply", replaced(head + end + body, "\n", "\r\n"), 24},
        {"carriage returns only", "ply", replaced(head + end + body, "\n", "\r"), 24},
        {"runs of blanks and blank lines", "ply",
         replaced(replaced(head + end + body, " ", "   "), "end_header\n", "end_header\n\n \n"),
         24},
        {"all numbers in one line", "ply", head + end + replaced(body, "\n", " "), 24},
        {"comments", "ply", replaced(head, "element", "comment element x 9\nelement") + end + body,
         24},
        {"more of a vertex", "ply",
         ply_head("ascii", "8", "property uchar red\nproperty list uchar float w\n") + end +
             points("", " 255 2 0.5 1\n") + off_faces,
         24},
        {"more of a face", "ply",
         head + "property uchar flags\nproperty list uchar float texcoord\n" + end + points() +
             faces("4", from_zero, " 7 2 0.5 0.5\n"),
         24},
        {"elements that mean nothing here", "ply",
         replaced(head, "element face",
                  "element edge 2\nproperty int a\nproperty int b\nelement face") +
             end + points() + "0 1\n1 2\n" + off_faces,
         24},
        {"faces before vertices", "ply",
         "ply\nformat ascii 1.0\nelement face 6\nproperty list uchar int vertex_index\nelement "
         "vertex "
         "8\nproperty float z\nproperty float y\nproperty float x\nend_header\n" +
             off_faces + points(),
         24, "inside-out"},  // z, y, x mirror it
        {"unused vertices that are no numbers", "ply",
         ply_head("ascii", "9") + end + points() + "nan -nan(ind) inf\n" + off_faces, 24},
        {"a list by another name", "ply", replaced(head, "vertex_indices", "corners") + end + body,
         24},
    };
}

std::vector<Case> ply_binary_cases() {
    return {
        {"little-endian", "ply",
         ply_binary<std::int32_t, std::uint8_t>("binary_little_endian", "uchar int", false), 24},
        {"big-endian", "ply",
         ply_binary<std::int32_t, std::uint8_t>("binary_big_endian", "uchar int", true), 24},
        {"indices of a byte", "ply",
         ply_binary<std::uint8_t, std::int32_t>("binary_little_endian", "int uint8", false), 24},
        {"indices of two bytes", "ply",
         ply_binary<std::int16_t, std::uint16_t>("binary_big_endian", "ushort short", true), 24},
        {"indices that are floats", "ply",
         ply_binary<float, std::uint8_t>("binary_little_endian", "uchar float", false), 24},
        {"binary with a tail", "ply",
         ply_binary<std::uint32_t, std::int8_t>("binary_little_endian", "char uint", false) +
             "tail",
         24, "passed over 4 bytes"},
        {"binary cut short", "ply",
         ply_binary<std::uint32_t, std::int8_t>("binary_little_endian", "char uint", false)
             .substr(0, 400),
         0, "cut short"},
    };
}

std::vector<Case> ply_odd_cases() {
    const std::string head = ply_head("ascii", "8");
    const std::string body = points() + off_faces;
    const std::string end = "end_header\n";
    const std::string strips_head =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    return {
        {"strips with restarts", "ply",
         strips_head + points() +
             "29 0 2 1 3 -1 4 5 6 7 -1 0 1 4 5 -1 2 6 3 7 -1 0 4 2 6 -1 1 3 5 7\n",
         24},
        {"strips besides no faces", "ply",
         replaced(strips_head, "element trist", "element face 0\nelement trist") + points() +
             "29 0 2 1 3 -1 4 5 6 7 -1 0 1 4 5 -1 2 6 3 7 -1 0 4 2 6 -1 1 3 5 7\n",
         24},
        {"one strip that doubles back", "ply", strips_head + points() + "4 0 2 1 3\n", 0,
         "4 edges with one triangle only"},
        {"a format that is none", "ply", replaced(head, "ascii", "binary") + end + body, 0,
         "line 2"},
        {"points only", "ply", head.substr(0, head.find("element face")) + end + points(), 0,
         "holds no triangles"},
        {"fewer faces than promised", "ply", head + end + points() + "4 0 2 3 1\n", 0, "cut short"},
    };
}

std::vector<Case> off_cases() {
    const std::string counts = "8 6 12\n";
    const std::string body = points() + off_faces;
    return {
        {"plain", "off", "OFF\n" + counts + body, 24},
        {"lower case", "off", "off\n" + counts + body, 24},
        {"no keyword", "off", counts + body, 24},
        {"glued to the counts", "off", "OFF" + counts + body, 24},
        {"counts in its line", "off", "OFF " + counts + body, 24},
        {"two counts", "off", "OFF\n8 6\n" + body, 24},
        {"counts in three lines", "off", "OFF\n8\n6\n12\n" + body, 24},
        {"all in one line", "off", replaced("OFF\n" + counts + body, "\n", " "), 24},
        {"a word a line", "off", replaced("OFF\n" + counts + body, " ", "\n"), 24},
        {"comments everywhere", "off",
         "# 1\n" + replaced("OFF\n" + counts + body, "\n", " # 4 0 1\n# x\n"), 24},
        {"two vertices a line", "off",
         "OFF\n" + counts + replaced(points(), "\n2", " 2") + off_faces, 24},
        {"colours of faces", "off",
         "OFF\n" + counts + points() + faces("4", from_zero, " 255 0 0\n"), 24},
        {"colours of some faces", "off",
         "OFF\n" + counts + points() +
             replaced(off_faces, "4 0 2 3 1\n", "4 0 2 3 1 0.5 0.5 0.5 1\n"),
         24},
        {"COFF with three numbers", "off", "COFF\n" + counts + points("", " 9 9 9\n") + off_faces,
         24},
        {"COFF with four, in one line", "off",
         "COFF " + replaced(counts + points("", " 9 9 9 9\n"), "\n", " ") + off_faces, 24},
        {"COFF with three, in one line", "off",
         "COFF " + replaced(counts + points("", " 9 9 9\n"), "\n", " ") + off_faces, 24},
        {"NOFF", "off", "NOFF\n" + counts + points("", " 0 0 1\n") + off_faces, 24},
        {"STCNOFF", "off", "STCNOFF\n" + counts + points("", " 0 0 1 9 9 9 9 0 0\n") + off_faces,
         24},
        {"4OFF", "off", "4OFF\n" + counts + points("", " 2\n") + off_faces, 3},
        {"carriage returns only", "off", replaced("OFF\n" + counts + body, "\n", "\r"), 24},
        {"byte order mark", "off", "\xef\xbb\xbfOFF\n" + counts + body, 24},
        {"unused vertices that are no numbers", "off",
         "OFF\n9 6 0\n" + points() + "nan inf 1\n" + off_faces, 24},
        {"more faces than counted", "off", "OFF\n8 5 0\n" + body, 0,
         "4 edges with one triangle only"},
        {"fewer faces than counted", "off", "OFF\n8 7 0\n" + body, 0, "cut short"},
        {"a binary one", "off", "OFF BINARY\n" + counts + body, 0, "binary"},
        {"of any dimension", "off", "nOFF\n3\n" + counts + body, 0, "nOFF"},
    };
}

void check(const Case& one, const Folder& folder) {
    INFO(one.ending << ": " << one.what);
    const fs::path path = folder.write("it." + one.ending, one.bytes);
    try {
        const FileMesh file = read_mesh(path);
        SolidOptions options;
        options.source = path.string();
        const Solid solid = make_solid("it", file.mesh, options);
        std::string remarks;
        for (const std::string& line : file.remarks) remarks += line + "; ";
        for (const std::string& line : solid.mended) remarks += line + "; ";
        CHECK(solid.volume == Approx(one.volume).epsilon(1e-12));
        CHECK_THAT(remarks, contains(one.words));
        CHECK(remarks.empty() == one.words.empty());
    } catch (const lod::Error& error) {
        const std::string line = error.what();
        INFO(line);
        CHECK(one.volume == 0);
        CHECK(line.starts_with(path.string()));
        CHECK(line.find('\n') == std::string::npos);
        CHECK_THAT(line, contains(one.words));
    }
}

}  // namespace

TEST_CASE("OBJ files of many programs give the box or say why not", "[cases]") {
    const Folder folder;
    for (const Case& one : obj_cases()) check(one, folder);
}

TEST_CASE("STL files of many programs give the box or say why not", "[cases]") {
    const Folder folder;
    for (const Case& one : stl_cases()) check(one, folder);
}

TEST_CASE("PLY files of many programs give the box or say why not", "[cases]") {
    const Folder folder;
    for (const auto& cases : {ply_cases(), ply_binary_cases(), ply_odd_cases()})
        for (const Case& one : cases) check(one, folder);
}

TEST_CASE("OFF files of many programs give the box or say why not", "[cases]") {
    const Folder folder;
    for (const Case& one : off_cases()) check(one, folder);
}
