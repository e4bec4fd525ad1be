#include "lodlab/live/page/page.hpp"

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/live/take.hpp"

namespace cli {

void run_page(const Options& options) {
    check_outputs(options, {.exports = {".html"}, .still = false});
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
