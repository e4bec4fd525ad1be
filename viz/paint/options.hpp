#pragma once

/// \file
/// How a figure is written: theme, size, and what is told of the progress.

#include <functional>
#include <string>

namespace viz {

/// For a light page or a dark one.
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

/// How a picture or video is written.
struct WriteOptions {
    Theme theme = Theme::light;
    Quality quality = Quality::p720;
    bool few_bytes =
        false;  ///< a video in few bytes, for a page: lines stay clear, not every grain
    std::function<void(const Progress&)> progress;  ///< called after every drawn frame of a video
    std::function<void(const std::string&)> warn;   ///< told of a fallback ("no H.264 encoder ...")
};

}  // namespace viz
