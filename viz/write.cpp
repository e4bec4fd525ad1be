#include "lodlab/viz/write.hpp"

#include "lodlab/core/error.hpp"
#include "lodlab/viz/ending.hpp"

namespace viz {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* endings) {
    throw lod::Error(
        lod::ErrorKind::usage,
        "cannot write " + path.string() + ": its ending names no format; use one of " + endings);
}

}  // namespace

bool is_figure_path(const std::filesystem::path& path) {
    const std::string end = ending_of(path);
    return end == ".png" || end == ".svg" || end == ".pdf" || end == ".json";
}

bool is_video_path(const std::filesystem::path& path) {
    const std::string end = ending_of(path);
    return end == ".mp4" || end == ".webm" || end == ".gif";
}

void write_figure(const std::filesystem::path& path, const Figure& figure,
                  const WriteOptions& options) {
    const std::string end = ending_of(path);
    if (end == ".png") return write_png(path, figure, options);
    if (end == ".svg") return write_svg(path, figure, options);
    if (end == ".pdf") return write_pdf(path, figure, options);
    if (end == ".json") return write_json(path, figure);
    refuse(path, ".png .svg .pdf .json");
}

void write_animation(const std::filesystem::path& path, const Animation& animation,
                     const WriteOptions& options) {
    if (!is_video_path(path)) refuse(path, ".mp4 .webm .gif");
    write_video(path, animation, options);
}

}  // namespace viz
