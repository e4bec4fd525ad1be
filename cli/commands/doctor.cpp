#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/arguments/command.hpp"
#include "cli/terminal/output.hpp"
#include "lessons/exercises/attempt.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/find_program.hpp"
#include "lodlab/lod2d/source/font.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/viz/film/video.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

/// One thing that lodlab uses.
struct Finding {
    std::string name;
    std::string serves;  ///< what for
    bool required = false;
    std::string found;    ///< what is there; empty: missing
    std::string package;  ///< of Debian, that mends it
};

std::string compiler_if_there() {
    try {
        return exercises::compiler().front();
    } catch (const lod::Error&) {
        return {};
    }
}

std::string folder_if_there(const std::string& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder, ignored) ? folder : std::string();
}

std::string scenes_if_there() {
    try {
        return scenes::folder().string();
    } catch (const lod::Error&) {
        return {};
    }
}

/// Whether a font can be read at all: draws a letter with it.
std::string font_if_there() {
    try {
        return "outlines of " + lod2d::text_shape("R").name;
    } catch (const lod::Error&) {
        return {};
    }
}

std::vector<Finding> examine() {
    return {
        {"pictures", "png, svg and pdf", true, viz::drawing_libraries(),
         "libcairo2 libpango-1.0-0"},
        {"video libraries", "mp4, webm and gif", true, viz::video_libraries(), "libavcodec59"},
        {"mp4 encoder", "--out FILE.mp4", true, viz::video_encoder("mp4"), "libavcodec59"},
        {"webm encoder", "--out FILE.webm", true, viz::video_encoder("webm"), "libavcodec59"},
        {"gif encoder", "--out FILE.gif", true, viz::video_encoder("gif"), "libavcodec59"},
        {"fonts", "text in pictures, shapes text:R", true, font_if_there(), "fonts-inter"},
        {"Inter", "the typeface of the pictures", false,
         folder_if_there("/usr/share/fonts/opentype/inter"), "fonts-inter"},
        {"scenes", "simulate and figure by name", true, scenes_if_there(), ""},
        {"openclipart", "thousands of shapes to try", false,
         folder_if_there("/usr/share/openclipart/svg"), "openclipart-svg"},
        {"glmark2-data", "real meshes: the bunny of the figures in space", false,
         folder_if_there("/usr/share/glmark2/models"), "glmark2-data"},
        {"C++ compiler", "exercises", false, compiler_if_there(), "g++"},
        {"chafa", "pictures of a lesson in the terminal", false,
         lod::find_program("chafa").string(), "chafa"},
    };
}

std::string mend_of(const std::vector<Finding>& findings) {
    std::string packages;
    for (const Finding& finding : findings)
        if (finding.found.empty() && !finding.package.empty() &&
            packages.find(" " + finding.package) == std::string::npos)
            packages += " " + finding.package;
    return packages.empty() ? "" : "sudo apt-get install -y" + packages;
}

Json result_of(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& finding : findings)
        list.push_back({{"name", finding.name},
                        {"for", finding.serves},
                        {"required", finding.required},
                        {"installed", !finding.found.empty()},
                        {"found", finding.found},
                        {"package", finding.package}});
    return {{"findings", std::move(list)}, {"mend", mend_of(findings)}};
}

std::string report_of(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        const char* missing = finding.required ? "MISSING" : "missing, not required";
        text += finding.name +
                std::string(17 - std::min<std::size_t>(16, finding.name.size()), ' ') +
                (finding.found.empty() ? missing : finding.found) + "  (" + finding.serves + ")\n";
    }
    const std::string mend = mend_of(findings);
    text += mend.empty() ? "Nothing is missing.\n" : "What is missing comes by:\n" + mend + "\n";
    return text;
}

}  // namespace

void run_doctor(const Options& options) {
    const std::vector<Finding> findings = examine();
    if (options.json)
        print(result_of(findings));
    else
        print(report_of(findings));
    for (const Finding& finding : findings)
        if (finding.required && finding.found.empty())
            throw lod::Error(lod::ErrorKind::not_installed,
                             finding.name + " is missing, needed for " + finding.serves + "; " +
                                 mend_of(findings));
}

}  // namespace cli
