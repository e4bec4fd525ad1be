#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "lodlab/lod2d/source/css/property.hpp"
#include "lodlab/lod2d/source/resolve/mask.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

/// A number of user units, and no other length; nothing else.
std::optional<double> number_of(const xml_node& node, const char* name, double otherwise) {
    const std::string_view text = node.attribute(name).value();
    if (text.empty()) return otherwise;
    if (text.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return std::nullopt;
    try {
        return parse_svg_length(text, 0);
    } catch (const SvgTextError&) {
        return std::nullopt;
    }
}

class BoxClips {
  public:
    BoxClips(pugi::xml_document& document, SvgNotes& notes) : notes_(notes) {
        collect(document.document_element());
    }

    void resolve() {
        for (xml_node node : clipped_) {
            const std::string id = clip_of(node);
            const auto found = clips_.find(id);
            if (found == clips_.end()) continue;
            const auto box = svg_box_of(node);
            if (!box || box->size().x() <= 0 || box->size().y() <= 0) {
                SvgNotes::count(notes_.left_out, "clip in units of a box",
                                "clips in units of a box");
                continue;
            }
            place(node, found->second, *box);
        }
        for (auto& [id, clip] : clips_) {
            if (sheet_.find("#" + id) != std::string::npos)
                SvgNotes::count(notes_.left_out, "clip in units of a box",
                                "clips in units of a box");
            clip.parent().remove_child(clip);
        }
    }

  private:
    static std::string clip_of(const xml_node& node) {
        const std::string text = svg_property(node, "clip-path");
        const std::size_t open = text.find('#');
        if (open == std::string::npos) return {};
        return text.substr(open + 1, text.find_first_of(")'\"", open) - open - 1);
    }

    void collect(const xml_node& node) {
        const std::string_view tag = local_name(node.name());
        if (tag == "clipPath" &&
            std::string_view(node.attribute("clipPathUnits").value()) == "objectBoundingBox")
            clips_.try_emplace(node.attribute("id").value(), node);
        else if (!clip_of(node).empty())
            clipped_.push_back(node);
        if (tag == "style") sheet_ += node.child_value();
        for (const xml_node& child : node.children()) collect(child);
    }

    void place(xml_node node, xml_node clip, const Box& box) {
        const std::string id = "lodlab-clip-" + std::to_string(++made_);
        xml_node made = clip.parent().insert_copy_before(clip, clip);
        made.attribute("id").set_value(id.c_str());
        made.remove_attribute("clipPathUnits");
        std::ostringstream matrix;
        matrix.imbue(std::locale::classic());
        matrix.precision(17);
        matrix << "matrix(" << box.size().x() << " 0 0 " << box.size().y() << ' ' << box.low.x()
               << ' ' << box.low.y() << ") ";
        for (xml_node child : made.children()) {
            const std::string own = child.attribute("transform").value();
            child.remove_attribute("transform");
            child.append_attribute("transform").set_value((matrix.str() + own).c_str());
        }
        const std::string style = node.attribute("style").value();
        const std::string link = "url(#" + id + ")";
        if (style.find("clip-path:") != std::string::npos) {
            node.attribute("style").set_value((style + ";clip-path:" + link).c_str());
        } else {
            node.attribute("clip-path").set_value(link.c_str());
        }
    }

    SvgNotes& notes_;
    std::map<std::string, xml_node> clips_;
    std::vector<xml_node> clipped_;
    std::string sheet_;
    int made_ = 0;
};

}  // namespace

std::optional<Box> svg_box_of(const xml_node& node) {
    const std::string_view tag = local_name(node.name());
    const auto n = [&](const char* name) { return number_of(node, name, 0); };
    const auto from_to = [](const Point& low, const Point& high) {
        Box box;
        box.hold(low);
        box.hold(high);
        return box;
    };
    if (tag == "rect") {
        if (!n("x") || !n("y") || !n("width") || !n("height")) return std::nullopt;
        return from_to({*n("x"), *n("y")}, {*n("x") + *n("width"), *n("y") + *n("height")});
    }
    if (tag == "circle" || tag == "ellipse") {
        const auto rx = n(tag == "circle" ? "r" : "rx");
        const auto ry = n(tag == "circle" ? "r" : "ry");
        if (!n("cx") || !n("cy") || !rx || !ry) return std::nullopt;
        return from_to({*n("cx") - *rx, *n("cy") - *ry}, {*n("cx") + *rx, *n("cy") + *ry});
    }
    CurvePath path;
    if (tag == "path") {
        path = parse_svg_path(node.attribute("d").value());
    } else if (tag == "polygon" || tag == "polyline") {
        for (const Point& p : parse_svg_points(node.attribute("points").value()))
            path.empty() ? path.move_to(p) : path.line_to(p);
    }
    if (path.empty()) return std::nullopt;
    Box box;
    const double extent = path.control_box().size().maxCoeff();
    for (const Ring& ring : path.flatten(std::max(1e-9 * extent, 1e-300)))
        for (const Point& p : ring) box.hold(p);
    return box;
}

void box_clips_to_user_space(pugi::xml_document& document, SvgNotes& notes) {
    BoxClips(document, notes).resolve();
}

}  // namespace lod2d
