#include "lodlab/lod2d/svg_mask.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <unordered_map>

#include "lodlab/lod2d/svg_property.hpp"
#include "lodlab/lod2d/svg_words.hpp"
#include "lodlab/lod2d/svg_xml.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

bool is_black(const std::string& fill) {
    return is_one_of(fill, {"", "black", "#000", "#000000", "inherit", "currentcolor"}) ||
           fill.starts_with("rgb(0") || fill.starts_with("hsl(") || fill.starts_with("url(");
}

class Masks {
  public:
    Masks(pugi::xml_document& document, SvgNotes& notes) : notes_(notes) {
        collect(document.document_element());
        sheet_masks_ = sheet_.find("mask") != std::string::npos;
        if (sheet_masks_) notes_.doubt("its style sheet sets masks, which are not followed here");
        if (sheet_.find("filter:") != std::string::npos)
            notes_.doubt("its style sheet sets filters, which are not followed here");
    }

    void resolve(xml_node node) {
        for (xml_node child = node.first_child(); child;) {
            const xml_node next = child.next_sibling();  // a masked child may move into a group
            resolve(child);
            child = next;
        }
        if (is_one_of(local_name(node.name()), {"mask", "clipPath"})) return;
        const std::string filter = svg_property(node, "filter");
        if (!filter.empty() && filter != "none")
            SvgNotes::count(notes_.left_out, "filter", "filters");
        if (!filter.empty()) remove_svg_property(node, "filter");
        const std::string mask = svg_property(node, "mask");
        if (mask.empty()) return;
        remove_svg_property(node, "mask");
        if (mask == "none" || !mask.starts_with("url(")) return;
        const std::size_t open = mask.find('#');
        const std::size_t close = mask.find_first_of(")'\"", open);
        const auto found = open == std::string::npos
                               ? by_id_.end()
                               : by_id_.find(mask.substr(open + 1, close - open - 1));
        if (found == by_id_.end() || local_name(found->second.name()) != "mask") return;
        if (!is_a_clip(found->second))
            SvgNotes::count(notes_.left_out, "mask", "masks");
        else
            clip(node, found->second);
    }

  private:
    void collect(const xml_node& node) {
        if (const auto id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
        if (local_name(node.name()) == "style") sheet_ += node.child_value();
        for (const xml_node& child : node.children()) collect(child);
    }

    /// Whether all that the mask holds is seen through, and nothing else.
    [[nodiscard]] bool is_a_clip(const xml_node& mask) const {
        if (sheet_.find("fill") != std::string::npos) return false;
        const bool alpha = svg_property(mask, "mask-type") == "alpha";
        const std::string inherited = svg_property(mask, "fill");
        std::size_t shapes = 0;
        for (const xml_node& child : mask.children()) {
            if (child.type() != pugi::node_element) continue;
            if (is_one_of(local_name(child.name()), {"title", "desc"})) continue;
            if (!is_one_of(local_name(child.name()),
                           {"path", "rect", "circle", "ellipse", "polygon", "polyline", "use"}))
                return false;
            std::string fill = svg_property(child, "fill");
            if (fill.empty()) fill = inherited;
            const std::string stroke = svg_property(child, "stroke");
            const bool seen = alpha ? !fill.starts_with("url(") : !is_black(fill);
            if (!seen || fill == "none" || (!stroke.empty() && stroke != "none")) return false;
            for (const char* fade : {"opacity", "fill-opacity", "clip-path", "mask"})
                if (!svg_property(child, fade).empty()) return false;
            ++shapes;
        }
        return shapes == 1;
    }

    void clip(xml_node node, xml_node mask) {
        const std::string id = std::string("lodlab-mask-") + mask.attribute("id").value();
        if (made_.insert(id).second) {
            xml_node made = mask.parent().insert_copy_before(mask, mask);
            made.set_name("clipPath");
            made.attribute("id").set_value(id.c_str());
            if (const auto units = made.attribute("maskContentUnits"))
                made.append_attribute("clipPathUnits").set_value(units.value());
            for (const char* own : {"maskContentUnits", "maskUnits", "x", "y", "width", "height"})
                made.remove_attribute(own);
        }
        const std::string link = "url(#" + id + ")";
        if (svg_property(node, "clip-path").empty() &&
            sheet_.find("clip-path") == std::string::npos) {
            node.append_attribute("clip-path").set_value(link.c_str());
            return;
        }
        // A group of its own around it; its transform stays inside, so the mask's frame must
        // follow.
        if (node.attribute("transform")) {
            SvgNotes::count(notes_.left_out, "mask", "masks");
            return;
        }
        xml_node group = node.parent().insert_child_before("g", node);
        group.append_attribute("clip-path").set_value(link.c_str());
        group.append_move(node);
    }

    SvgNotes& notes_;
    std::unordered_map<std::string, xml_node> by_id_;
    std::string sheet_;
    bool sheet_masks_ = false;
    std::set<std::string> made_;
};

}  // namespace

namespace {

void collect_patterns(const xml_node& node, std::vector<xml_node>& patterns, std::string& texts,
                      std::unordered_map<std::string, xml_node>& by_id) {
    if (local_name(node.name()) == "pattern" && is_svg_element(node)) {
        patterns.push_back(node);
        by_id.try_emplace(node.attribute("id").value(), node);
    }
    for (const pugi::xml_attribute& attribute : node.attributes())
        if (std::string_view(attribute.value()).find('#') != std::string_view::npos)
            texts.append(attribute.value()).append(" ");
    if (local_name(node.name()) == "style") texts += node.child_value();
    for (const xml_node& child : node.children()) collect_patterns(child, patterns, texts, by_id);
}

/// Whether it, or the pattern that it takes its contents from, draws something.
bool has_contents(xml_node pattern, const std::unordered_map<std::string, xml_node>& by_id) {
    for (int links = 0; links < 20; ++links) {
        for (const xml_node& child : pattern.children())
            if (child.type() == pugi::node_element && !is_one_of(child.name(), {"title", "desc"}))
                return true;
        const std::string link = svg_link(pattern);
        const auto found = link.starts_with('#') ? by_id.find(link.substr(1)) : by_id.end();
        if (found == by_id.end()) return false;
        pattern = found->second;
    }
    return false;
}

}  // namespace

void fill_patterns(pugi::xml_document& document, SvgNotes& notes) {
    std::vector<xml_node> patterns;
    std::string texts;
    std::unordered_map<std::string, xml_node> by_id;
    collect_patterns(document.document_element(), patterns, texts, by_id);
    std::vector<bool> drawn;
    for (const xml_node& pattern : patterns) drawn.push_back(has_contents(pattern, by_id));
    for (std::size_t i = patterns.size(); i-- > 0;) {  // those within others first
        xml_node pattern = patterns[i];
        const std::string id = pattern.attribute("id").value();
        if (texts.find("url(#" + id + ")") != std::string::npos && drawn[i])
            SvgNotes::count(notes.whole, "pattern", "patterns");
        while (pattern.first_child()) pattern.remove_child(pattern.first_child());
        while (pattern.first_attribute()) pattern.remove_attribute(pattern.first_attribute());
        const std::string name = pattern.name();
        const std::string prefix = name.substr(0, name.size() - std::string("pattern").size());
        pattern.set_name((prefix + "linearGradient").c_str());
        pattern.append_attribute("id").set_value(id.c_str());
        xml_node stop = pattern.append_child((prefix + "stop").c_str());
        stop.append_attribute("style").set_value(drawn[i] ? "stop-color:black;stop-opacity:1"
                                                          : "stop-color:black;stop-opacity:0");
    }
}

void masks_to_clips(pugi::xml_document& document, SvgNotes& notes) {
    Masks(document, notes).resolve(document.document_element());
}

}  // namespace lod2d
