#include "lodlab/viz/film/write.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/viz/film/video.hpp"

namespace viz {

bool is_video_path(const std::filesystem::path& path) {
    const std::string ending = lod::ending_of(path);
    return ending == "mp4" || ending == "webm" || ending == "gif";
}

void write_animation(const std::filesystem::path& path, const Animation& animation,
                     const WriteOptions& options) {
    if (!is_video_path(path))
        throw lod::Error(lod::ErrorKind::usage,
                         "cannot write " + path.string() +
                             ": its ending names no format; use one of .mp4 .webm .gif");
    write_video(path, animation, options);
}

}  // namespace viz
