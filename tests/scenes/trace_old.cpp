// Traces that an earlier version of lodlab wrote.

#include "lodlab/core/frame/state_hash.hpp"
#include "tests/scenes/trace_files.hpp"

namespace {

/// 30 frames of 1/16 s of the bodies that cross, 20 node tests each, three of them cut.
const std::string& version_2() {
    static const std::string text =
        text_of(LODLAB_SOURCE_DIR "/tests/scenes/traces/version_2.json");
    return text;
}

constexpr const char* hash_of_the_run = "b35f92d36a11d861";  // as that version printed it

}  // namespace

TEST_CASE("a trace of version 2 plays again to the hash that was printed when it was written") {
    const scenes::Trace trace = scenes::parse_trace(version_2(), "old.json");
    CHECK(trace.head().version == 2);
    CHECK(trace.head().scene == "crossing");
    CHECK(trace.head().settings.priority == lod::Priority::level_order);
    CHECK(trace.frames() == 30);
    const scenes::Run<2> run = scenes::replay<2>(trace, crossing());
    CHECK(scenes::hexadecimal(run.state_hash) == hash_of_the_run);
    CHECK(scenes::summarise(run).interrupted_frames == 3);
}

TEST_CASE("a trace of version 2 is sought in, and is written anew as one of version 3") {
    const scenes::Trace old = scenes::parse_trace(version_2(), "old.json");
    const scenes::Run<2> run = scenes::replay<2>(old, crossing());
    scenes::TracePlayer<2> player(old, crossing());
    for (const std::int64_t frame : {30, 7, 0, 29, 12}) {
        player.seek(frame);
        CHECK(player.state_hash() ==
              (frame > 0 ? run.steps[static_cast<std::size_t>(frame - 1)].state_hash
                         : lod::state_hash<2>(crossing())));
    }
    const std::string anew = trace_text(run, {});
    CHECK(complaint(anew).empty());
    CHECK(scenes::parse_trace(anew, "new.json").head().version == 3);
}

TEST_CASE("a run of version 2 does not go on, for its trace does not tell how it ends") {
    const TemporaryFolder folder;
    const scenes::Trace old = scenes::parse_trace(version_2(), "old.json");
    CHECK_THROWS_WITH(scenes::bodies_at_end<2>(old, crossing()),
                      lodtest::contains("old.json: a trace of version 2 does not tell"));
    CHECK_THROWS_WITH(scenes::TraceWriter<2>(folder / "t.json", old),
                      lodtest::contains("old.json: a trace of version 2 does not tell"));
}

TEST_CASE("a bit turned in a trace of version 2 is refused, or seen, or changes nothing") {
    int refused = 0;
    int seen = 0;
    int harmless = 0;
    const std::string& whole = version_2();
    for (std::size_t at = 0; at < whole.size(); at += 23) {
        std::string turned = whole;
        turned[at] = static_cast<char>(turned[at] ^ (1 << (at % 8)));
        CAPTURE(at, whole[at], turned[at]);
        try {
            const scenes::Trace trace = scenes::parse_trace(turned, "old.json");
            const scenes::Run<2> run = scenes::replay<2>(trace, crossing());
            CHECK(scenes::hexadecimal(run.state_hash) == hash_of_the_run);
            ++harmless;
        } catch (const scenes::Divergence&) {
            ++seen;
        } catch (const lod::Error& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            ++refused;
        }
    }
    CHECK(refused > 0);
    CHECK(seen > 0);
    CHECK(harmless > 0);
}
