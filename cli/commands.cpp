#include "cli/command.hpp"

namespace cli {
namespace {

// clang-format off
constexpr Command table[] = {
    {"tree", "Build, check, measure, draw and export the circle tree of a shape",
     "lodlab tree gear:9 --depth 4 --out gear.png --json",
     "[SHAPE] --list --size --builder --branching --depth --out --raise-limits --theme --quality --json", run_tree},
    {"collide", "One instant: intersecting nodes of each level, contacts, verdict",
     "lodlab collide offset_boxes --level 3 --out traversal.svg",
     "SCENE --at --level --out --raise-limits --theme --quality --json", run_collide},
    {"simulate", "Run a scene under a level or a budget: video, strip, plot, trace",
     "lodlab simulate figure9 --level 2 --out strip.png --out run.mp4 --json",
     "SCENE --level --budget --milliseconds --duration --response --point-model --strip --plot "
     "--out --trace --replay --raise-limits --theme --quality --json", run_simulate},
    {"completion", "Print what completes lodlab's commands and options in bash",
     "lodlab completion > ~/.local/share/bash-completion/completions/lodlab", "", run_completion},
};
// clang-format on

}  // namespace

std::span<const Command> commands() {
    return table;
}

}  // namespace cli
