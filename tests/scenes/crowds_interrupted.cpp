// A sample of what bench/interruptions.cpp checks at ten million points.
#include "lodlab/core/tree/family_tests.hpp"
#include "tests/catch.hpp"
#include "tests/interrupted_crowds.hpp"

namespace {

/// Restores the way of computing.
struct PathGuard {
    const lod::detail::TestPath& before = lod::detail::test_path();
    PathGuard() = default;
    PathGuard(const PathGuard&) = delete;
    PathGuard& operator=(const PathGuard&) = delete;
    ~PathGuard() { lod::detail::take_path(before); }
};

template <int Dim>
lodtest::Checked sample(const scenes::Scene& scene, double squeeze) {
    const PathGuard guard;
    lodtest::Crowd<Dim> crowd(scene);
    lodtest::Checked checked;
    std::size_t touching = 0;
    for (const bool at_rest : {false, true}) {
        crowd.run(5);
        const auto instant = crowd.instant(squeeze, at_rest);
        touching += instant.touching.size();
        lodtest::InterruptedCrowd<Dim> interrupted(instant, 60);
        for (const lod::detail::TestPath& path : lod::detail::test_paths()) {
            lod::detail::take_path(path);
            for (const lod::Priority priority : lod::choices<lod::Priority>())
                for (const lod::Organisation organisation : lod::choices<lod::Organisation>())
                    interrupted.interrupt(priority, organisation);
        }
        checked.add(interrupted.checked());
    }
    CHECK(touching >= 4);
    return checked;
}

}  // namespace

TEST_CASE("no true collision of a crowd is missed wherever a frame is interrupted",
          "[interruption]") {
    for (const char* spec : {"gas:6", "implode:6", "rain:8"}) {
        scenes::Scene scene = scenes::crowd(spec);
        for (scenes::BodySpec& body : scene.bodies) {
            if (body.shape == scenes::half_space_name) continue;
            body.builder = "quadtree";
            body.depth = 3;
        }
        const lodtest::Checked checked = sample<2>(scene, 0.65);
        INFO(spec << ": " << checked.first_miss);
        CHECK(checked.misses == 0);
        CHECK(checked.points > 3000);
        CHECK(checked.by_clock > 100);
    }
}

TEST_CASE("no true collision of a crowd in space is missed wherever a frame is interrupted",
          "[interruption][space]") {
    scenes::Scene scene = lodtest::crowd_of_solids("bunnies:4", 2);
    for (scenes::BodySpec& body : scene.bodies)
        if (body.shape != scenes::half_space_name) body.builder = "octree";
    const lodtest::Checked checked = sample<3>(scene, 0.65);
    INFO(checked.first_miss);
    CHECK(checked.misses == 0);
    CHECK(checked.points > 3000);
    CHECK(checked.by_clock > 100);
}

TEST_CASE("a true collision that a frame misses is found", "[interruption]") {
    scenes::Scene scene = scenes::crowd("gas:9");
    for (scenes::BodySpec& body : scene.bodies) body.depth = 1;
    const lodtest::Instant<2> instant = lodtest::Crowd<2>(scene).instant(0.7, true);
    REQUIRE(instant.touching.size() > 2);
    const lod::CandidatePair last = instant.touching.back();
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::node_tests(20);
    const lod::FrameRecord<2> sound = lod::detect<2>(instant.bodies, {}, budget, storage);
    REQUIRE_FALSE(lodtest::missed<2>(sound, instant));
    const auto misses = [&](const auto& spoil) {
        lod::FrameRecord<2> record = sound;
        for (std::size_t i = 0; i < record.pairs.size(); ++i)
            if (record.pairs[i].bodies == last) {
                spoil(record, i);
                break;
            }
        return lodtest::missed<2>(record, instant) == last;
    };
    CHECK(misses([](auto& record, std::size_t i) {
        record.pairs.erase(record.pairs.begin() + static_cast<std::ptrdiff_t>(i));
    }));
    CHECK(
        misses([](auto& record, std::size_t i) { record.pairs[i].verdict = lod::Verdict::apart; }));
    CHECK(misses([](auto& record, std::size_t i) { record.pairs[i].nodes.count = 0; }));
    CHECK(misses([](auto& record, std::size_t i) { record.pairs[i].contact_count = 0; }));
}
