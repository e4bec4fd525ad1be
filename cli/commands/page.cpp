#include "lodlab/live/page/page.hpp"

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/commands/lessons/named_lesson.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/output.hpp"
#include "lessons/engine/lessons.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/live/take.hpp"

namespace cli {
namespace {

constexpr std::string_view of_a_lesson = "lesson:";

Formats html() {
    return {.exports = {".html"}, .still = false};
}

/// The live part of a lesson, as a page of its own.
std::string lesson_page(Options options) {
    const std::string name = options.scene.substr(of_a_lesson.size());
    options.scene.clear();  // it is no file
    check_outputs(options, html());
    const lessons::Lesson lesson = lessons::run(named_lesson(name).number);
    for (const std::string& given : options.given)
        if (given != "SCENE" && given != "--out")
            misused(given +
                    " does not go with the page of a lesson, which begins as its book has it");
    if (!lesson.live) misused("lesson " + name + " has no scene to play with");
    return live::page_text(lesson.live->scene);
}

}  // namespace

void run_page(const Options& options) {
    if (options.scene.starts_with(of_a_lesson))
        return lod::write_text_file(options.out.back(), lesson_page(options));
    check_outputs(options, html());
    if (options.playground)
        return lod::write_text_file(options.out.back(), live::playground_text());
    if (options.scene.empty())
        throw lod::Error(
            lod::ErrorKind::usage,
            "no scene given; name one, as in lodlab page figure9, or give --playground");
    const scenes::Scene scene = scene_of(options);
    if (scene.dim != 2)
        throw lod::Error(
            lod::ErrorKind::input_refused,
            options.scene +
                " is a scene in space; a page shows scenes of the plane, such as figure9");
    if (scene.limits.milliseconds)
        remark(
            "a page counts node tests and reads no clock; the scene's milliseconds are left out");
    live::check_module();
    const scenes::Setup<2> setup = stage<2>(scene, options);
    lod::write_text_file(options.out.back(), live::page_text(live::scene_of(setup)));
}

}  // namespace cli
