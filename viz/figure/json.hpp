#pragma once

/// \file
/// A figure as JSON.

#include <string>

#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// The figure's data; read by machines. Keys are documented in viz/figure/json.cpp. Throws as
/// check_figure does.
[[nodiscard]] std::string json_text(const Figure& figure);

}  // namespace viz
