#include <pugixml.hpp>
#include <unordered_map>

#include "lodlab/lod2d/source/css/property.hpp"
#include "lodlab/lod2d/source/resolve/mask.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

class NestedClips {
  public:
    NestedClips(pugi::xml_document& document, SvgNotes& notes) : notes_(notes) {
        collect(document.document_element(), false);
    }

    void resolve() {
        for (const xml_node& clip : clips_) lift(clip);
        for (const xml_node& node : clipped_) unnest(node);
        for (const xml_node& clip : clips_) {
            const bool nested = !svg_property(clip, "clip-path").empty();
            const std::string link = std::string("#") + clip.attribute("id").value();
            if (nested && sheets_.find(link) != std::string::npos) leave_out();
            remove_svg_property(clip, "clip-path");
        }
    }

  private:
    void collect(const xml_node& node, bool within_clip) {
        if (const auto id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
        const std::string_view tag = local_name(node.name());
        const bool is_clip = tag == "clipPath" && is_svg_element(node);
        if (is_clip) clips_.push_back(node);
        if (!is_clip && !within_clip && !svg_property(node, "clip-path").empty())
            clipped_.push_back(node);
        if (tag == "style") sheets_ += node.child_value();
        for (const xml_node& child : node.children()) collect(child, within_clip || is_clip);
    }

    [[nodiscard]] xml_node linked(const std::string& link) const {
        const std::size_t open = link.find('#');
        if (open == std::string::npos) return {};
        const auto found =
            by_id_.find(link.substr(open + 1, link.find_first_of(")'\" ", open) - open - 1));
        return found == by_id_.end() ? xml_node() : found->second;
    }

    void leave_out() { SvgNotes::count(notes_.left_out, "clip of a clip", "clips of clips"); }

    /// A clip of the only thing that a clip holds clips all of it.
    void lift(xml_node clip) {
        xml_node only;
        int others = 0;
        bool nested = false;
        for (const xml_node& child : clip.children()) {
            if (child.type() != pugi::node_element) continue;
            others += static_cast<bool>(only);
            only = child;
            nested = nested || linked(svg_property(child, "clip-path"));
            const xml_node target =
                local_name(child.name()) == "use" ? linked(svg_link(child)) : xml_node();
            if (target && linked(svg_property(target, "clip-path"))) leave_out();
        }
        if (!nested) return;
        const bool moves = !svg_property(only, "transform").empty();
        if (others > 0 || moves || !svg_property(clip, "clip-path").empty()) return leave_out();
        const std::string link = svg_property(only, "clip-path");
        remove_svg_property(only, "clip-path");
        clip.append_attribute("clip-path").set_value(link.c_str());
    }

    void unnest(xml_node node) {
        xml_node clip = linked(svg_property(node, "clip-path"));
        for (int links = 0; clip && links < 20; ++links) {
            const std::string link = svg_property(clip, "clip-path");
            clip = linked(link);
            if (!clip) return;
            xml_node group = wrap_in_group(node, sheets_);
            if (!group) return leave_out();
            group.append_attribute("clip-path").set_value(link.c_str());
            node = group;
        }
        if (clip) leave_out();  // they clip each other
    }

    SvgNotes& notes_;
    std::unordered_map<std::string, xml_node> by_id_;
    std::vector<xml_node> clips_;
    std::vector<xml_node> clipped_;
    std::string sheets_;
};

}  // namespace

void unnest_clips(pugi::xml_document& document, SvgNotes& notes) {
    NestedClips(document, notes).resolve();
}

}  // namespace lod2d
