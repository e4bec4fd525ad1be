// Real meshes: what becomes of mesh files, how well sphere trees fit solids, and what a query costs
// at each level beside an exact one.
//
// bench_meshes [files|trees|queries|queries:4]...    the first three where none is named
#include "bench/meshes.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "bench/timing.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/builder/tree_report.hpp"
#include "lodlab/lod3d/source/load_mesh.hpp"

namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

long most_megabytes() {
    rusage own{};
    rusage children{};
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return std::max(own.ru_maxrss, children.ru_maxrss) / 1024;
}

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void read_all(const fs::path& folder) {
    int solids = 0;
    int open = 0;
    int filled = 0;
    int refused = 0;
    double slowest = 0;
    std::string slowest_file;
    const auto files = files_below(folder);
    for (const fs::path& file : files) {
        const auto start = Clock::now();
        bool loaded = false;
        try {
            const lod3d::Mesh mesh = lod3d::load_mesh(file);
            loaded = true;
            try {
                static_cast<void>(lod3d::make_solid(file.stem().string(), mesh));
                ++solids;
            } catch (const lod::Error&) {
                ++open;
                static_cast<void>(lod3d::make_solid(file.stem().string(), mesh, {.fill = true}));
                ++filled;
            }
        } catch (const lod::Error& error) {
            if (!loaded) ++refused;
            if (!loaded && lod3d::is_mesh_format(file.extension().string().erase(0, 1)))
                std::printf("  %s\n", error.what());
        }
        if (seconds_since(start) > slowest) {
            slowest = seconds_since(start);
            slowest_file = file.filename().string();
        }
    }
    std::printf(
        "%zu files: %d solids, %d meshes that bound none as they are (%d of them can be "
        "filled), %d refused\n",
        files.size(), solids, open, filled, refused);
    std::printf("slowest %.2f s (%s), most memory of a process %ld MB\n", slowest,
                slowest_file.c_str(), most_megabytes());
}

/// The solid of one of glmark2's models; those that do not close are filled.
lod3d::Solid model(const std::string& name) {
    const fs::path file = fs::path("/usr/share/glmark2/models") / name;
    const lod3d::Mesh mesh = lod3d::load_mesh(file);
    try {
        return lod3d::make_solid(file.stem().string(), mesh);
    } catch (const lod::Error&) {
        return lod3d::make_solid(file.stem().string() + " (open, filled)", mesh, {.fill = true});
    }
}

void grow(const lod3d::Solid& solid, lod3d::Builder builder) {
    lod3d::TreeSettings settings;
    settings.builder = builder;
    lod::SphereTree<3> tree;
    const double seconds = bench::seconds([&] { tree = lod3d::build_tree(solid, settings); });
    std::printf("%s, %zu triangles, %s: %.1f s of one core\n", solid.name.c_str(),
                solid.mesh.triangles.size(), std::string(lod::name_of(builder)).c_str(), seconds);
    for (const lod::LevelReport& level : lod3d::report_tree(solid, tree).levels)
        std::printf(
            "  level %d  %4d nodes  worst %7.3f %%  mean %7.3f %%  volume ratio %7.3f  %s\n",
            level.level, level.nodes, 100 * level.worst_protrusion_fraction,
            100 * level.mean_protrusion_fraction, level.measure_ratio,
            level.certified ? "certified" : "NOT CERTIFIED");
    std::fflush(stdout);
}

void grow_all() {
    for (const char* name : {"bunny.obj", "asteroid-high.3ds", "horse.3ds", "cat.3ds"}) {
        const lod3d::Solid solid = model(name);
        for (const lod3d::Builder builder : lod::choices<lod3d::Builder>()) grow(solid, builder);
    }
}

}  // namespace

int main(int count, char** words) {
    try {
        const std::vector<std::string_view> named(words + 1, words + count);
        const auto asked = [&](std::string_view part) {
            return named.empty() || std::find(named.begin(), named.end(), part) != named.end();
        };
        const fs::path test_models = "/usr/share/assimp/models";
        for (const fs::path& needed : {test_models, fs::path("/usr/share/glmark2/models")})
            if (!fs::is_directory(needed)) {
                std::fprintf(stderr,
                             "bench_meshes: no folder %s; install assimp-testmodels and "
                             "glmark2-data\n",
                             needed.c_str());
                return 6;
            }
        if (asked("files")) read_all(test_models);
        if (asked("trees")) grow_all();
        for (const auto& [word, depth] : {std::pair{"queries", 3}, std::pair{"queries:4", 4}})
            if (named.empty() ? depth == 3 : asked(word))
                bench::query_pairs(model("bunny.obj"), 1000, depth);
        return 0;
    } catch (const lod::Error& error) {
        std::fprintf(stderr, "bench_meshes: %s\n", error.what());
        return 1;
    }
}
