#pragma once

#include <string>

namespace viz {

/// An SVG as the drawing library wrote it, finished: title and alt text for screen readers, and ids
/// counted from 1 whatever was drawn before in this process.
[[nodiscard]] std::string finished_svg(const std::string& svg, const std::string& title,
                                       const std::string& alt);

}  // namespace viz
