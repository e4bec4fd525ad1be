#pragma once

#include <string>

namespace viz {

/// One SVG of two that show the same figure, light and dark: it is light, or dark where its reader
/// prefers that. Throws lod::Error (output failed) where they differ in more than inks and
/// pictures.
[[nodiscard]] std::string for_both_themes(const std::string& light, const std::string& dark);

/// The same SVG in fewer bytes: coordinates rounded to a hundredth of a page unit, styles that are
/// used again and again named once.
[[nodiscard]] std::string compacted(const std::string& svg);

}  // namespace viz
