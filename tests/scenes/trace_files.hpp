#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lodlab/io/files/read_file.hpp"
#include "lodlab/scenes/trace/trace_player.hpp"
#include "lodlab/scenes/trace/trace_text.hpp"
#include "lodlab/scenes/trace/trace_writer.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/worlds.hpp"

/// A folder of its own for a test, removed with all that is in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "lodlab-trace-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

/// Of bodies that cross, most of the frames in which they touch being cut.
inline scenes::RunOptions budgeted(std::int64_t frames) {
    scenes::RunOptions options;
    options.frames = frames;
    options.settings.time_step = 1.0 / 240;
    options.settings.response = lod::Response::mean;
    options.settings.contact_model = lod::ContactModel::node_normal;
    options.settings.finest = {lod::Finest::backtrack, 5, 700, 1e-8};
    options.limits.node_tests = 20;
    return options;
}

inline scenes::Run<2> budgeted_run(std::int64_t frames = 500) {
    return scenes::run(crossing(), budgeted(frames));
}

inline std::string text_of(const std::filesystem::path& path) {
    return lod::read_text_file(path, std::size_t{1} << 30);
}

/// The text of the trace of a run of the bodies that cross.
inline std::string trace_text(const scenes::Run<2>& run, const scenes::TraceSettings& settings) {
    const TemporaryFolder folder;
    scenes::write_trace<2>(folder / "t.json", "crossing", crossing(), run, settings);
    return text_of(folder / "t.json");
}

/// The lines of a text, without their newlines.
inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

/// What a line of a trace is.
inline scenes::TraceLine kind_of(const std::string& line) {
    if (line.starts_with("{\"lodlab_trace\"")) return scenes::TraceLine::head;
    if (line.starts_with("null]")) return scenes::TraceLine::end;
    return line.starts_with("\"index\"") ? scenes::TraceLine::index : scenes::TraceLine::entry;
}

/// Its object.
inline nlohmann::ordered_json object_in(const std::string& line) {
    return scenes::object_of(line, kind_of(line));
}

/// The trace as one would write it who edits each line, with checks and an index that fit.
template <class Edit>
std::string edited(const std::string& trace, const Edit& edit) {
    std::string text;
    auto index = nlohmann::ordered_json::array();
    for (const std::string& line : lines_of(trace)) {
        auto json = object_in(line);
        json.erase("check");
        edit(json);
        if (json.contains("key_frame")) index.push_back({json["key_frame"], text.size()});
        if (json.contains("places")) json["places"] = index;
        text += scenes::checked_line(json, kind_of(line));
    }
    return text;
}

/// What an error of reading or playing a trace says; empty where there is none.
inline std::string complaint(const std::string& trace) {
    try {
        static_cast<void>(scenes::replay<2>(scenes::parse_trace(trace, "t.json"), crossing()));
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return {};
}
