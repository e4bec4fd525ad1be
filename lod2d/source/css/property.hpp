#pragma once

#include <string>

namespace pugi {
class xml_node;
}

// Properties of an element whose `style` is plain CSS (lod2d/source/css/css.hpp): "name:value;" and
// no more.
namespace lod2d {

/// The value of a property in `style`, where the last counts, or as an attribute; "" where neither
/// is there.
[[nodiscard]] std::string svg_property(const pugi::xml_node& node, const std::string& name);

/// The same in `style` alone.
[[nodiscard]] std::string svg_style_property(const pugi::xml_node& node, const std::string& name);

/// Takes it out of both.
void remove_svg_property(pugi::xml_node node, const std::string& name);

/// Puts an element in a group of its own, which takes over its id and its transform; no group where
/// the style sheets of the document might tell, or the element is the outermost or draws nothing.
[[nodiscard]] pugi::xml_node wrap_in_group(pugi::xml_node node, const std::string& sheets);

}  // namespace lod2d
