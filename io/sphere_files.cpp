#include "lodlab/io/sphere_files.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/core/base/utf8.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"

namespace io {
namespace {

using Json = nlohmann::ordered_json;
using Ball = lod::Sphere<3>;

std::string text_of(const lod::Vector<3>& p) {
    return lod::number_text(p.x()) + " " + lod::number_text(p.y()) + " " + lod::number_text(p.z());
}

/// A sphere of the body frame in that of the mesh. Where rounding moves its centre there further
/// than the certificate has to spare, it is so much wider, and covers what it covered.
Ball in_mesh_frame(const SphereExport& what, std::int32_t node) {
    const Ball ball = what.tree.sphere(node);
    const lod::Vector<3> centre = ball.centre + what.centroid;
    lod::Vector<3> lost;
    for (int d = 0; d < 3; ++d) {  // exactly (Knuth's sum)
        const double back = centre[d] - ball.centre[d];
        lost[d] = (ball.centre[d] - (centre[d] - back)) + (what.centroid[d] - back);
    }
    const bool spared = lost.norm() <= lod::rounding_bound(what.tree.sphere(0)) / 4;
    return {centre, ball.radius + (spared ? 0 : lost.norm())};
}

/// What is no UTF-8, or no letter of XML, becomes the sign for that.
std::string letters_of_xml(const std::string& text) {
    constexpr std::string_view unknown = "\xEF\xBF\xBD";
    std::string result;
    for (std::size_t i = 0, length = 0; i < text.size(); i += std::max<std::size_t>(length, 1)) {
        length = lod::utf8_length(text, i);
        const std::string_view letter = std::string_view(text).substr(i, length);
        const bool in_xml = length > 0 && (length > 1 || letter[0] >= ' ') &&
                            letter != "\xEF\xBF\xBE" && letter != "\xEF\xBF\xBF";
        result += in_xml ? letter : unknown;
    }
    return result;
}

std::string sph_text(const SphereExport& what) {
    constexpr double most_nodes = 4e6;
    const lod::SphereTree<3>& tree = what.tree;
    const int branching =
        std::max(1, *std::max_element(tree.child_count.begin(), tree.child_count.end()));
    double size = 1;
    for (int level = 1; level < tree.levels(); ++level) size *= branching;
    if (size > most_nodes)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "a .sph file lists the complete tree, here more than 4 million spheres; "
                         "export a tree of fewer levels or as JSON");
    std::string text = std::to_string(tree.levels()) + " " + std::to_string(branching) + "\n";
    constexpr int none = -1;
    std::vector<int> level{0};
    for (int k = 0; k < tree.levels(); ++k) {
        std::vector<int> next;
        for (const int node : level) {
            if (node == none) {
                text += "0 0 0 0 0\n";
            } else {
                const Ball ball = in_mesh_frame(what, node);
                text += text_of(ball.centre) + " " + lod::number_text(ball.radius) + " 1\n";
            }
            for (int c = 0; c < branching; ++c) {
                const bool there = node != none && c < tree.child_count[tree.index(node)];
                next.push_back(there ? tree.first_child[tree.index(node)] + c : none);
            }
        }
        level = std::move(next);
    }
    return text;
}

std::string json_text(const SphereExport& what) {
    Json levels = Json::array();
    for (int level = 0; level < what.tree.levels(); ++level) {
        Json spheres = Json::array();
        for (const int node : what.tree.level_nodes(level)) {
            const Ball ball = in_mesh_frame(what, node);
            const lod::Vector<3>& c = ball.centre;
            spheres.push_back({{"centre", {c.x(), c.y(), c.z()}}, {"radius", ball.radius}});
        }
        levels.push_back({{"level", level}, {"spheres", std::move(spheres)}});
    }
    return Json({{"frame", "mesh"}, {"levels", std::move(levels)}}).dump() + "\n";
}

std::string urdf_text(const SphereExport& what) {
    pugi::xml_document document;
    pugi::xml_node robot = document.append_child("robot");
    robot.append_attribute("name") = letters_of_xml(what.name).c_str();
    pugi::xml_node link = robot.append_child("link");
    link.append_attribute("name") = "body";
    for (const int node : what.tree.level_nodes(what.level)) {
        const Ball ball = in_mesh_frame(what, node);
        pugi::xml_node collision = link.append_child("collision");
        collision.append_child("origin").append_attribute("xyz") = text_of(ball.centre).c_str();
        collision.append_child("geometry").append_child("sphere").append_attribute("radius") =
            lod::number_text(ball.radius).c_str();
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

constexpr std::array<SphereFormat, 3> formats{{
    {".spheres.json", false, json_text},
    {".sph", false, sph_text},
    {".urdf", true, urdf_text},
}};

}  // namespace

std::span<const SphereFormat> sphere_formats() {
    return formats;
}

const SphereFormat* sphere_format_of(std::string_view path) {
    const auto found =
        std::find_if(formats.begin(), formats.end(),
                     [&](const SphereFormat& format) { return path.ends_with(format.ending); });
    return found == formats.end() ? nullptr : &*found;
}

}  // namespace io
