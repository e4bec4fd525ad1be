// Milliseconds for a frame of space: a mesh and its sphere tree on a turntable, at three sizes, and
// the same as a still of four panels.
//
// bench_drawing_space [MESH or SPEC] [FRAMES]

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/timing.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/draw_turntable.hpp"
#include "lodlab/viz/paint/paint.hpp"

namespace {

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";  // of glmark2-data

lod3d::Solid solid_named(const std::string& name) {
    if (!std::filesystem::exists(name)) return lod3d::generate(name);
    return lod3d::make_solid(std::filesystem::path(name).stem(), lod3d::load_mesh(name),
                             {.fill = true});
}

}  // namespace

int main(int argc, char** argv) {
    const std::string name = argc > 1 ? argv[1] : std::filesystem::exists(bunny) ? bunny : "knot";
    const int frames = argc > 2 ? std::atoi(argv[2]) : 8;
    const lod3d::Solid solid = solid_named(name);
    viz::Actor<3> actor{viz::visual_of(solid), {}};
    actor.body.tree = std::make_shared<const lod::SphereTree<3>>(
        lod3d::build_tree(solid, {.builder = lod3d::Builder::octree}));
    std::printf("%s: %zu triangles, %d spheres\n", solid.name.c_str(), solid.mesh.triangles.size(),
                actor.body.tree->size());

    const viz::Animation film = viz::turntable(actor);
    const auto step = film.shots.size() / static_cast<std::size_t>(frames);
    std::size_t bytes = 0;
    for (const auto& [quality, size] :
         {std::pair{viz::Quality::draft, "960 x 540"}, std::pair{viz::Quality::p720, "1280 x 720"},
          std::pair{viz::Quality::p1080, "1920 x 1080"}}) {
        const auto rasterised = [&, q = quality](const viz::Figure& figure) {
            bytes += viz::rasterise(figure, viz::Theme::light, q).pixels.size();
        };
        const double turning = bench::seconds([&] {
            for (int i = 0; i < frames; ++i)
                rasterised(film.shots[static_cast<std::size_t>(i) * step].draw());
        });
        const double still = bench::seconds([&] { rasterised(viz::tree_levels(actor)); });
        std::printf("%-12s turntable %.0f ms a frame, tree level by level %.0f ms (processor)\n",
                    size, 1000 * turning / frames, 1000 * still);
    }
    if (bytes == 0) std::puts("nothing was drawn");  // keeps the work from being left out
}
