#include <filesystem>
#include <nlohmann/json.hpp>

#include "lodlab/io/files/read_file.hpp"
#include "tests/catch.hpp"
#include "tests/cli/program.hpp"

namespace {

std::string head(const std::string& path, std::size_t count) {
    return lod::read_text_file(path, 100'000'000).substr(0, count);
}

}  // namespace

TEST_CASE("several outs are written, each in the format of its ending") {
    const Scratch scratch;
    const Outcome outcome = lodlab({"simulate", "offset_boxes", "--level", "2", "--quality",
                                    "draft", "--out", scratch / "a.png", "--out", scratch / "a.svg",
                                    "--out", scratch / "a.pdf", "--out", scratch / "a.json"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(scratch.files() == std::vector<std::string>{"a.json", "a.pdf", "a.png", "a.svg"});
    CHECK(head(scratch / "a.png", 4) == "\x89PNG");
    CHECK(head(scratch / "a.svg", 5) == "<?xml");
    CHECK(head(scratch / "a.pdf", 5) == "%PDF-");
    CHECK(nlohmann::json::parse(head(scratch / "a.json", 100'000'000)).is_object());
}

TEST_CASE("every figure of the paper is drawn without a display") {
    const Scratch scratch;
    const std::string number = GENERATE("1", "2", "3", "4", "5", "9");
    Start start;
    start.folder = scratch.path();
    start.environment = {"PATH=/usr/bin:/bin", "HOME=/nonexistent"};  // no DISPLAY
    const Outcome outcome = lodlab(
        {"figure", number, "--out", "f.png", "--theme", "dark", "--quality", "draft"}, start);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(scratch.files() == std::vector<std::string>{"f.png"});
    CHECK(std::filesystem::file_size(scratch.path() / "f.png") > 5000);
}

TEST_CASE("a run becomes a plot and a video") {
    const Scratch scratch;
    const Outcome outcome = lodlab({"simulate", "near_miss", "--duration", "0.2", "--plot",
                                    "--quality", "draft", "--out", scratch / "p.png", "--out",
                                    scratch / "v.mp4", "--out", scratch / "v.gif"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(head(scratch / "v.mp4", 8).substr(4) == "ftyp");
    CHECK(head(scratch / "v.gif", 4) == "GIF8");
}

TEST_CASE("a tree goes to JSON and to a picture, the same bytes each time") {
    const Scratch scratch;
    for (const char* name : {"1", "2"})
        REQUIRE(lodlab({"tree", "gear:9", "--depth", "2", "--out",
                        scratch / (std::string(name) + ".png"), "--out",
                        scratch / (std::string(name) + ".json")})
                    .code == 0);
    CHECK(head(scratch / "1.png", 10'000'000) == head(scratch / "2.png", 10'000'000));
    CHECK(head(scratch / "1.json", 10'000'000) == head(scratch / "2.json", 10'000'000));
    const auto tree = nlohmann::json::parse(head(scratch / "1.json", 10'000'000));
    CHECK(tree["format"] == "lodlab tree");
}

TEST_CASE("a comparison is drawn as a still and filmed beside Box2D") {
    const Scratch scratch;
    const Outcome outcome =
        lodlab({"compare", "offset_boxes", "--duration", "0.75", "--quality", "draft", "--out",
                scratch / "c.svg", "--out", scratch / "c.json", "--out", scratch / "c.gif"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(head(scratch / "c.gif", 3) == "GIF");
    CHECK(head(scratch / "c.svg", 1'000'000).find("Box2D") != std::string::npos);
    const auto figure = nlohmann::json::parse(head(scratch / "c.json", 100'000'000));
    CHECK(figure["panels"].size() == 6);  // five levels and the exact run
}
