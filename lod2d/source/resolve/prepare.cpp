#include "lodlab/lod2d/source/resolve/prepare.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/source/css/css.hpp"
#include "lodlab/lod2d/source/css/property.hpp"
#include "lodlab/lod2d/source/resolve/mask.hpp"
#include "lodlab/lod2d/source/resolve/uses.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

/// Attributes that CSS reads.
bool is_presentation(std::string_view name) {
    return name.starts_with("fill") || name.starts_with("stroke") || name.starts_with("stop-") ||
           name.starts_with("marker") ||
           is_one_of(name, {"display", "visibility", "clip-path", "clip-rule", "mask", "filter",
                            "color", "overflow", "vector-effect", "transform-box"});
}

class Preparation {
  public:
    Preparation(const SvgXml& xml, const SvgSettings& settings) : xml_(xml), settings_(settings) {
        document_.reset(*xml.document);
    }

    PreparedSvg prepare();

  private:
    void learn(const xml_node& node);
    void prepare_children(xml_node node, bool drawn);
    /// Whether the element stays.
    bool prepare_element(xml_node node, bool drawn);
    bool keep_by_tag(xml_node node, std::string_view tag, bool drawn);
    bool keep_by_conditions(xml_node node);
    void prepare_sheet(xml_node node);
    void prepare_attributes(xml_node node);
    void place_origin(xml_node node);
    void write_arcs(xml_node node) const;
    void check_grammar(const xml_node& node, std::string_view tag) const;
    void prepare_root();
    [[nodiscard]] SvgFrame frame() const;
    void place(xml_node node);

    const SvgXml& xml_;
    const SvgSettings& settings_;
    pugi::xml_document document_;
    PreparedSvg prepared_;
    SvgCss css_{prepared_.notes};
    std::string sheets_;  ///< of all of them
};

std::string text_of(const xml_node& node) {
    std::string text;
    for (const xml_node& child : node.children()) text += child.value();
    return text;
}

bool is_stretched(const SvgPage& page) {
    if (!page.size || !page.view_box) return false;
    const double ratio =
        page.size->x() * (*page.view_box)[3] / page.size->y() / (*page.view_box)[2];
    return ratio < 0.999 || ratio > 1.001;
}

/// Whether a <style> is CSS for a screen.
bool is_read(const xml_node& style, SvgNotes& notes) {
    const std::string_view type = style.attribute("type").value();
    if (!type.empty() && type != "text/css" && type != "TEXT/CSS") return false;
    const std::string_view media = style.attribute("media").value();
    bool known = true;
    const bool screens = is_for_screens(media, known);
    if (!known) notes.doubt("its style sheet for media=\"" + std::string(media) + "\" is left out");
    return screens;
}

void Preparation::learn(const xml_node& node) {
    if (local_name(node.name()) == "style" && is_svg_element(node)) {
        SvgNotes unheard;
        if (is_read(node, unheard)) css_.learn(text_of(node));
        sheets_ += text_of(node);
    }
    for (const xml_node& child : node.children())
        if (child.type() == pugi::node_element) learn(child);
}

void Preparation::prepare_sheet(xml_node node) {
    const std::string text =
        is_read(node, prepared_.notes) ? css_.sheet(text_of(node)) : std::string();
    while (node.first_child()) node.remove_child(node.first_child());
    node.append_child(pugi::node_pcdata).set_value(text.c_str());
    node.remove_attribute("media");
    node.remove_attribute("type");
}

bool Preparation::keep_by_conditions(xml_node node) {
    if (const auto extensions = node.attribute("requiredExtensions")) {
        if (*extensions.value() != '\0') return false;
        node.remove_attribute("requiredExtensions");
    }
    node.remove_attribute("requiredFeatures");  // browsers have them all
    const auto languages = node.attribute("systemLanguage");
    if (!languages) return true;
    bool english = false;
    std::istringstream words{std::string(languages.value())};
    for (std::string word; std::getline(words, word, ',');) {
        word.erase(0, word.find_first_not_of(" \t\r\n"));
        english = english || word.starts_with("en") || word.starts_with("EN");
    }
    const std::string line = "what it draws depends on the language: English was taken";
    auto& remarks = prepared_.notes.remarks;
    if (std::ranges::find(remarks, line) == remarks.end()) remarks.push_back(line);
    node.remove_attribute("systemLanguage");
    return english;
}

bool Preparation::keep_by_tag(xml_node node, std::string_view tag, bool drawn) {
    SvgNotes& notes = prepared_.notes;
    const auto leave_out = [&](const std::string& what) {
        if (drawn) SvgNotes::count(notes.left_out, what, what + "s");
        return false;
    };
    if (is_one_of(tag, {"text", "image", "foreignObject", "video", "audio", "canvas", "iframe"})) {
        if (local_name(node.parent().name()) == "clipPath")
            notes.doubt("it clips by a " + std::string(tag) + ", which is left out");
        const bool empty = tag == "text" && !node.first_child();
        return empty ? false : leave_out(std::string(tag));
    }
    if (tag == "script") return drawn = true, leave_out("script");
    if (tag == "set" || tag.starts_with("animate")) return drawn = true, leave_out("animation");
    if (tag == "style") prepare_sheet(node);
    if (tag == "use") {
        const std::string link = svg_link(node);
        if (!link.empty() && !link.starts_with('#')) {
            notes.doubt("it uses '" + link + "', another file, which is not read");
            return false;
        }
    }
    return true;
}

void Preparation::check_grammar(const xml_node& node, std::string_view tag) const {
    if (tag == "path") (void)svg_path_of(xml_, node);
    if (tag == "polygon" || tag == "polyline") (void)svg_points_of(xml_, node);
    if (node.attribute("transform")) (void)svg_transform_of(xml_, node);
}

/// Arcs as our own curves, which are closer to them than a library's.
void Preparation::write_arcs(xml_node node) const {
    const std::string_view d = node.attribute("d").value();
    if (d.find_first_of("aA") == std::string_view::npos) return;
    std::string text;
    const CurvePath path = svg_path_of(xml_, node);
    for (const CurvePath::Subpath& sub : path.subpaths()) {
        std::size_t next = 0;
        const auto put = [&](const char* command, std::size_t points) {
            text += command;
            for (; points > 0; --points, ++next)
                text += decimal(sub.points[next].x()) + " " + decimal(sub.points[next].y()) + " ";
        };
        put("M", 1);
        for (const bool curved : sub.curved) put(curved ? "C" : "L", curved ? 3 : 1);
        if (sub.closed) text += "Z";
    }
    node.attribute("d").set_value(text.c_str());
}

/// transform-origin as translations, where both are written as attributes or in `style`.
void Preparation::place_origin(xml_node node) {
    std::string origin = node.attribute("transform-origin").value();
    std::string style = node.attribute("style").value();
    if (const std::size_t at = style.find("transform-origin"); at != std::string::npos) {
        const std::size_t colon = style.find(':', at);
        const std::size_t end = std::min(style.find(';', at), style.size());
        if (colon == std::string::npos || colon > end) return;
        origin = style.substr(colon + 1, end - colon - 1);
        style.erase(at, end - at);
        node.attribute("style").set_value(style.c_str());
    }
    node.remove_attribute("transform-origin");
    const bool css = style.find("transform:") != std::string::npos;
    if (is_svg_origin(trimmed(origin)) || (!node.attribute("transform") && !css)) return;
    std::istringstream words(origin);
    std::string x, y, z;
    words >> x >> y >> z;
    try {
        if (css || y.empty() || !z.empty() || origin.find('%') != std::string::npos)
            throw SvgTextError{"", 0};
        const double by_x = parse_svg_length(x, 0);
        const double by_y = parse_svg_length(y, 0);
        const std::string moved = "translate(" + decimal(by_x) + " " + decimal(by_y) + ") " +
                                  node.attribute("transform").value() + " translate(" +
                                  decimal(-by_x) + " " + decimal(-by_y) + ")";
        node.attribute("transform").set_value(moved.c_str());
    } catch (const SvgTextError&) {
        prepared_.notes.doubt("its transform-origin '" + origin + "' is not followed here");
    }
}

/// Whether lengths among its attributes say what is drawn.
bool takes_lengths(const xml_node& node) {
    return node.parent().type() == pugi::node_element &&
           !is_one_of(local_name(node.name()),
                      {"linearGradient", "radialGradient", "pattern", "filter", "mask", "stop"});
}

/// Places and transforms that `style` says where a library reads attributes alone.
void Preparation::place(xml_node node) {
    const std::string_view tag = local_name(node.name());
    if (tag == "use")
        for (const char* name : {"x", "y"}) {
            const std::string value = svg_style_property(node, name);
            if (value.empty()) continue;
            remove_svg_property(node, name);
            node.append_attribute(name).set_value(value.c_str());
        }
    const bool is_root = node.parent().type() != pugi::node_element;
    if (is_one_of(tag, {"use", "symbol", "svg"}) && !is_root)
        for (const char* name : {"x", "y", "width", "height"})
            if (!svg_style_property(node, name).empty())
                prepared_.notes.doubt("its <" + std::string(tag) + "> has a " + name +
                                      " in its style, which is not followed here");
    if (!svg_style_property(node, "transform").empty()) node.remove_attribute("transform");
    if (css_.sheets_transform() && node.attribute("transform"))
        prepared_.notes.doubt(
            "its style sheet transforms elements, which is not followed here where they have a "
            "transform of their own");
}

void Preparation::prepare_attributes(xml_node node) {
    place_origin(node);
    std::vector<std::string> dropped;
    if (const auto opacity = node.attribute("opacity")) {
        const std::string display = css_.display_for(opacity.value());
        const std::string_view style = node.attribute("style").value();
        const bool styled = style.find("opacity") != std::string_view::npos;
        node.remove_attribute("opacity");
        if (display == "none" && !styled) {
            node.remove_attribute("display");
            node.append_attribute("display").set_value("none");
            if (style.find("display") != std::string_view::npos)
                node.attribute("style").set_value((std::string(style) + ";display:none").c_str());
        }
    }
    for (pugi::xml_attribute attribute : node.attributes()) {
        const std::string name = attribute.name();
        std::string value = attribute.value();
        if (name.starts_with("xmlns:") && value.find('&') != std::string::npos) {
            attribute.set_value(name == "xmlns:xlink" ? "http://www.w3.org/1999/xlink" : "urn:x");
            continue;
        }
        if (name == "style")
            value = css_.declarations(value);
        else if (is_presentation(name) || (is_svg_length(name) && takes_lengths(node)))
            value = css_.value(name, value);
        else
            continue;
        if (value.empty())
            dropped.push_back(name);
        else
            attribute.set_value(value.c_str());
    }
    for (const std::string& name : dropped) node.remove_attribute(name.c_str());
    place(node);
    if (node.attribute("pathLength") && xml_.source.find("dash") != std::string::npos)
        prepared_.notes.doubt("it measures dashes by pathLength, which is not followed here");
}

bool Preparation::prepare_element(xml_node node, bool drawn) {
    if (!is_svg_element(node)) return true;
    lod::check_interrupted();
    const std::string_view tag = local_name(node.name());
    if (!keep_by_conditions(node) || !keep_by_tag(node, tag, drawn)) return false;
    check_grammar(node, tag);
    prepare_attributes(node);
    if (tag == "path") write_arcs(node);
    const std::string_view style = node.attribute("style").value();
    const bool hidden = std::string_view(node.attribute("display").value()) == "none" ||
                        style.find("display:none") != std::string_view::npos;
    const bool inert =
        is_one_of(tag, {"clipPath", "mask", "pattern", "marker", "title", "desc", "metadata"}) ||
        (is_one_of(tag, {"defs", "symbol"}) && xml_.source.find("use") == std::string::npos);
    prepare_children(node, drawn && !hidden && !inert);
    return true;
}

void Preparation::prepare_children(xml_node node, bool drawn) {
    for (xml_node child = node.first_child(); child;) {
        const xml_node next = child.next_sibling();
        if (child.type() == pugi::node_element && !prepare_element(child, drawn))
            node.remove_child(child);
        child = next;
    }
}

/// The outermost element fills a viewport of the page's size.
void Preparation::prepare_root() {
    xml_node root = document_.document_element();
    const SvgPage page = svg_page_of(xml_);
    prepared_.paged = page.size || page.view_box;
    prepared_.size = page.size ? *page.size : page.percent_of().value_or(Point(100, 100));
    const auto set = [&](const char* name, const std::string& value) {
        root.remove_attribute(name);
        root.append_attribute(name).set_value(value.c_str());
    };
    if (!page.view_box) {
        set("viewBox", "0 0 " + decimal(prepared_.size.x()) + " " + decimal(prepared_.size.y()));
        root.remove_attribute("preserveAspectRatio");
    }
    const std::string_view aspect = root.attribute("preserveAspectRatio").value();
    if (aspect.starts_with("none") && !settings_.page && is_stretched(page)) {
        prepared_.notes.doubt("a browser stretches it to its page (the option page does)");
        root.remove_attribute("preserveAspectRatio");
    }
    for (const char* name : {"x", "y"}) root.remove_attribute(name);
    set("width", "100%");
    set("height", "100%");
    if (!svg_property(root, "transform").empty())
        prepared_.notes.doubt("the transform of its outermost <svg> is not followed here");
    if (std::string_view(root.name()) == "svg" && !root.attribute("xmlns"))
        set("xmlns", "http://www.w3.org/2000/svg");
    if (!root.attribute("xmlns:xlink")) set("xmlns:xlink", "http://www.w3.org/1999/xlink");
}

SvgFrame Preparation::frame() const {
    SvgFrame frame;
    const xml_node root = document_.document_element();
    const auto visit = [&](const auto& self, const xml_node& node) -> void {
        const std::string_view tag = local_name(node.name());
        frame.has_uses = frame.has_uses || tag == "use";
        frame.has_viewports =
            frame.has_viewports || tag == "symbol" || (tag == "svg" && node != root);
        for (const xml_node& child : node.children()) self(self, child);
    };
    visit(visit, root);
    if (!frame.has_viewports && xml_.source.find("marker") == std::string::npos)
        frame.percent_of = svg_page_of(xml_).percent_of();
    const bool sheets_size = sheets_.find("font") != std::string::npos;
    const std::string style = root.attribute("style").value();
    if (!sheets_size && !root.attribute("font-size") && style.find("font") == std::string::npos)
        frame.root_font = 16;
    return frame;
}

PreparedSvg Preparation::prepare() {
    check_svg_uses(xml_, settings_);
    css_.learn_root(document_.document_element().attribute("style").value());
    learn(document_.document_element());
    css_.set_frame(frame());
    if (xml_.source.find("<?xml-stylesheet") != std::string::npos)
        prepared_.notes.doubt(
            "its style sheet is another file (xml-stylesheet), which is not read");
    (void)prepare_element(document_.document_element(), true);
    prepare_root();
    check_viewports(document_, prepared_.notes);
    masks_to_clips(document_, prepared_.notes);
    unnest_clips(document_, prepared_.notes);
    box_clips_to_user_space(document_, prepared_.notes);
    fill_patterns(document_, prepared_.notes);
    std::ostringstream text;
    document_.document_element().print(text, "", pugi::format_raw, pugi::encoding_utf8);
    prepared_.text = text.str();
    return std::move(prepared_);
}

}  // namespace

PreparedSvg prepare_svg(const SvgXml& xml, const SvgSettings& settings) {
    return Preparation(xml, settings).prepare();
}

}  // namespace lod2d
