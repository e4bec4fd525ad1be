#include "lodlab/lod3d/solid/export_spheres.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/utf8.hpp"
#include "lodlab/core/math/enclosing_ball.hpp"

namespace lod3d {
namespace {

std::string text_of(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// A sphere of the body frame in that of the mesh. Where rounding moves its centre there further
/// than the certificate has to spare, it is so much wider, and covers what it covered.
lod::Sphere<3> moved(const lod::SphereTree<3>& tree, std::int32_t node, const Point& by) {
    const lod::Sphere<3> ball = tree.sphere(node);
    const Point centre = ball.centre + by;
    Point lost;
    for (int d = 0; d < 3; ++d) {  // exactly (Knuth's sum)
        const double back = centre[d] - ball.centre[d];
        lost[d] = (ball.centre[d] - (centre[d] - back)) + (by[d] - back);
    }
    const bool spared = lost.norm() <= lod::rounding_bound(tree.sphere(0)) / 4;
    return {centre, ball.radius + (spared ? 0 : lost.norm())};
}

std::string listed(const Point& p, const std::string& between) {
    return text_of(p.x()) + between + text_of(p.y()) + between + text_of(p.z());
}

/// In an attribute of XML. What is no UTF-8, or no letter of XML, becomes the sign for that.
std::string escaped(const std::string& text) {
    constexpr std::string_view unknown = "\xEF\xBF\xBD";
    std::string result;
    for (std::size_t i = 0, length = 0; i < text.size(); i += std::max<std::size_t>(length, 1)) {
        length = lod::utf8_length(text, i);
        const std::string_view letter = std::string_view(text).substr(i, length);
        const bool in_xml = length > 0 && (length > 1 || letter[0] >= ' ') &&
                            letter != "\xEF\xBF\xBE" && letter != "\xEF\xBF\xBF";
        if (letter == "&")
            result += "&amp;";
        else if (letter == "<")
            result += "&lt;";
        else if (letter == "\"")
            result += "&quot;";
        else
            result += in_xml ? letter : unknown;
    }
    return result;
}

}  // namespace

std::string spheres_to_sph(const lod::SphereTree<3>& tree, const Point& centroid) {
    constexpr double most_nodes = 4e6;
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
                const auto ball = moved(tree, node, centroid);
                text += listed(ball.centre, " ") + " " + text_of(ball.radius) + " 1\n";
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

std::string spheres_to_json(const lod::SphereTree<3>& tree, const Point& centroid) {
    std::string text = "{\"frame\": \"mesh\", \"levels\": [";
    for (int level = 0; level < tree.levels(); ++level) {
        text += std::string(level > 0 ? "," : "") + "\n{\"level\": " + std::to_string(level) +
                ", \"spheres\": [";
        std::string between = "\n";
        for (const int node : tree.level_nodes(level)) {
            const auto ball = moved(tree, node, centroid);
            text += between + "{\"centre\": [" + listed(ball.centre, ", ") +
                    "], \"radius\": " + text_of(ball.radius) + "}";
            between = ",\n";
        }
        text += "]}";
    }
    return text + "]}\n";
}

std::string spheres_to_urdf(const lod::SphereTree<3>& tree, const Point& centroid, int level,
                            const std::string& name) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<robot name=\"" + escaped(name) + "\">\n  <link name=\"body\">\n";
    for (const int node : tree.level_nodes(level)) {
        const auto ball = moved(tree, node, centroid);
        text += "    <collision><origin xyz=\"" + listed(ball.centre, " ") +
                "\"/><geometry><sphere radius=\"" + text_of(ball.radius) +
                "\"/></geometry></collision>\n";
    }
    return text + "  </link>\n</robot>\n";
}

}  // namespace lod3d
