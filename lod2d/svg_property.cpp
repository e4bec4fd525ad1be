#include "lodlab/lod2d/svg_property.hpp"

#include <algorithm>
#include <pugixml.hpp>

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

}  // namespace lod2d
