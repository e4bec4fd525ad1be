#include "cli/arguments/check_outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "cli/arguments/misused.hpp"
#include "cli/arguments/named_files.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/spelling.hpp"
#include "lodlab/viz/film/write.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

void check_ending(const std::string& path, const Formats& formats) {
    std::vector<std::string> endings;
    if (formats.still) endings = {"png", "svg", "pdf", "json"};
    if (formats.video) endings.insert(endings.end(), {"mp4", "webm", "gif"});
    for (const std::string& ending : formats.exports)
        if (ending != ".json") endings.push_back(ending.substr(1));
    const bool is_export =
        std::any_of(formats.exports.begin(), formats.exports.end(),
                    [&](const std::string& ending) { return path.ends_with(ending); });
    const bool is_picture =
        (formats.still && viz::is_figure_path(path)) || (formats.video && viz::is_video_path(path));
    if (is_picture || is_export) return;
    const std::vector<std::string_view> known(endings.begin(), endings.end());
    misused("cannot write " + path + ": lodlab does this as " + scenes::listed(known) +
            "; give it one of these endings");
}

/// A file that will be written: as the user names it, and where that leads.
struct Output {
    std::string named;
    fs::path real;
};

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return a == b || fs::equivalent(a, b, ignored);
}

/// Throws where the file cannot be written; leaves nothing.
Output probed(const std::string& path) {
    const lod::OutputFile probe(path);
    const fs::path& real = probe.final_path();
    std::error_code ignored;
    const fs::path folder = real.has_parent_path() ? real.parent_path() : ".";
    return {path, fs::canonical(folder, ignored) / real.filename()};
}

/// What a shape's name reads from the disk; nothing for a generator or a text.
std::optional<fs::path> file_of_shape(const std::string& name) {
    if (scenes::in_package(name)) return scenes::package_file(name);
    std::error_code ignored;
    if (fs::is_regular_file(name, ignored)) return name;
    return std::nullopt;
}

/// Every file that the options make a command read.
std::vector<fs::path> inputs_of(const Options& options) {
    std::vector<fs::path> inputs(options.merge.begin(), options.merge.end());
    std::vector<std::string> shapes = scenes::shapes_in(options.shapes);
    shapes.push_back(options.shape);
    if (!options.replay.empty()) inputs.emplace_back(options.replay);
    if (!options.continued.empty()) inputs.emplace_back(options.continued);
    if (!options.scene.empty()) {
        if (!scenes::names_crowd(options.scene) || fs::exists(options.scene))
            inputs.push_back(scenes::scene_file(options.scene));
        for (const scenes::BodySpec& body : scenes::named_scene(options.scene).bodies) {
            if (body.file.empty())
                shapes.push_back(body.shape);
            else
                inputs.push_back(body.file);
        }
    }
    for (const std::string& shape : shapes)
        if (const auto file = file_of_shape(shape)) inputs.push_back(*file);
    return inputs;
}

/// Whether the file came with lodlab; without the folder, none did.
bool came_with_lodlab(const fs::path& output) {
    std::error_code ignored;
    if (!fs::exists(output, ignored)) return false;
    if (is_same_file(output, "/proc/self/exe")) return true;
    try {
        const fs::path inside = output.lexically_relative(fs::canonical(scenes::folder(), ignored));
        return !inside.empty() && *inside.begin() != "..";
    } catch (const lod::Error&) {
        return false;
    }
}

void check_against(const Output& output, const std::vector<fs::path>& inputs) {
    const std::string what = "cannot write " + output.named + ": ";
    for (const fs::path& input : inputs) {
        if (is_same_file(output.real, input))
            misused(what + "it is the input " + input.string() + "; choose another name");
        if (names_file(input, output.real))
            misused(what + "the input " + input.string() + " names it; choose another name");
    }
    for (const char* stream : {"/proc/self/fd/1", "/proc/self/fd/2"})
        if (is_same_file(output.real, stream))
            misused(what + "the program prints there; choose another name");
    if (came_with_lodlab(output.real)) misused(what + "it came with lodlab; choose another name");
}

}  // namespace

void check_outputs(const Options& options, const Formats& formats) {
    std::vector<std::string> paths = options.out;
    for (const std::string& path : paths) check_ending(path, formats);
    if (!options.trace.empty()) paths.push_back(options.trace);
    if (paths.empty()) return;
    const std::vector<fs::path> inputs = inputs_of(options);
    std::vector<Output> outputs;
    for (const std::string& path : paths) {
        const Output output = probed(path);
        check_against(output, inputs);
        for (const Output& other : outputs)
            if (is_same_file(output.real, other.real))
                misused("cannot write " + output.named + ": " + other.named +
                        " is written to that file too; give each its own name");
        outputs.push_back(output);
    }
}

}  // namespace cli
