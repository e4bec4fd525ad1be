#pragma once

/// \file
/// An animation as MP4, WebM or GIF, and which encoders are there.

#include <filesystem>
#include <string>

#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace viz {

/// MP4 (H.264), WebM (VP9) or GIF by the path's ending; a file that is complete or absent, the same
/// bytes for the same input. Drawn frame by frame. Throws as write_png does, lod::Error (not
/// installed) for a missing encoder, and lod::Interrupted when stop_requested is set;
/// nothing is left behind then.
void write_video(const std::filesystem::path& path, const Animation& animation,
                 const WriteOptions& options);

/// The encoder that an ending's videos get here ("libx264", "libvpx-vp9", "gif", ...), or an empty
/// string where there is none: for `lodlab doctor`.
[[nodiscard]] std::string video_encoder(const std::string& ending);

/// The names of the versions of the video libraries in use, for `lodlab doctor`.
[[nodiscard]] std::string video_libraries();

}  // namespace viz
