// Traces: saved, played again, sought in, continued; and those that are damaged.
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "lodlab/io/files/read_file.hpp"
#include "tests/catch.hpp"
#include "tests/cli/keys.hpp"
#include "tests/cli/program.hpp"
#include "tests/text.hpp"

namespace {

namespace fs = std::filesystem;

/// A ball that meets a wall, another that is too fast to be seen at it, all with true shapes.
const char* const traced_scene = R"(
duration = 0.6
time_step = 0.01
finest = "exact"
[[body]]
name = "wall"
shape = "box:0.5,4"
size = 4
static = true
depth = 2
[[body]]
name = "ball"
shape = "disc"
position = [-1.5, 0.5]
velocity = [3, 0]
depth = 2
[[body]]
name = "bullet"
shape = "disc"
size = 0.1
position = [-9, -1]
velocity = [300, 0]
depth = 2
)";

/// A disc that hits the first of two that stand side by side: the push goes on in a second round.
const char* const row_scene = R"(
duration = 0.6
time_step = 0.01
[[body]]
name = "A"
shape = "disc"
position = [-1.3, 0]
velocity = [1, 0]
depth = 2
[[body]]
name = "B"
shape = "disc"
depth = 2
[[body]]
name = "C"
shape = "disc"
position = [0.999, 0]
depth = 2
)";

Json seek(const std::string& name, const std::string& trace, const std::string& place) {
    return result({"simulate", name, "--replay", trace, "--seek", place, "--json"});
}

void check_refused(const Outcome& outcome, int code, const std::string& words) {
    INFO(outcome.err);
    CHECK(outcome.code == code);
    CHECK(is_one_line(outcome.err));
    CHECK(outcome.err.find(words) != std::string::npos);
}

}  // namespace

TEST_CASE("the moments of a trace have exactly the documented keys, and tell of every kind") {
    const Scratch scratch;
    const std::string file = scratch.write("s.toml", traced_scene);
    const std::string trace = scratch / "t.json";
    const Json run = result({"simulate", file, "--trace", trace, "--json"});
    CHECK(run["swept_contacts"] > 0);
    CHECK(run["exact_pairs"] > 0);
    std::set<std::string> keys;
    std::set<std::string> kinds;
    // The bullet flies 8.7 m to the wall by 3 m a frame, the ball 0.75 m by 0.03 m.
    for (const int frame : {0, 2, 3, 24, 25, 26, 27, 60}) {
        const Json moment = seek(file, trace, std::to_string(frame));
        if (!moment["events"].empty()) collect(moment, "", keys);
        for (const Json& event : moment["events"]) kinds.insert(event["kind"]);
    }
    const std::string row = scratch.write("row.toml", row_scene);
    result({"simulate", row, "--trace", scratch / "row.json", "--budget", "12", "--json"});
    for (int frame = 0; frame < 60; frame += 1) {
        const Json moment = seek(row, scratch / "row.json", std::to_string(frame));
        for (const Json& event : moment["events"]) {
            if (kinds.insert(event["kind"]).second) collect(moment, "", keys);
            if (event["kind"] == "skipped") CHECK(event["needed"] > 0);
        }
        if (kinds.count("round") > 0 && kinds.count("skipped") > 0) break;
    }
    CHECK(kinds == std::set<std::string>{"level", "skipped", "exact", "contact", "round", "impulse",
                                         "swept"});
    CHECK(keys == documented("simulate --seek"));
    CHECK(seek(file, trace, "60")["state_hash"] == run["state_hash"]);
    CHECK(seek(file, trace, "60")["events"].empty());
}

TEST_CASE("a moment is told in words, with the event that was asked for") {
    const Scratch scratch;
    const std::string trace = scratch / "t.json";
    const Json run = result({"simulate", "offset_boxes", "--trace", trace, "--json"});
    int frame = 0;
    while (seek("offset_boxes", trace, std::to_string(frame))["events"].size() < 2) frame += 8;
    const Json moment = seek("offset_boxes", trace, std::to_string(frame) + ".0");
    CHECK(moment["event"] == 0);
    CHECK(moment["events"][0]["kind"] == "level");
    CHECK(moment["frames_run"] <= 100);
    const Outcome words = lodlab(
        {"simulate", "offset_boxes", "--replay", trace, "--seek", std::to_string(frame) + ".0"});
    CHECK(words.code == 0);
    CHECK(words.out.find("offset_boxes: frame " + std::to_string(frame) + " of 360") == 0);
    const auto line = [&](std::size_t i) {
        return "event " + std::to_string(i) + ", " +
               moment["events"][i]["name"].get<std::string>() + ": " +
               moment["events"][i]["sentence"].get<std::string>() + "\n";
    };
    CHECK(words.out.find("  before it: nothing\n  " + line(0) + "  after it: " + line(1)) !=
          std::string::npos);
    check_refused(lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek", "361"}), 2,
                  "the frames 0 to 359, and 360 is its end");
    check_refused(lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek", "0.0"}), 2,
                  "nothing happens in frame 0");
    check_refused(lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek",
                          std::to_string(frame) + ".99"}),
                  2, "has the events 0 to");
    for (const char* place : {"-1", "1.", ".1", "1.2.3", "x", "1e3", "", "1.contact:", "1.:2",
                              "1.contact:x", "1.contact:1:1"})
        check_refused(lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek", place}), 2,
                      "--seek");
    check_refused(
        lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek", "99999999999999999999"}),
        2, "--seek");
}

TEST_CASE("an event is reached by its kind, and by which of that kind") {
    const Scratch scratch;
    const std::string trace = scratch / "t.json";
    result({"simulate", "offset_boxes", "--trace", trace, "--json"});
    const auto kinds_at = [&](int frame) {
        std::set<std::string> kinds;
        const Json moment = seek("offset_boxes", trace, std::to_string(frame));
        for (const Json& event : moment["events"]) kinds.insert(event["kind"]);
        return kinds;
    };
    int frame = 0;
    while (kinds_at(frame).count("impulse") == 0) ++frame;
    const std::string at = std::to_string(frame) + ".";
    const Json events = seek("offset_boxes", trace, std::to_string(frame))["events"];
    std::map<std::string, int> counts;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::string kind = events[i]["kind"];
        const std::string name = kind + ":" + std::to_string(++counts[kind]);
        CHECK(events[i]["name"] == name);
        CHECK(seek("offset_boxes", trace, at + name)["event"] == i);
        if (counts[kind] == 1) CHECK(seek("offset_boxes", trace, at + kind)["event"] == i);
    }
    CHECK(counts["level"] > 1);
    const auto refused = [&](const std::string& event, const std::string& words) {
        check_refused(lodlab({"simulate", "offset_boxes", "--replay", trace, "--seek", at + event}),
                      2, words);
    };
    refused("swept", "has no event swept: it has the events 0 to " +
                         std::to_string(events.size() - 1) + ", " +
                         std::to_string(counts["level"]) + " levels, ");
    refused("level:99", "has no event level:99");
    refused("contact:0", "has no event contact:0");
    refused("impuls", "kind of event");
}

TEST_CASE("a run that goes on from its trace ends as one that never stopped, in every byte") {
    const Scratch scratch;
    const auto simulate = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"simulate", "gears_in_a_box", "--json"});
        return result(more);
    };
    const std::string a = scratch / "a.json";
    const std::string b = scratch / "b.json";
    const std::string c = scratch / "c.json";
    simulate({"--duration", "0.6", "--budget", "60", "--trace", a});
    const Json on = simulate({"--continue", a, "--duration", "1", "--trace", b});
    const Json whole = simulate({"--duration", "1", "--budget", "60", "--trace", c});
    CHECK(on["first_frame"] == 144);
    CHECK(on["frames"] == 96);
    CHECK(whole["first_frame"] == 0);
    CHECK(on["state_hash"] == whole["state_hash"]);
    CHECK(lodtest::bytes_of(b) == lodtest::bytes_of(c));
    const Json again = simulate({"--replay", c, "--trace", scratch / "again.json"});
    CHECK(again["state_hash"] == whole["state_hash"]);
    CHECK(lodtest::bytes_of(scratch / "again.json") == lodtest::bytes_of(c));
    check_refused(lodlab({"simulate", "gears_in_a_box", "--continue", a, "--duration", "0.5"}), 2,
                  "the trace has 144 frames, 0.6 s, already");
    check_refused(lodlab({"simulate", "offset_boxes", "--continue", a}), 3,
                  "the scene is not the one of the trace (gears_in_a_box");
    check_refused(lodlab({"simulate", "gears_in_a_box", "--continue", a, "--trace", a}), 2,
                  "it is the input");
}

TEST_CASE("a run on the clock goes on, and its whole trace plays again") {
    const Scratch scratch;
    const std::string a = scratch / "a.json";
    const std::string b = scratch / "b.json";
    result({"simulate", "gears_in_a_box", "--duration", "0.3", "--milliseconds", "0", "--trace", a,
            "--json"});
    const Json on = result({"simulate", "gears_in_a_box", "--continue", a, "--duration", "0.6",
                            "--trace", b, "--json"});
    CHECK(on["interrupted_frames"] > 0);
    const Json again = result({"simulate", "gears_in_a_box", "--replay", b, "--json"});
    CHECK(again["frames"] == 144);
    CHECK(again["state_hash"] == on["state_hash"]);
}

TEST_CASE("what a trace is not is refused in one line") {
    const Scratch scratch;
    const std::string trace = scratch / "t.json";
    result({"simulate", "offset_boxes", "--duration", "0.5", "--trace", trace, "--json"});
    const std::string whole = lodtest::bytes_of(trace);
    const auto replay = [&](const std::string& path) {
        return lodlab({"simulate", "offset_boxes", "--replay", path});
    };
    CHECK(replay(trace).code == 0);
    check_refused(replay(scratch.write("empty.json", "")), 3, "not a trace of lodlab");
    check_refused(replay(scratch.write("short.json", whole.substr(0, whole.size() / 2))), 3,
                  "not a trace of lodlab: it is cut short");
    std::string turned = whole;
    turned[whole.find("\"frame\":50") + 40] ^= 4;
    check_refused(replay(scratch.write("bit.json", turned)), 3, "frames 0 to 99 are damaged");
    check_refused(replay(scratch.path().string()), 3, "not a regular file");
    check_refused(replay(scratch / "none.json"), 3, "No such file");
    std::string later = whole;
    later[later.find('3')] = '4';
    check_refused(replay(scratch.write("later.json", later)), 3, "it is of version 4");
}

TEST_CASE("options of traces that serve nothing are refused") {
    check_refused(lodlab({"simulate", "offset_boxes", "--seek", "1"}), 2, "add --replay FILE");
    check_refused(lodlab({"simulate", "offset_boxes", "--records"}), 2, "add --trace FILE");
    check_refused(lodlab({"simulate", "offset_boxes", "--key-frames", "5"}), 2, "add --trace FILE");
    check_refused(lodlab({"simulate", "offset_boxes", "--continue", "t", "--level", "1"}), 2,
                  "takes all but the duration from the trace; drop --level");
    check_refused(lodlab({"simulate", "offset_boxes", "--continue", "t", "--replay", "t"}), 2,
                  "drop");
    check_refused(
        lodlab({"simulate", "offset_boxes", "--replay", "t", "--seek", "1", "--out", "a.mp4"}), 2,
        "cannot write a.mp4");
    check_refused(
        lodlab({"simulate", "offset_boxes", "--replay", "t", "--seek", "1", "--trace", "u.json"}),
        2, "shows one moment; drop --trace");
}

TEST_CASE("a killed run leaves no trace under its name, and the next one removes what it left") {
    const Scratch scratch;
    Start start;
    start.signal = SIGKILL;
    start.when_exists = scratch / "t.json.lodlab-part";
    const Outcome killed = lodlab(
        {"simulate", "gears_in_a_box", "--duration", "400", "--trace", scratch / "t.json"}, start);
    CHECK(killed.code == 128 + SIGKILL);
    CHECK_FALSE(fs::exists(scratch / "t.json"));
    CHECK(lodlab({"simulate", "offset_boxes", "--trace", scratch / "u.json"}).code == 0);
    CHECK(scratch.files() == std::vector<std::string>{"u.json"});
}

TEST_CASE("a trace goes to a regular file, not to a pipe") {
    const Scratch scratch;
    REQUIRE(::mkfifo((scratch / "pipe").c_str(), 0600) == 0);
    check_refused(lodlab({"simulate", "offset_boxes", "--trace", scratch / "pipe"}), 4,
                  "it is no regular file; name a new file");
    check_refused(lodlab({"simulate", "offset_boxes", "--replay", scratch / "pipe"}), 3,
                  "not a regular file");
    const Outcome outcome = lodlab({"simulate", "offset_boxes", "--trace", "/dev/stdout"});
    INFO(outcome.err);  // the tests read it through a pipe, or from a file
    CHECK((outcome.code == 4 || outcome.code == 2));
    CHECK(is_one_line(outcome.err));
    CHECK(outcome.err.find("No such file") == std::string::npos);
}

TEST_CASE("a moment of a trace is drawn, with its event, and the quota where the run had one") {
    const Scratch scratch;
    const std::string trace = scratch / "t.json";
    const auto run = [&](std::vector<std::string> limit) {
        std::vector<std::string> all{"simulate", "gas:9", "--duration", "0.3",
                                     "--trace",  trace,   "--json"};
        all.insert(all.end(), limit.begin(), limit.end());
        return result(all);
    };
    const auto drawn = [&](const std::string& place) {
        const std::string path = scratch / "m.json";
        result({"simulate", "gas:9", "--replay", trace, "--seek", place, "--out", path, "--json"});
        return Json::parse(lodtest::bytes_of(path));
    };
    run({"--budget", "20"});
    int frame = 0;
    while (seek("gas:9", trace, std::to_string(frame))["events"].empty()) ++frame;
    const Json moment = seek("gas:9", trace, std::to_string(frame) + ".0");
    CHECK(drawn(std::to_string(frame))["panels"].size() == 4);
    CHECK(drawn(std::to_string(frame))["numbers"][0]["value"] == std::to_string(frame) + " of 18");
    // The title is the event's sentence; its node pairs are drawn as the marks that meet.
    const Json event = drawn(std::to_string(frame) + ".0");
    std::string sentence = moment["events"][0]["sentence"];
    REQUIRE(moment["events"][0]["kind"] == "level");
    sentence[0] = static_cast<char>(std::toupper(sentence[0]));
    CHECK(event["title"] == sentence);
    std::size_t meeting = 0;
    for (const Json& mark : event["panels"][0]["marks"])
        meeting += mark["role"] == "meeting_node" ? 1 : 0;
    CHECK(meeting == 2);                       // the roots
    CHECK(drawn("18")["panels"].size() == 2);  // the end, where nothing is refined
    run({});
    CHECK(drawn("3")["panels"].size() == 2);
    run({"--milliseconds", "2"});
    CHECK(drawn("3")["panels"].size() == 4);
}

TEST_CASE("a film of a quota is the same from the run and from its trace, times and all") {
    const Scratch scratch;
    const std::string trace = scratch / "t.json";
    const std::string run = scratch / "run.json";
    const std::string again = scratch / "again.json";
    result({"simulate", "gas:9", "--duration", "0.3", "--milliseconds", "0.01", "--trace", trace,
            "--out", run, "--json"});
    result({"simulate", "gas:9", "--replay", trace, "--out", again, "--trace", scratch / "u.json",
            "--json"});
    CHECK(lodtest::bytes_of(run) == lodtest::bytes_of(again));
    CHECK(lodtest::bytes_of(trace) == lodtest::bytes_of(scratch / "u.json"));
    CHECK(Json::parse(lodtest::bytes_of(run))["panels"].size() == 4);
}
