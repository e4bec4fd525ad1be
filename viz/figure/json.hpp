#pragma once

/// \file
/// A figure as JSON.

#include <string>

#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// Whether a text is laid out for people, one value a line, or as short as can be.
enum class Spacing { lines, none };

/// The figure's data; read by machines. Keys are documented in viz/figure/json.cpp. Throws as
/// check_figure does.
[[nodiscard]] std::string json_text(const Figure& figure, Spacing spacing = Spacing::lines);

}  // namespace viz
