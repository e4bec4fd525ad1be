#pragma once

#include <string>

namespace pugi {
class xml_node;
}

// Properties of an element whose `style` is plain CSS (svg_css.hpp): "name:value;" and no more.
namespace lod2d {

/// The value of a property in `style`, where the last counts, or as an attribute; "" where neither
/// is there.
[[nodiscard]] std::string svg_property(const pugi::xml_node& node, const std::string& name);

/// The same in `style` alone.
[[nodiscard]] std::string svg_style_property(const pugi::xml_node& node, const std::string& name);

/// Takes it out of both.
void remove_svg_property(pugi::xml_node node, const std::string& name);

}  // namespace lod2d
