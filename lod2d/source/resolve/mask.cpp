#include "lodlab/lod2d/source/resolve/mask.hpp"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <set>
#include <unordered_map>

#include "lodlab/lod2d/source/css/property.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

/// Whether light goes through what is painted so, all or some of it, for certain.
bool is_light(const std::string& fill) {
    if (fill.starts_with('#'))
        return (fill.size() == 4 || fill.size() == 7) &&
               fill.find_first_not_of("#0") != std::string::npos;
    if (fill.starts_with("rgb("))
        return fill.find('/') == std::string::npos &&
               fill.find_first_of("123456789") != std::string::npos &&
               std::ranges::count(fill, ',') == 2;
    return !is_one_of(fill, {"", "none", "black", "transparent", "inherit", "currentcolor",
                             "context-fill", "context-stroke"}) &&
           fill.find_first_of("(-") == std::string::npos;
}

/// A property that elements inherit.
std::string inherited_property(xml_node node, const std::string& name) {
    for (; node.type() == pugi::node_element; node = node.parent()) {
        const std::string value = svg_property(node, name);
        if (!value.empty() && value != "inherit") return value;
    }
    return {};
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

    [[nodiscard]] xml_node target_of(const xml_node& use) const {
        const std::string link = svg_link(use);
        const auto found = link.starts_with('#') ? by_id_.find(link.substr(1)) : by_id_.end();
        return found == by_id_.end() ? xml_node() : found->second;
    }

    /// Whether light goes through all of a shape, which takes what it does not say from `heir`.
    [[nodiscard]] static bool is_seen_through(const xml_node& shape, const xml_node& heir,
                                              bool alpha) {
        const auto value = [&](const char* name) {
            const std::string own = svg_property(shape, name);
            return own.empty() || own == "inherit" ? inherited_property(heir, name) : own;
        };
        const std::string fill = value("fill");
        const bool seen =
            alpha ? fill.empty() || fill == "black" || is_light(fill) : is_light(fill);
        const std::string stroke = value("stroke");
        constexpr std::array fades{"opacity", "fill-opacity", "clip-path", "mask"};
        return seen && (stroke.empty() || stroke == "none") &&
               std::ranges::all_of(
                   fades, [&](const char* fade) { return svg_property(shape, fade).empty(); });
    }

    /// Whether all that the mask holds is seen through, and nothing else.
    [[nodiscard]] bool is_a_clip(const xml_node& mask) const {
        if (sheet_.find("fill") != std::string::npos) return false;
        const bool alpha = svg_property(mask, "mask-type") == "alpha";
        std::size_t shapes = 0;
        for (const xml_node& child : mask.children()) {
            if (child.type() != pugi::node_element) continue;
            if (is_one_of(local_name(child.name()), {"title", "desc"})) continue;
            if (!is_one_of(local_name(child.name()),
                           {"path", "rect", "circle", "ellipse", "polygon", "polyline", "use"}))
                return false;
            if (!is_seen_through(child, mask, alpha)) return false;
            if (local_name(child.name()) == "use" &&
                !is_seen_through(target_of(child), child, alpha))
                return false;
            ++shapes;
        }
        return shapes == 1;
    }

    void clip(xml_node node, xml_node mask) {
        const std::string link = contents_of(mask);
        const std::string region = region_of(node, mask);
        std::vector<std::string> links{link};
        if (!region.empty()) links.push_back(region);
        // A clip by the element's box stands at the element itself.
        if (std::string_view(mask.attribute("maskUnits").value()) != "userSpaceOnUse")
            std::ranges::reverse(links);
        const bool is_free = svg_property(node, "clip-path").empty() &&
                             sheet_.find("clip-path") == std::string::npos;
        xml_node outer = node;
        std::vector<xml_node> clipped;
        if (is_free) clipped.push_back(node);
        while (clipped.size() < links.size()) {
            outer = wrap_in_group(outer, sheet_);
            if (!outer) return SvgNotes::count(notes_.left_out, "mask", "masks");
            clipped.push_back(outer);
        }
        for (std::size_t i = 0; i < links.size(); ++i)
            clipped[i].append_attribute("clip-path").set_value(links[i].c_str());
    }

    /// A clip by what the mask holds.
    std::string contents_of(xml_node mask) {
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
        return "url(#" + id + ")";
    }

    /// A clip by the mask's own region; "" where that cuts off nothing of the element.
    std::string region_of(const xml_node& node, xml_node mask) {
        const bool of_user =
            std::string_view(mask.attribute("maskUnits").value()) == "userSpaceOnUse";
        constexpr std::array names{"x", "y", "width", "height"};
        constexpr std::array defaults{"-10%", "-10%", "120%", "120%"};
        std::array<std::string, 4> side;
        std::array<double, 4> number{};
        bool known = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::string_view given = trimmed(mask.attribute(names[i]).value());
            side[i] = given.empty() ? defaults[i] : std::string(given);
            const bool share = side[i].ends_with('%');
            try {
                number[i] = parse_svg_length(side[i], 1);
            } catch (const SvgTextError&) {
                known = false;
            }
            known = known && !(of_user && share);
            if (!of_user && known) side[i] = decimal(number[i]);
        }
        if (known && of_user && holds(number, mask)) return {};
        if (known && !of_user && number[0] <= 0 && number[1] <= 0 && number[0] + number[2] >= 1 &&
            number[1] + number[3] >= 1 && !is_stroked(node))
            return {};
        const std::string id = std::string("lodlab-region-") + mask.attribute("id").value();
        if (made_.insert(id).second) {
            xml_node made = mask.parent().insert_child_before("clipPath", mask);
            made.append_attribute("id").set_value(id.c_str());
            if (!of_user) made.append_attribute("clipPathUnits").set_value("objectBoundingBox");
            xml_node rect = made.append_child("rect");
            for (std::size_t i = 0; i < 4; ++i)
                rect.append_attribute(names[i]).set_value(side[i].c_str());
        }
        return "url(#" + id + ")";
    }

    /// Whether it has a stroke for certain, which may stand out of its box by more than a tenth.
    static bool is_stroked(const xml_node& node) {
        const std::string stroke = svg_property(node, "stroke");
        return !stroke.empty() && stroke != "none";
    }

    /// Whether the region holds all that the mask does.
    static bool holds(const std::array<double, 4>& region, const xml_node& mask) {
        if (mask.attribute("maskContentUnits")) return false;
        for (const xml_node& child : mask.children()) {
            if (child.type() != pugi::node_element ||
                is_one_of(local_name(child.name()), {"title", "desc"}))
                continue;
            const auto box = svg_box_of(child);
            if (!box || !svg_property(child, "transform").empty()) return false;
            if (box->low.x() < region[0] || box->low.y() < region[1] ||
                box->high.x() > region[0] + region[2] || box->high.y() > region[1] + region[3])
                return false;
        }
        return true;
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
