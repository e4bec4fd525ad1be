#include "lodlab/lod2d/source/svg/xml.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <set>

#include "lodlab/lod2d/source/svg/source.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
constexpr std::string_view link_namespace = "http://www.w3.org/1999/xlink";

/// Puts the texts of entities where they are named.
class Entities {
  public:
    explicit Entities(const SvgXml& xml) : xml_(xml), known_(svg_entities(xml.source)) {}

    void resolve(const xml_node& node);

  private:
    [[nodiscard]] const SvgEntity* find(std::string_view text, std::size_t at) const;
    std::string resolved(const xml_node& at, std::string_view text, int depth);

    const SvgXml& xml_;
    std::vector<SvgEntity> known_;
    std::size_t grown_ = 0;
};

/// The entity named at the '&' of text, if any.
const SvgEntity* Entities::find(std::string_view text, std::size_t at) const {
    const std::size_t end = text.find(';', at);
    if (end == std::string_view::npos) return nullptr;
    const std::string_view name = text.substr(at + 1, end - at - 1);
    const auto found = std::ranges::find(known_, name, &SvgEntity::name);
    return found == known_.end() ? nullptr : &*found;
}

std::string Entities::resolved(const xml_node& at, std::string_view text, int depth) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const SvgEntity* entity = text[i] == '&' ? find(text, i) : nullptr;
        if (!entity) {
            result += text[i];
            continue;
        }
        const std::string named = "the entity &" + entity->name + ";";
        if (entity->outside)
            xml_.refuse(at,
                        named + " stands in another file, which is not read; put its text here");
        if (entity->text.find('<') != std::string::npos)
            xml_.refuse(at, named + " stands for elements; write them where it is named");
        grown_ += entity->text.size();
        if (depth > 20 || grown_ > 1'000'000)
            xml_.refuse(at, named + " grows beyond a million characters; write its text out");
        result += resolved(at, entity->text, depth + 1);
        i += entity->name.size() + 1;
    }
    return result;
}

void Entities::resolve(const xml_node& node) {
    if (known_.empty()) return;
    for (pugi::xml_attribute attribute : node.attributes()) {
        const std::string_view value = attribute.value();
        if (value.find('&') != std::string_view::npos)
            attribute.set_value(resolved(node, value, 0).c_str());
    }
    const std::string_view tag = local_name(node.name());
    const bool prose = tag == "desc" || tag == "title" || tag == "metadata" || tag == "text";
    for (xml_node child : node.children()) {
        if (child.type() == pugi::node_element) {
            if (!prose) resolve(child);
        } else if (child.type() == pugi::node_pcdata && !prose) {
            const std::string_view value = child.value();
            if (value.find('&') != std::string_view::npos)
                child.set_value(resolved(node, value, 0).c_str());
        }
    }
}

void check_depth(const SvgXml& xml, const xml_node& root) {
    constexpr int most_depth = 1000;  // what walks by calling itself may meet
    int depth = 0;
    for (xml_node node = root; node;) {
        if (node.first_child()) {
            node = node.first_child();
            if (++depth > most_depth)
                xml.refuse(node,
                           "its elements are nested deeper than " + std::to_string(most_depth) +
                               "; simplify it",
                           lod::ErrorKind::limit_exceeded);
            continue;
        }
        while (node && node != root && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        node = node == root ? xml_node() : node.next_sibling();
    }
}

/// What a browser takes for broken where pugixml does not: an & that names nothing, and an
/// attribute that stands twice.
class WellFormedness {
  public:
    explicit WellFormedness(const SvgXml& xml) : xml_(xml), known_(svg_entities(xml.source)) {}

    void check_references() const {
        struct Skipped {
            std::string_view opening;
            std::string_view closing;
        };
        static constexpr Skipped skipped[] = {
            {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!DOCTYPE", ""}};
        const std::string_view source = xml_.source;
        for (std::size_t i = source.find_first_of("<&"); i < source.size();
             i = source.find_first_of("<&", i + 1)) {
            if (source[i] == '&') check_reference(i);
            for (const auto& [opening, closing] : skipped) {
                if (!source.substr(i).starts_with(opening)) continue;
                i = closing.empty() ? end_of_doctype(i) : source.find(closing, i);
                if (i >= source.size()) return;
                break;
            }
        }
    }

    void check_attributes(const xml_node& node) const {
        std::set<std::string_view> names;
        for (const pugi::xml_attribute& attribute : node.attributes())
            if (!names.insert(attribute.name()).second)
                xml_.refuse(node, std::string("broken XML: the attribute ") + attribute.name() +
                                      " stands twice");
        for (const xml_node& child : node.children()) check_attributes(child);
    }

  private:
    [[nodiscard]] std::size_t end_of_doctype(std::size_t at) const {
        const std::size_t subset = xml_.source.find_first_of("[>", at);
        if (subset >= xml_.source.size() || xml_.source[subset] == '>') return subset;
        return xml_.source.find("]", subset);
    }

    void check_reference(std::size_t at) const {
        const std::string_view rest = std::string_view(xml_.source).substr(at + 1, 100);
        const std::string_view name = rest.substr(0, std::min(rest.find(';'), rest.size()));
        const bool ends = name.size() < rest.size() && !name.empty() &&
                          name.find_first_of(" \t\r\n\f<>&\"'") == std::string_view::npos;
        const bool declared = name.starts_with('#') ||
                              is_one_of(name, {"amp", "lt", "gt", "quot", "apos"}) ||
                              std::ranges::find(known_, name, &SvgEntity::name) != known_.end() ||
                              xml_.source.find("<!ENTITY %") != std::string::npos;
        if (ends && declared) return;
        lod::refuse_input("cannot read " + xml_.name + ", " + svg_place(xml_.source, at),
                          ends ? "broken XML: the entity &" + std::string(name) +
                                     "; is not declared; write its text"
                               : std::string("broken XML: a bare &; write &amp;"));
    }

    const SvgXml& xml_;
    std::vector<SvgEntity> known_;
};

template <typename Parse>
auto parsed(const SvgXml& xml, const xml_node& element, const char* attribute, Parse parse)
    -> decltype(parse(std::string_view())) {
    try {
        return parse(std::string_view(element.attribute(attribute).value()));
    } catch (const SvgTextError& error) {
        xml.refuse(element, "<" + std::string(element.name()) + "> has a broken " + attribute +
                                ": expected " + error.expected + " after " +
                                std::to_string(error.place) + " characters");
    }
}

/// The namespace of a prefix, or of none; nothing where the document does not say.
std::optional<std::string_view> namespace_of(xml_node at, std::string_view prefix) {
    const std::string attribute = prefix.empty() ? "xmlns" : std::string("xmlns:").append(prefix);
    for (; at; at = at.parent())
        if (const auto found = at.attribute(attribute.c_str())) return found.value();
    return std::nullopt;
}

std::string_view prefix_of(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

}  // namespace

xml_node SvgXml::root() const {
    return document->document_element();
}

void SvgXml::refuse(const xml_node& at, const std::string& why, lod::ErrorKind kind) const {
    const auto offset = at.offset_debug();
    const std::string place =
        offset < 0 ? "" : ", " + svg_place(source, static_cast<std::size_t>(offset));
    throw lod::Error(kind, "cannot read " + name + place + ": " + why);
}

SvgXml parse_svg_xml(const std::string& name, std::string_view bytes, std::size_t most_bytes) {
    SvgXml xml{name, svg_source(name, bytes, most_bytes), std::make_shared<pugi::xml_document>()};
    const pugi::xml_parse_result result = xml.document->load_buffer(
        xml.source.data(), xml.source.size(), pugi::parse_default | pugi::parse_ws_pcdata_single,
        pugi::encoding_utf8);
    if (!result) {
        const auto offset =
            std::clamp(static_cast<std::size_t>(std::max(result.offset, std::ptrdiff_t{0})),
                       std::size_t{0}, xml.source.size());
        lod::refuse_input("cannot read " + name + ", " + svg_place(xml.source, offset),
                          std::string("broken XML: ") + result.description());
    }
    const xml_node root = xml.root();
    if (local_name(root.name()) != "svg")
        xml.refuse(root, "the outermost element is not <svg>; give an SVG file");
    check_depth(xml, root);
    const WellFormedness form(xml);
    form.check_references();
    form.check_attributes(root);
    Entities(xml).resolve(root);
    if (!is_svg_element(root))
        xml.refuse(root, "its <svg> is of another namespace; write xmlns=\"" +
                             std::string(svg_namespace) + "\"");
    return xml;
}

std::string_view local_name(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_svg_element(const xml_node& element) {
    const std::string_view prefix = prefix_of(element.name());
    const auto of = namespace_of(element, prefix);
    return of ? *of == svg_namespace : prefix.empty() || prefix == "svg";
}

std::string svg_link(const xml_node& element) {
    if (const auto link = element.attribute("href")) return link.value();
    for (const pugi::xml_attribute& attribute : element.attributes()) {
        if (local_name(attribute.name()) != "href") continue;
        const std::string_view prefix = prefix_of(attribute.name());
        const auto of = namespace_of(element, prefix);
        if (of ? *of == link_namespace : prefix == "xlink") return attribute.value();
    }
    return {};
}

CurvePath svg_path_of(const SvgXml& xml, const xml_node& element) {
    return parsed(xml, element, "d", parse_svg_path);
}

std::vector<Point> svg_points_of(const SvgXml& xml, const xml_node& element) {
    return parsed(xml, element, "points", parse_svg_points);
}

Affine svg_transform_of(const SvgXml& xml, const xml_node& element) {
    return parsed(xml, element, "transform", parse_svg_transform);
}

std::optional<double> svg_length_of(const SvgXml& xml, const xml_node& element,
                                    const char* attribute, double percent_of) {
    const std::string_view text = element.attribute(attribute).value();
    if (text.empty() || text == "auto") return std::nullopt;
    return parsed(xml, element, attribute,
                  [&](std::string_view value) { return parse_svg_length(value, percent_of); });
}

std::optional<Point> SvgPage::percent_of() const {
    if (view_box) return Point((*view_box)[2], (*view_box)[3]);
    return size;
}

SvgPage svg_page_of(const SvgXml& xml) {
    SvgPage page;
    const xml_node root = xml.root();
    const auto length = [&](const char* attribute) -> std::optional<double> {
        const std::string_view text = root.attribute(attribute).value();
        if (text.find('%') != std::string_view::npos) return std::nullopt;
        try {
            const double value = parse_svg_length(text, 0);
            if (value > 0 && value < 1e60) return value;
        } catch (const SvgTextError&) {  // vw, calc(): what a window decides
        }
        return std::nullopt;
    };
    const auto width = length("width");
    const auto height = length("height");
    if (width && height) page.size = Point(*width, *height);
    try {
        const auto box = parse_svg_view_box(root.attribute("viewBox").value());
        const bool finite =
            std::ranges::all_of(box, [](double v) { return v > -1e60 && v < 1e60; });
        if (finite && box[2] > 0 && box[3] > 0) page.view_box = box;
    } catch (const SvgTextError&) {  // browsers leave a broken one out
    }
    return page;
}

}  // namespace lod2d
