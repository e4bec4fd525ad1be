#include <algorithm>
#include <pugixml.hpp>
#include <unordered_map>

#include "lodlab/lod2d/source/css/property.hpp"
#include "lodlab/lod2d/source/resolve/mask.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

class Viewports {
  public:
    Viewports(const pugi::xml_document& document, SvgNotes& notes) : notes_(notes) {
        collect(document.document_element());
    }

    void check() {
        for (const xml_node& use : uses_) {
            const std::string link = svg_link(use);
            const auto found = link.starts_with('#') ? by_id_.find(link.substr(1)) : by_id_.end();
            if (found != by_id_.end()) check_used(use, found->second);
        }
        for (const xml_node& marker : markers_) check_marker(marker);
    }

  private:
    void collect(const xml_node& node) {
        if (const auto id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
        const std::string_view tag = local_name(node.name());
        if (tag == "use") uses_.push_back(node);
        if (tag == "marker") markers_.push_back(node);
        for (const xml_node& child : node.children()) collect(child);
    }

    static bool slices(const xml_node& node) {
        const std::string_view aspect = trimmed(node.attribute("preserveAspectRatio").value());
        return aspect.ends_with("slice") && node.attribute("viewBox") &&
               !is_one_of(svg_property(node, "overflow"), {"visible", "auto"});
    }

    void check_used(const xml_node& use, const xml_node& target) {
        const std::string_view tag = local_name(target.name());
        if (tag != "symbol" && tag != "svg") return;
        if (slices(target))
            notes_.doubt(std::string("a <").append(tag) +
                         "> that it uses is cut off by a slice, which is not followed here");
        const bool sized = std::ranges::any_of(
            std::initializer_list<xml_node>{use, target}, [](const xml_node& node) {
                return node.attribute("width") || node.attribute("height");
            });
        if (tag == "symbol" && sized && !target.attribute("viewBox") &&
            svg_property(target, "overflow") != "visible")
            notes_.doubt(
                "a <symbol> that it uses has a size and no viewBox, and is not cut off here");
        if (tag == "symbol" && (target.attribute("x") || target.attribute("y")))
            notes_.doubt("a <symbol> that it uses has a place, which is not followed here");
    }

    void check_marker(const xml_node& marker) {
        if (svg_property(marker, "overflow") == "visible") return;
        if (slices(marker))
            notes_.doubt("its marker is cut off by a slice, which is not followed here");
        const auto side = [&](const char* name) {
            const std::string_view text = trimmed(marker.attribute(name).value());
            return text.empty() ? 3.0 : parse_svg_length(text, 0);
        };
        try {
            const auto box = parse_svg_view_box(marker.attribute("viewBox").value());
            const double sides = side("markerWidth") * box[3];
            const double others = side("markerHeight") * box[2];
            const std::string_view aspect = marker.attribute("preserveAspectRatio").value();
            if (std::abs(sides - others) > 1e-6 * std::abs(sides) && !aspect.starts_with("none"))
                notes_.doubt(
                    "its marker is of another shape than its viewBox, and cut off by that");
        } catch (const SvgTextError&) {  // no view box: nothing is scaled
        }
    }

    SvgNotes& notes_;
    std::unordered_map<std::string, xml_node> by_id_;
    std::vector<xml_node> uses_;
    std::vector<xml_node> markers_;
};

}  // namespace

void check_viewports(const pugi::xml_document& document, SvgNotes& notes) {
    Viewports(document, notes).check();
}

}  // namespace lod2d
