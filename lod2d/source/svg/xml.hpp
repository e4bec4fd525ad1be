#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/svg/text.hpp"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace lod2d {

/// A parsed drawing, with what its errors need. Its entities are resolved.
struct SvgXml {
    std::string name;
    std::string source;  ///< UTF-8: what lines and columns are of
    std::shared_ptr<pugi::xml_document> document;

    [[nodiscard]] pugi::xml_node root() const;
    /// Throws lod::Error: "cannot read NAME, line 3, column 7: why".
    [[noreturn]] void refuse(const pugi::xml_node& at, const std::string& why,
                             lod::ErrorKind kind = lod::ErrorKind::input_refused) const;
};

/// Throws lod::Error as svg_source() does, and (input refused) for broken XML, for a document whose
/// outermost element is no <svg>, and for an entity that stands outside, draws elements or grows
/// beyond a million characters.
[[nodiscard]] SvgXml parse_svg_xml(const std::string& name, std::string_view bytes,
                                   std::size_t most_bytes);

/// An element's or attribute's name without its namespace prefix.
[[nodiscard]] std::string_view local_name(std::string_view name);

/// Whether an element is of SVG, and not of another vocabulary. Where a document names no namespace
/// at all, its elements are.
[[nodiscard]] bool is_svg_element(const pugi::xml_node& element);

/// What a link of a `use` or a gradient names: the value of href, or of the older xlink:href.
[[nodiscard]] std::string svg_link(const pugi::xml_node& element);

/// Calls parse(value of the attribute) and refuses what does not follow its grammar.
[[nodiscard]] CurvePath svg_path_of(const SvgXml& xml, const pugi::xml_node& element);
[[nodiscard]] std::vector<Point> svg_points_of(const SvgXml& xml, const pugi::xml_node& element);
[[nodiscard]] Affine svg_transform_of(const SvgXml& xml, const pugi::xml_node& element);
/// A length in user units; nothing where it is absent or "auto".
[[nodiscard]] std::optional<double> svg_length_of(const SvgXml& xml, const pugi::xml_node& element,
                                                  const char* attribute, double percent_of);

/// What the outermost element says about the page. User units, y down.
struct SvgPage {
    /// width and height where both are lengths that need no window (mm, px; not %, vw, calc()).
    std::optional<Point> size;
    std::optional<std::array<double, 4>> view_box;  ///< x, y, width, height; where it is right

    /// What percentages are of: the view box, or else the page; nothing where neither is there.
    [[nodiscard]] std::optional<Point> percent_of() const;
};
[[nodiscard]] SvgPage svg_page_of(const SvgXml& xml);

}  // namespace lod2d
