#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "lodlab/viz/figure.hpp"

namespace viz {

enum class Theme { light, dark };

/// Size of the page's shorter side: 540, 720, 1080, 2160 pixels at 16:9. A draft's video also has
/// half the frames.
enum class Quality { draft, p720, p1080, p4k };

/// How far a long piece of work has come.
struct Progress {
    int done = 0;
    int total = 0;
    double seconds_left = 0;  ///< by the pace so far; negative while that is not known
};

struct WriteOptions {
    Theme theme = Theme::light;
    Quality quality = Quality::p720;
    std::function<void(const Progress&)> progress;  ///< called after every drawn frame of a video
    std::function<void(const std::string&)> warn;   ///< told of a fallback ("no H.264 encoder ...")
};

/// Every writer makes a file that is complete or absent, the same bytes for the same input. They
/// throw lod::Error: input refused for a figure that cannot be drawn (a number that is not finite,
/// a radius below zero, an empty view), naming the panel and the mark; output failed for an
/// unwritable folder or a full disk; not installed for a missing encoder. A video is drawn frame by
/// frame and throws lod::Interrupted when a signal asks the program to stop; nothing is left behind
/// then.
void write_png(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});
void write_svg(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});
void write_pdf(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});
/// The figure's data; read by machines. Keys are documented in viz/json.cpp.
void write_json(const std::filesystem::path& path, const Figure& figure);

/// MP4 (H.264), WebM (VP9) or GIF by the path's ending.
void write_video(const std::filesystem::path& path, const Animation& animation,
                 const WriteOptions& options = {});

/// Picks the format by the ending: png, svg, pdf, json. Any other ending throws lod::Error (usage).
void write_figure(const std::filesystem::path& path, const Figure& figure,
                  const WriteOptions& options = {});

/// Picks the format by the ending: mp4, webm, gif. Any other ending throws lod::Error (usage).
void write_animation(const std::filesystem::path& path, const Animation& animation,
                     const WriteOptions& options = {});

/// Whether a path's ending names a still picture (png svg pdf json) or a video (mp4 webm gif).
[[nodiscard]] bool is_figure_path(const std::filesystem::path& path);
[[nodiscard]] bool is_video_path(const std::filesystem::path& path);

/// Throws lod::Error (input refused) unless the figure can be drawn: every number finite and of a
/// size that a picture can hold (below 1e12), radii >= 0, opacities within 0..1, views not empty,
/// logarithmic axes above 0.
void check_figure(const Figure& figure);

/// The encoder that an ending's videos get here ("libx264", "libvpx-vp9", "gif", ...), or an empty
/// string where there is none: for `lodlab doctor`.
[[nodiscard]] std::string video_encoder(const std::string& ending);

/// The names of the versions of the drawing and video libraries in use, for `lodlab doctor`.
[[nodiscard]] std::string drawing_libraries();
[[nodiscard]] std::string video_libraries();

}  // namespace viz
