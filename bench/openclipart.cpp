// How well every builder does on clip art that nobody here drew: how many files give a certified
// tree, how far the circles stand out level by level, and what that costs.
//
// bench_openclipart [FOLDER [DEPTH [MOST_FILES]]]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"
#include "lodlab/lod2d/source/load.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<std::filesystem::path> svg_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".svg") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// What one builder did over all shapes, by level: fractions of the bounding diameter, and so on.
struct Tally {
    int certified = 0;
    std::vector<std::string> failures;
    std::vector<std::vector<double>> worst, mean, ratio;
    std::vector<double> seconds;

    void add(const lod2d::TreeReport& report, double time, const std::string& name) {
        const bool all = std::all_of(report.levels.begin(), report.levels.end(),
                                     [](const auto& level) { return level.certified; });
        if (all)
            ++certified;
        else
            failures.push_back(name + ": a level is not certified");
        seconds.push_back(time);
        for (auto* column : {&worst, &mean, &ratio})
            column->resize(std::max(column->size(), report.levels.size()));
        for (std::size_t level = 0; level < worst.size(); ++level) {
            // A tree that ends early keeps its last level.
            const auto& entry = report.levels[std::min(level, report.levels.size() - 1)];
            worst[level].push_back(entry.worst_protrusion_fraction);
            mean[level].push_back(entry.mean_protrusion_fraction);
            ratio[level].push_back(entry.measure_ratio);
        }
    }

    void print(std::string_view builder) const {
        std::printf("%s: %d certified, %zu not; time to build: median %.3f s, longest %.3f s\n",
                    std::string(builder).c_str(), certified, failures.size(), median(seconds),
                    largest(seconds));
        for (const std::string& failure : failures) std::printf("  %s\n", failure.c_str());
        std::printf("  level   worst protrusion: median, largest   mean: median   area ratio\n");
        for (std::size_t level = 0; level < worst.size(); ++level)
            std::printf("  %5zu %21.4f %% %9.4f %% %11.4f %% %12.4f\n", level,
                        100 * median(worst[level]), 100 * largest(worst[level]),
                        100 * median(mean[level]), median(ratio[level]));
    }
};

void measure(const lod2d::Shape& shape, lod2d::Builder builder, int depth, Tally& tally) {
    lod2d::TreeSettings settings;
    settings.builder = builder;
    settings.depth = depth;
    try {
        const auto start = Clock::now();
        const auto tree = lod2d::build_tree(shape, settings);
        const double time = seconds_since(start);
        lod2d::ReportSettings report;
        report.tolerance = 1e-5;
        tally.add(lod2d::report_tree(shape, tree, report), time, shape.name);
    } catch (const lod::Error& e) {
        tally.failures.emplace_back(e.what());
    }
}

int run(const std::filesystem::path& folder, int depth, std::size_t most_files) {
    auto files = svg_files(folder);
    if (files.size() > most_files) files.resize(most_files);
    std::map<lod2d::Builder, Tally> tallies;
    std::vector<std::string> refused;
    std::size_t most_edges = 0;
    for (const auto& file : files) {
        try {
            const lod2d::Shape shape = lod2d::load_shape(file.string());
            std::size_t edges = 0;
            for (const auto& ring : shape.polygon.rings) edges += ring.size();
            most_edges = std::max(most_edges, edges);
            for (const lod2d::Builder builder : lod::choices<lod2d::Builder>())
                measure(shape, builder, depth, tallies[builder]);
        } catch (const lod::Error& e) {
            refused.emplace_back(e.what());
        }
    }
    std::printf("%zu files, %zu loaded (up to %zu edges), %zu refused\n", files.size(),
                files.size() - refused.size(), most_edges, refused.size());
    for (const std::string& line : refused) std::printf("  %s\n", line.c_str());
    bool good = true;
    for (const auto& [builder, tally] : tallies) {
        tally.print(lod::name_of(builder));
        good = good && tally.failures.empty();
    }
    return good ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    const std::string folder = count > 1 ? words[1] : "/usr/share/openclipart/svg/shapes";
    const int depth = count > 2 ? std::atoi(words[2]) : 4;
    const int most = count > 3 ? std::atoi(words[3]) : 1'000'000;
    if (!std::filesystem::is_directory(folder)) {
        std::fprintf(stderr,
                     "bench_openclipart: no folder %s; install openclipart-svg or name another\n",
                     folder.c_str());
        return 6;
    }
    return run(folder, depth, static_cast<std::size_t>(most));
}
