#include "tests/property.hpp"
#include "tests/scenes/trace_files.hpp"

namespace {

using Json = nlohmann::ordered_json;

/// Small, with cut frames, contacts and three key frames.
const std::string& small_trace() {
    static const std::string text = trace_text(
        [] {
            scenes::RunOptions options = budgeted(12);
            options.settings.time_step = 1.0 / 10;
            return scenes::run(crossing(), options);
        }(),
        {.key_frames = 5});
    return text;
}

std::string refusal(const std::filesystem::path& path) {
    try {
        static_cast<void>(scenes::read_trace(path));
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
        return error.what();
    }
    return "accepted";
}

bool contains(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

/// Where the replay of a trace differs from it.
scenes::Difference difference(const std::string& trace) {
    try {
        static_cast<void>(scenes::replay<2>(scenes::parse_trace(trace, "t.json"), crossing()));
    } catch (const scenes::Divergence& divergence) {
        return divergence.where();
    }
    FAIL("plays to its end");
    return {};
}

}  // namespace

TEST_CASE("a trace of another scene is refused") {
    auto changed = crossing();
    changed[2].position.x() += 1e-15;
    const scenes::Trace trace = scenes::parse_trace(small_trace(), "t.json");
    CHECK_THROWS_WITH(scenes::replay<2>(trace, changed),
                      lodtest::contains("the scene is not the one of the trace (crossing"));
    CHECK_THROWS_WITH(scenes::bodies_at_end<2>(trace, changed),
                      lodtest::contains("the scene is not the one of the trace (crossing"));
    CHECK_THROWS_WITH(scenes::replay<3>(trace, {}),
                      lodtest::contains("the scene is not the one of the trace (crossing"));
}

TEST_CASE("a file that is no trace is refused in one line") {
    const TemporaryFolder folder;
    const auto path = folder / "bad.json";
    for (const char* text :
         {"", "\n", "{", "[]", "{}", "{\"lodlab_trace\": 99}", "{\"lodlab_trace\": \"1\"}", "null",
          "{\"lodlab_trace\":3}\n", "{\"lodlab_trace\":3,", "{\"lodlab_trace\":3\n\n\n",
          R"({"lodlab_trace": 2, "scene": "x", "fingerprint": "zz"})"}) {
        std::ofstream(path) << text;
        CHECK(contains(refusal(path), "not a trace of lodlab"));
    }
    CHECK(contains(refusal(path.parent_path()), "not a regular file"));
    CHECK(contains(refusal(folder / "none.json"), "No such file"));
}

TEST_CASE("a trace of a later version is refused by its number") {
    const std::string later = edited(small_trace(), [](Json& line) {
        if (line.contains("lodlab_trace")) line["lodlab_trace"] = 4;
    });
    CHECK(contains(complaint(later), "it is of version 4, this lodlab reads 2 and 3"));
    CHECK(contains(complaint("{\"lodlab_trace\":1,\"frames\":[]}"), "it is of version 1"));
}

TEST_CASE("a trace that is cut short is refused wherever it ends") {
    const std::string& whole = small_trace();
    CHECK(complaint(whole).empty());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        CAPTURE(length);
        CHECK(contains(complaint(whole.substr(0, length)), "not a trace of lodlab"));
    }
    const std::string index = lines_of(whole).back() + "\n";
    CHECK(contains(complaint(whole.substr(0, whole.size() - index.size())),
                   "it is cut short: its last line is no index of its frames"));
}

TEST_CASE("a trace in which any one bit is turned is refused") {
    const std::string& whole = small_trace();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string turned = whole;
        turned[at] = static_cast<char>(turned[at] ^ (1 << (at % 8)));
        CAPTURE(at, whole[at], turned[at]);
        CHECK(contains(complaint(turned), "not a trace of lodlab"));
    }
}

TEST_CASE("a trace in which any bytes are others is refused") {
    const std::string& whole = small_trace();
    check_property(5, 2000, [&](const std::vector<std::pair<std::uint16_t, char>>& changes) {
        std::string other = whole;
        for (const auto& [at, byte] : changes) other[at * 7919U % other.size()] = byte;
        const std::string line = complaint(other);
        const bool right =
            other == whole ? line.empty() : line.find("not a trace of lodlab") != std::string::npos;
        RC_ASSERT(right);
    });
}

TEST_CASE("a trace whose lines are missing, twice, or in another order is refused") {
    const std::vector<std::string> lines = lines_of(small_trace());
    const auto joined = [](const std::vector<std::string>& all) {
        std::string text;
        for (const std::string& line : all) text += line + "\n";
        return text;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        CAPTURE(i);
        auto fewer = lines;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK_FALSE(complaint(joined(fewer)).empty());
        auto more = lines;
        more.insert(more.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
        if (i + 1 < lines.size()) CHECK_FALSE(complaint(joined(more)).empty());
        if (i + 1 == lines.size()) continue;
        auto swapped = lines;
        std::swap(swapped[i], swapped[i + 1]);
        CHECK_FALSE(complaint(joined(swapped)).empty());
    }
}

TEST_CASE("a damaged frame is found when it is asked for, and only then") {
    std::string trace = small_trace();
    const std::size_t place = trace.find("\"frame\":7");
    REQUIRE(place != std::string::npos);
    trace[place + 8] = '8';
    scenes::TracePlayer<2> player(scenes::parse_trace(trace, "t.json"), crossing());
    player.seek(3);
    player.seek(11);
    CHECK_THROWS_WITH(player.seek(7), lodtest::contains("t.json: not a trace of lodlab: frames 5 "
                                                        "to 9 are damaged: a line does not fit "
                                                        "its check"));
}

TEST_CASE("a divergence names the frame, the stage and the first body") {
    const auto turned = [](const char* stage, int frame) {
        return edited(small_trace(), [=](Json& line) {
            if (!line.contains("frame") || line["frame"] != frame) return;
            auto& hash =
                std::string(stage) == "motion" ? line["state_hash"] : line["stages"][stage];
            auto digits = hash.get<std::string>();
            digits[3] = digits[3] == '0' ? '1' : '0';
            hash = digits;
        });
    };
    for (const scenes::Stage stage :
         {scenes::Stage::pairs, scenes::Stage::levels, scenes::Stage::contacts,
          scenes::Stage::impulses, scenes::Stage::motion}) {
        const std::string name(lod::name_of(stage));
        CAPTURE(name);
        const scenes::Difference where = difference(turned(name.c_str(), 8));
        CHECK(where.frame == 8);
        CHECK(where.stage == stage);
        CHECK_FALSE(where.body);  // the hashes alone are others
    }
    CHECK(contains(complaint(turned("contacts", 8)),
                   "the replay differs from the trace (t.json) from frame 8 on, first in the "
                   "contacts; the trace was edited or written by another version"));
}

TEST_CASE("a divergence names the first body of those that move in another way") {
    const std::string trace = edited(small_trace(), [](Json& line) {
        if (!line.contains("frame") || line["frame"] != 8) return;
        line["state_hash"] = "0123456789abcdef";
        auto marks = line["marks"].get<std::string>();  // four digits a body
        for (const std::size_t digit : {6, 13}) marks[digit] = marks[digit] == '0' ? '1' : '0';
        line["marks"] = marks;
    });
    const scenes::Difference where = difference(trace);
    CHECK(where.frame == 8);
    CHECK(where.stage == scenes::Stage::motion);
    CHECK(where.body == 1U);
    CHECK(contains(complaint(trace),
                   "from frame 8 on, first in the motion; the first body that "
                   "moves in another way is number 2; the trace was edited"));
}

TEST_CASE("a body that a trace tells to be elsewhere is named") {
    const auto moved = [](int frame, double metres) {
        return edited(small_trace(), [=](Json& line) {
            if (line.contains("key_frame") && line["key_frame"] == frame)
                line["bodies"][2][1] = line["bodies"][2][1].get<double>() + metres;
        });
    };
    for (const int frame : {0, 5, 10, 12}) {
        const scenes::Difference where = difference(moved(frame, 1e-9));
        CHECK(where.frame == frame);
        CHECK(where.stage == scenes::Stage::state);
        CHECK(where.body == 2U);
    }
    CHECK(contains(complaint(moved(5, 1)),
                   "from frame 5 on, first in the state that the frame finds, of body number 3;"));
    // From the key frame itself the player goes on with what is told, and sees what follows.
    scenes::TracePlayer<2> player(scenes::parse_trace(moved(5, 1), "t.json"), crossing());
    try {
        player.seek(6);
        FAIL("is as the run was");
    } catch (const scenes::Divergence& divergence) {
        CHECK(divergence.where().frame == 5);
        CHECK(divergence.where().body == 2U);
    }
    CHECK_THROWS_AS(player.step(), scenes::Divergence);
}

TEST_CASE("a cut that is another makes another frame, or has no effect") {
    int cut_frames = 0;
    int divergences = 0;
    for (int frame = 0; frame < 12; ++frame) {
        bool was_cut = false;
        const std::string whole = edited(small_trace(), [&](Json& line) {
            if (!line.contains("frame") || line["frame"] != frame) return;
            was_cut = !line["cut"].is_null();
            line["cut"] = nullptr;
        });
        const std::string line = complaint(whole);
        cut_frames += was_cut ? 1 : 0;
        divergences += line.empty() ? 0 : 1;
        if (!was_cut) CHECK(line.empty());
        if (!line.empty())
            CHECK(
                contains(line, "from frame " + std::to_string(frame) + " on, first in the levels"));
    }
    CHECK(cut_frames > 0);
    CHECK(divergences == cut_frames);
}

TEST_CASE("numbers of a trace that are out of range are refused") {
    const auto with = [](const char* key, const Json& value) {
        return edited(small_trace(), [&](Json& line) {
            if (line.contains("lodlab_trace")) line[key] = value;
        });
    };
    CHECK(contains(complaint(with("dim", 4)), "dim is neither 2 nor 3"));
    CHECK(contains(complaint(with("key_frames", 0)), "key_frames is out of range"));
    CHECK(contains(complaint(with("key_frames", 1e30)), "no whole number that fits"));
    CHECK(contains(complaint(with("key_frames", 6)), "its index is out of order"));
    CHECK(contains(complaint(with("limits", {{"milliseconds", -1}})),
                   "milliseconds is out of range"));
    CHECK(contains(complaint(with("fingerprint", "0")), "the scene is not the one of the trace"));
    const auto index = [](const Json& keys) {
        std::string text;
        for (const std::string& line : lines_of(small_trace())) {
            auto json = object_in(line);
            json.erase("check");
            if (json.contains("places")) json["places"] = keys;
            text += scenes::checked_line(json, kind_of(line));
        }
        return text;
    };
    const auto head = lines_of(small_trace()).front().size() + 1;
    for (const Json& keys :
         {Json::array(), Json{{0, head}}, Json{{0, head}, {5, 1}}, Json{{0, head}, {5, 1e15}},
          Json{{0, head}, {-5, head + 1}}, Json{{0, 0}, {5, head}}, Json{{1, head}, {5, head + 9}},
          Json{{0, head}, {0, head + 9}}, Json{{0, head}, {6, head + 9}}, Json("none"),
          Json{{0, head}, {5, head + 9}}, Json{{0, head}, {5, head + 9}, {7, head + 5}}}) {
        CAPTURE(keys.dump());
        CHECK_FALSE(complaint(index(keys)).empty());
    }
}
