#pragma once

#include <map>
#include <string>
#include <string_view>

#include "lodlab/lod2d/clean.hpp"

namespace pugi {
class xml_node;
}

namespace lod2d {

/// What of CSS decides whether and how an element is drawn. Inherited from parent to child, but for
/// `drawn`, which a child cannot bring back.
struct SvgStyle {
    bool filled = true;
    bool fill_seen = true;  ///< fill-opacity above 0
    FillRule rule = FillRule::nonzero;
    bool stroked = false;
    bool stroke_seen = true;
    double stroke_width = 1;
    bool visible = true;
    bool drawn = true;  ///< no display: none and no opacity: 0 on the way here
};

/// The rules of a document's style sheets whose selectors name one element, class or id; others are
/// left out.
class SvgStyleSheet {
  public:
    void read(std::string_view text);
    /// The style of an element within one of the given style.
    [[nodiscard]] SvgStyle style_of(const pugi::xml_node& element, const SvgStyle& parent) const;

  private:
    using Declarations = std::map<std::string, std::string, std::less<>>;
    [[nodiscard]] std::string value_of(const pugi::xml_node& element, std::string_view property,
                                       const Declarations& own) const;
    static void read_declarations(std::string_view text, Declarations& declarations);

    std::map<std::string, Declarations, std::less<>> rules_;  ///< by selector
};

/// An element's or attribute's name without its namespace prefix.
[[nodiscard]] std::string_view local_name(std::string_view name);

}  // namespace lod2d
