#pragma once

#include <chrono>
#include <functional>

#include "lodlab/viz/paint/paint.hpp"

namespace viz {

/// An animation as pixels, one picture at a time: what a draft leaves out, the progress and the
/// time left, the check for an interruption. Knows nothing of video formats.
class Film {
  public:
    /// Throws lod::Error (input refused) for an animation without frames or with a frame rate that
    /// is not within 1..240.
    Film(const Animation& animation, const WriteOptions& options);

    /// The first picture: it decides the size.
    [[nodiscard]] const Image& first() const { return first_; }
    [[nodiscard]] int frames() const { return total_; }
    [[nodiscard]] double frames_per_second() const;

    /// Some pictures spread over the whole, for a palette.
    void sample(const std::function<void(const Image&)>& see) const;

    /// Every picture in order, the number of its first frame, and how many frames it stands.
    /// Throws lod::Interrupted when stop_requested is set, lod::Error (input refused) for a picture
    /// of another size.
    void play(const std::function<void(const Image&, int number, int frames)>& show) const;

  private:
    struct Scene {
        std::size_t shot;
        int frames;
    };
    [[nodiscard]] Image picture(const Scene& scene) const;

    const Animation& animation_;
    const WriteOptions& options_;
    int every_ = 1;              ///< a draft takes every second frame
    std::vector<Scene> scenes_;  ///< the shots that are seen
    int total_ = 0;
    Image first_;
};

}  // namespace viz
