// Frames per second of drawing and of encoding: the same film of circle trees, once to pixels only
// and once to each kind of file.
//
// bench_drawing [FRAMES]

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/timing.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/film/video.hpp"
#include "lodlab/viz/film/write.hpp"
#include "lodlab/viz/paint/paint.hpp"

namespace {

viz::Actor<2> actor(const lod2d::Shape& shape) {
    viz::Actor<2> result;
    result.visual = viz::visual_of(shape);
    lod::set_mass<2>(result.body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    lod2d::TreeSettings settings;
    settings.builder = lod2d::Builder::quadtree;
    result.body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
    return result;
}

/// A gear turns past a star; each frame shows the nodes that are tested at level 3.
viz::Figure frame(const viz::Actor<2>& star, viz::Actor<2> gear, int number) {
    gear.body.position = {0.75, 0.1};
    gear.body.orientation = 0.02 * number;
    const auto fronts = lod::traverse_levels(star.body, gear.body);
    return viz::traversal_level(star, gear, fronts,
                                std::min(3, static_cast<int>(fronts.size()) - 1));
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 60;
    const viz::Actor<2> star = actor(lod2d::generate("star:5"));
    const viz::Actor<2> gear = actor(lod2d::generate("gear:9"));
    viz::Animation film;
    for (int number = 0; number < frames; ++number)
        film.shots.push_back({[&star, &gear, number] { return frame(star, gear, number); }, 1});

    const auto folder = std::filesystem::temp_directory_path();
    for (const auto& [quality, size] : {std::pair{viz::Quality::p720, "1280 x 720"},
                                        std::pair{viz::Quality::p1080, "1920 x 1080"}}) {
        std::size_t marks = 0;
        const double data = bench::seconds([&] {
            for (int i = 0; i < frames; ++i) marks += frame(star, gear, i).panels.size();
        });
        const double drawn = bench::seconds([&, q = quality] {
            for (int i = 0; i < frames; ++i)
                marks += viz::rasterise(frame(star, gear, i), viz::Theme::light, q).pixels.size();
        });
        std::printf("%s: figures as data %.0f a second, drawn %.1f frames a second (processor)\n",
                    size, frames / data, frames / drawn);
        viz::WriteOptions options;
        options.quality = quality;
        for (const char* ending : {"mp4", "webm", "gif"}) {
            const auto path = folder / (std::string("lodlab_bench_drawing.") + ending);
            double wall = 0;
            const double all = bench::seconds([&] {
                wall = bench::wall_seconds([&] { viz::write_animation(path, film, options); });
            });
            std::printf(
                "  %-4s (%s): drawn and encoded %.1f frames a second by the clock, "
                "%.1f by the processor; encoding alone %.1f; %.0f kB\n",
                ending, viz::video_encoder(ending).c_str(), frames / wall, frames / all,
                frames / std::max(1e-9, all - drawn),
                static_cast<double>(std::filesystem::file_size(path)) / 1000);
            std::filesystem::remove(path);
        }
        if (marks == 0) std::puts("nothing was drawn");  // keeps the work from being left out
    }
    std::puts(
        "Limits, by a profile: drawing, half of it Cairo's paths and text and half the search\n"
        "for places where labels cover nothing, so pixels matter little; encoding, the\n"
        "encoder's own search (VP9's above all), and for GIF the palette.");
}
