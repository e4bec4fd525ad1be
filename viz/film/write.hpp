#pragma once

/// \file
/// A video in the format that its file's ending names.

#include <filesystem>

#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace viz {

/// Picks the format by the ending: mp4, webm, gif. Any other ending throws lod::Error (usage); else
/// as write_video does.
void write_animation(const std::filesystem::path& path, const Animation& animation,
                     const WriteOptions& options = {});

/// Whether a path's ending names a video (mp4 webm gif).
[[nodiscard]] bool is_video_path(const std::filesystem::path& path);

}  // namespace viz
