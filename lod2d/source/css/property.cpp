#include "lodlab/lod2d/source/css/property.hpp"

#include <algorithm>
#include <pugixml.hpp>

#include "lodlab/lod2d/source/svg/words.hpp"
#include "lodlab/lod2d/source/svg/xml.hpp"

namespace lod2d {

std::string svg_style_property(const pugi::xml_node& node, const std::string& name) {
    const std::string style = std::string(";") + node.attribute("style").value();
    const std::size_t at = style.rfind(";" + name + ":");
    if (at == std::string::npos) return {};
    const std::size_t from = at + name.size() + 2;
    return style.substr(from, style.find(';', from) - from);
}

std::string svg_property(const pugi::xml_node& node, const std::string& name) {
    const std::string styled = svg_style_property(node, name);
    return styled.empty() ? node.attribute(name.c_str()).value() : styled;
}

void remove_svg_property(pugi::xml_node node, const std::string& name) {
    node.remove_attribute(name.c_str());
    std::string style = std::string(";") + node.attribute("style").value();
    while (true) {
        const std::size_t at = style.find(";" + name + ":");
        if (at == std::string::npos) return;
        style.erase(at, std::min(style.find(';', at + 1), style.size()) - at);
        node.attribute("style").set_value(style.c_str());
    }
}

pugi::xml_node wrap_in_group(pugi::xml_node node, const std::string& sheets) {
    const bool is_drawn =
        is_one_of(local_name(node.name()), {"g", "a", "svg", "use", "switch", "path", "rect",
                                            "circle", "ellipse", "line", "polygon", "polyline"});
    if (!is_drawn || node.parent().type() != pugi::node_element) return {};
    const auto sheets_hold = [&](const std::string& what) {
        return sheets.find(what) < sheets.size();
    };
    const std::string id = node.attribute("id").value();
    const bool by_place = sheets.find_first_of(">+~") < sheets.size() || sheets_hold("-child") ||
                          sheets_hold("-of-type");
    if (by_place || sheets_hold("transform") || !svg_style_property(node, "transform").empty() ||
        (!id.empty() && sheets_hold("#" + id)))
        return {};
    const std::string name = node.name();
    const std::size_t colon = name.find(':');
    const std::string prefix = colon == std::string::npos ? "" : name.substr(0, colon + 1);
    pugi::xml_node group = node.parent().insert_child_before((prefix + "g").c_str(), node);
    for (const char* moved : {"id", "transform"}) {
        if (!node.attribute(moved)) continue;
        group.append_attribute(moved).set_value(node.attribute(moved).value());
        node.remove_attribute(moved);
    }
    group.append_move(node);
    return group;
}

}  // namespace lod2d
