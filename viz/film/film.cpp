#include "lodlab/viz/film/film.hpp"

#include <algorithm>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace viz {
namespace {

constexpr std::size_t most_samples = 24;
constexpr double fastest_draft = 31;  ///< a draft halves what is quicker than half of this [1/s]

[[noreturn]] void refuse(const std::string& what) {
    throw lod::Error(lod::ErrorKind::input_refused, "cannot film the animation: " + what);
}

}  // namespace

Film::Film(const Animation& animation, const WriteOptions& options)
    : animation_(animation), options_(options) {
    if (!(animation.frames_per_second >= 1 && animation.frames_per_second <= 240))
        refuse("its frame rate is not within 1..240 a second; choose 30 or 60");
    if (options.quality == Quality::draft && animation.frames_per_second > fastest_draft / 2)
        every_ = 2;
    int begin = 0;
    for (std::size_t shot = 0; shot < animation.shots.size(); ++shot) {
        const int end = begin + std::max(1, animation.shots[shot].frames);
        // Frames begin, begin + 1, ..., end - 1: those divisible by every_ are seen.
        const int seen = (end + every_ - 1) / every_ - (begin + every_ - 1) / every_;
        if (seen > 0) scenes_.push_back({shot, seen});
        total_ += seen;
        begin = end;
    }
    if (scenes_.empty()) refuse("it has no frames; add a figure to it");
    first_ = picture(scenes_[0]);
}

double Film::frames_per_second() const {
    return animation_.frames_per_second / every_;
}

Image Film::picture(const Scene& scene) const {
    lod::check_interrupted();
    return rasterise(animation_.shots[scene.shot].draw(), options_.theme, options_.quality);
}

void Film::sample(const std::function<void(const Image&)>& see) const {
    see(first_);
    const std::size_t step = std::max<std::size_t>(1, scenes_.size() / most_samples);
    for (std::size_t i = step; i < scenes_.size(); i += step) see(picture(scenes_[i]));
}

void Film::play(const std::function<void(const Image&, int, int)>& show) const {
    const auto start = std::chrono::steady_clock::now();
    int number = 0;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
        const Image image = i == 0 ? first_ : picture(scenes_[i]);
        if (image.width != first_.width || image.height != first_.height)
            refuse("its figures have different aspects; give all the same");
        show(image, number, scenes_[i].frames);
        number += scenes_[i].frames;
        if (!options_.progress) continue;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        const double left = spent.count() / number * (total_ - number);
        options_.progress({number, total_, number < 3 ? -1 : left});
    }
}

}  // namespace viz
