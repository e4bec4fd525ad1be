#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lod2d {

/// The text of a drawing as UTF-8: unpacked where it is compressed (svgz), turned from UTF-16, its
/// byte order mark dropped, so that lines and columns can be counted.
/// Throws lod::Error: input refused where it is empty, holds no markup, or is compressed and
/// broken; limit exceeded where it unpacks to more than `most_bytes`.
[[nodiscard]] std::string svg_source(const std::string& name, std::string_view bytes,
                                     std::size_t most_bytes);

/// An entity that the document declares: <!ENTITY name "text">.
struct SvgEntity {
    std::string name;
    std::string text;
    bool outside = false;  ///< SYSTEM or PUBLIC: its text stands in another file
};

/// Those of the document's own declarations, the first of a name only.
[[nodiscard]] std::vector<SvgEntity> svg_entities(std::string_view source);

/// "line 3, column 7" of a byte.
[[nodiscard]] std::string svg_place(std::string_view source, std::size_t offset);

}  // namespace lod2d
