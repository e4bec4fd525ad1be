#include "lodlab/scenes/trace.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/ball_union.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/worlds.hpp"

namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "lodlab-trace-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~TemporaryFolder() { fs::remove_all(path_); }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

scenes::Run<2> budgeted_run() {
    scenes::RunOptions options;
    options.frames = 500;
    options.settings.time_step = 1.0 / 240;
    options.settings.response = lod::Response::mean;
    options.settings.contact_model = lod::ContactModel::node_normal;
    options.settings.finest = {lod::Finest::backtrack, 5, 700, 1e-8};
    options.limits.node_tests = 20;
    return scenes::run(crossing(), options);
}

std::string refusal(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
    try {
        (void)scenes::read_trace(path);
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a trace plays again to the same bits") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "trace.json";
    const scenes::Run<2> run = budgeted_run();
    scenes::write_trace<2>(path, "crossing", crossing(), run);

    const scenes::Trace trace = scenes::read_trace(path);
    CHECK(trace.scene == "crossing");
    CHECK(trace.settings.response == lod::Response::mean);
    CHECK(trace.settings.contact_model == lod::ContactModel::node_normal);
    CHECK(trace.settings.finest.level == lod::Finest::backtrack);
    CHECK(trace.settings.finest.most_pairs == 5);
    CHECK(trace.settings.finest.cost == 700);
    CHECK(trace.settings.finest.tolerance == 1e-8);
    CHECK(trace.settings.time_step == 1.0 / 240);
    REQUIRE(trace.cuts.size() == 500);
    const scenes::Run<2> again = scenes::replay<2>(trace, crossing(), {});
    CHECK(again.state_hash == run.state_hash);
    CHECK(scenes::summarise(run).interrupted_frames > 0);
    for (std::size_t k = 0; k < run.steps.size(); ++k)
        CHECK(again.steps[k].record.impulses == run.steps[k].record.impulses);
}

TEST_CASE("a trace tells readers every body and contact") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "trace.json";
    const scenes::Run<2> run = budgeted_run();
    scenes::write_trace<2>(path, "crossing", crossing(), run);
    const auto json = nlohmann::json::parse(lod::read_text_file(path, 100'000'000));
    std::size_t contacts = 0;
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
        const auto& frame = json.at("frames").at(k);
        const lod::Body<2> first = [&] {
            lod::Body<2> body;
            scenes::put(run.steps[k].before[0], body);
            return body;
        }();
        CHECK(frame.at("bodies").at(0) ==
              nlohmann::json({first.position.x(), first.position.y(), first.orientation,
                              first.velocity.x(), first.velocity.y(), first.spin[0]}));
        for (const auto& pair : frame.at("pairs")) contacts += pair.at("contacts").size();
    }
    CHECK(contacts == scenes::summarise(run).contacts);
    CHECK(contacts > 0);
}

TEST_CASE("a trace of another scene is refused") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "trace.json";
    scenes::write_trace<2>(path, "crossing", crossing(), budgeted_run());
    auto changed = crossing();
    changed[2].position.x() += 1e-15;
    CHECK_THROWS_WITH(scenes::replay<2>(scenes::read_trace(path), changed, {}),
                      lodtest::contains("the scene is not the one of the trace (crossing"));
}

TEST_CASE("a trace is of one geometry: hulls and true shapes count") {
    auto bodies = crossing();
    const auto before = scenes::fingerprint<2>(bodies);
    auto tree = std::make_shared<lod::SphereTree<2>>(*bodies[0].tree);
    bodies[0].tree = tree;
    std::vector<std::uint64_t> all{before};
    for (int node = 0; node < tree->size(); ++node)
        tree->hulls.add(
            {{{-1, -1}, {1, -1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 0}}, {}, {}, false, false});
    tree->hulls.find_best(tree->parent);
    all.push_back(scenes::fingerprint<2>(bodies));
    ++tree->hulls.entry_level;
    all.push_back(scenes::fingerprint<2>(bodies));
    for (const double radius : {1.0, 1.0 + 1e-15}) {
        bodies[0].exact =
            std::make_shared<lod::BallUnion<2>>(std::vector<lod::Sphere<2>>{{{0, 0}, radius}});
        all.push_back(scenes::fingerprint<2>(bodies));
    }
    std::ranges::sort(all);
    CHECK(std::ranges::adjacent_find(all) == all.end());
}

TEST_CASE("a trace that was edited is found out, with the frame") {
    scenes::Trace trace;
    const scenes::Run<2> run = budgeted_run();
    trace.fingerprint = scenes::fingerprint<2>(crossing());
    trace.settings = run.settings;
    for (const auto& step : run.steps) {
        trace.cuts.push_back(step.record.cut);
        trace.state_hashes.push_back(step.state_hash);
    }
    trace.state_hashes[123] ^= 1;
    CHECK_THROWS_WITH(scenes::replay<2>(trace, crossing(), {}),
                      lodtest::contains("differs from the trace from frame 123 on"));
}

TEST_CASE("a file that is no trace is refused in one line") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "bad.json";
    for (const char* text :
         {"", "{", "[]", "{}", "{\"lodlab_trace\": 99}", "{\"lodlab_trace\": \"1\"}", "null",
          R"({"lodlab_trace": 2, "scene": "x", "fingerprint": "zz"})"}) {
        const std::string line = refusal(path, text);
        INFO(line);
        CHECK(line.find("not a trace of lodlab") != std::string::npos);
        CHECK(line.find('\n') == std::string::npos);
    }
}
