#pragma once

#include <filesystem>

#include "lodlab/viz/figure/figure.hpp"

namespace viz {

/// The figure's data; read by machines. Keys are documented in viz/figure/json.cpp. Throws as
/// check_figure and lod::write_text_file do.
void write_json(const std::filesystem::path& path, const Figure& figure);

}  // namespace viz
