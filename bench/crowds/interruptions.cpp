// Is a true collision missed anywhere that a frame can be interrupted?
// Usage: bench_interruptions [POINTS [SEED [WAY]]]   1,000,000; 1; all: the ways of computing, in
// turn Small crowds in the plane and in space, every policy, both organisations, cut at numbers of
// tests, within levels at every test, and on a clock at every look; at each point every pair of
// bodies whose true shapes share a point must be a candidate, must not be called apart, and must
// have nodes that overlap, and contacts where the bodies are at rest
// (tests/interrupted_crowds.hpp).

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/timing.hpp"
#include "lodlab/core/tree/family_tests.hpp"
#include "tests/interrupted_crowds.hpp"

namespace {

/// A way in which frames are computed; all give the same bits. Executors belong here, too.
struct Way {
    const lod::detail::TestPath* path = nullptr;

    [[nodiscard]] std::string name() const { return std::string(path->name); }
    void take() const { lod::detail::take_path(*path); }
};

std::vector<Way> ways(const std::string& only) {
    std::vector<Way> result;
    for (const lod::detail::TestPath& path : lod::detail::test_paths())
        if (only.empty() || path.name == only) result.push_back({&path});
    return result;
}

/// Points of each kind for each policy, organisation and way at one instant.
constexpr std::uint64_t most_points = 300;

template <int Dim>
lodtest::Checked check(const lodtest::Instant<Dim>& instant, const std::vector<Way>& all) {
    lodtest::InterruptedCrowd<Dim> crowd(instant, most_points);
    for (const Way& way : all) {
        way.take();
        for (const lod::Priority priority : lod::choices<lod::Priority>())
            for (const lod::Organisation organisation : lod::choices<lod::Organisation>())
                crowd.interrupt(priority, organisation);
    }
    return crowd.checked();
}

struct Report {
    lodtest::Checked sum;
    std::uint64_t instants = 0;
    std::uint64_t touching = 0;
};

/// A crowd, how many points of it, and how near to each other its bodies are put.
struct Part {
    scenes::Scene scene;
    std::uint64_t points = 0;
    std::array<double, 3> squeezes{0.85, 0.7, 0.6};
};

/// Instants of one crowd until there are so many points.
template <int Dim>
void run(const Part& part, const std::vector<Way>& all, Report& report) {
    lodtest::Crowd<Dim> crowd(part.scene, io::TreeCache::of_user());
    lodtest::Checked here;
    const double begin = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    for (std::size_t i = 0; here.points < part.points; ++i) {
        crowd.run(3);
        const auto instant = crowd.instant(part.squeezes[i % 3], i % 2 == 1);
        if (instant.touching.empty() && i < 1000) continue;
        here.add(check<Dim>(instant, all));
        ++report.instants;
        report.touching += instant.touching.size();
    }
    std::printf("%-12s %9llu points, %10llu verdicts of touching pairs, %llu missed, %.0f s\n",
                part.scene.name.c_str(), static_cast<unsigned long long>(here.points),
                static_cast<unsigned long long>(here.verdicts),
                static_cast<unsigned long long>(here.misses),
                static_cast<double>(std::clock()) / CLOCKS_PER_SEC - begin);
    if (here.misses > 0) std::printf("  %s\n", here.first_miss.c_str());
    std::fflush(stdout);
    report.sum.add(here);
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t points = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
    const std::string seed = argc > 2 ? argv[2] : "1";
    const std::vector<Way> all = ways(argc > 3 ? argv[3] : "");
    const std::clock_t begin = std::clock();
    Report report;
    for (const char* name : {"gas:6,", "implode:6,", "rain:8,"})
        run<2>({scenes::crowd(name + seed), points / 4}, all, report);
    Part bunnies{scenes::crowd("bunnies:4," + seed), points / 8, {0.9, 0.8, 0.7}};
    for (scenes::BodySpec& body : bunnies.scene.bodies) body.depth = 2;
    run<3>(bunnies, all, report);
    Part solids = bunnies;
    solids.scene = lodtest::crowd_of_solids("bunnies:4," + seed, 2);
    solids.scene.name = "solids";
    run<3>(solids, all, report);
    std::string names;
    for (const Way& way : all) names += " " + way.name();
    const lodtest::Checked& sum = report.sum;
    std::printf(
        "%llu points (%llu by count, %llu within levels, %llu by the clock), %llu verdicts of "
        "%llu touching pairs at %llu instants; %llu missed; by%s; %.0f s of processor time\n",
        static_cast<unsigned long long>(sum.points), static_cast<unsigned long long>(sum.by_count),
        static_cast<unsigned long long>(sum.within_levels),
        static_cast<unsigned long long>(sum.by_clock),
        static_cast<unsigned long long>(sum.verdicts),
        static_cast<unsigned long long>(report.touching),
        static_cast<unsigned long long>(report.instants),
        static_cast<unsigned long long>(sum.misses), names.c_str(),
        static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    return sum.misses > 0 ? 1 : 0;
}
