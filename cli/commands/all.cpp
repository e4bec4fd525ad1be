#include "cli/arguments/command.hpp"

namespace cli {
namespace {

// clang-format off
constexpr Command table[] = {
    {"tree", "Build, check, measure, draw and export the circle or sphere tree of a shape",
     "lodlab tree gear:9 --depth 4 --out gear.png --json",
     "[SHAPE] --list --dim --size --fill --strokes --page --strict --builder --branching --depth --nodes --error --effort --exported-level "
     "--exported --no-cache --raise-limits --theme --quality --json", run_tree},
    {"collide", "One instant: intersecting nodes of each level, contacts, verdict",
     "lodlab collide offset_boxes --level 3 --out traversal.svg",
     "SCENE --at --level --projected --out --no-cache --raise-limits --theme --quality --json", run_collide},
    {"simulate", "Run a scene under a level or a budget: video, strip, plot, trace",
     "lodlab simulate figure9 --level 2 --out strip.png --out run.mp4 --json",
     "SCENE --level --budget --milliseconds --threads --duration --response --contact-model --point-model --policy --fixation --finest --sweep "
     "--strip --plot --quota --out --trace --records --key-frames --replay --seek --continue --no-cache --raise-limits --theme --quality --json", run_simulate},
    {"compare", "A scene at every level, exactly, and by Box2D: table, picture, video",
     "lodlab compare figure9 --out compare.png --out compare.mp4",
     "SCENE --duration --threads --response --contact-model --point-model --out --no-cache --raise-limits --theme --quality --json", run_compare},
    {"degrade", "How well each level answers random impacts: error, gap, delay, cost",
     "lodlab degrade --shapes box,L,star:5 --impacts 500 --out curve.png --out curve.csv --json",
     "--shapes --dim --impacts --seed --threads --builder --branching --depth --models --responses --share "
     "--merge --out --no-cache --raise-limits --theme --quality --json", run_degrade},
    {"crowd", "What a quota does to a crowd: its errors, the time of frames, the levels reached",
     "lodlab crowd implode:100 --seeds 20 --out quota.png --json",
     "SCENE --seeds --bodies --levels --budget --milliseconds --policies --fixation --threads --duration --response --contact-model --point-model --out --no-cache --raise-limits --theme --quality --json", run_crowd},
    {"figure", "A figure of the paper, from running code: 1, 2, 3, 4, 5 or 9",
     "lodlab figure 9 --out figure-9.png --out figure-9.mp4",
     "FIGURE --dim --contact-model --out --no-cache --theme --quality", run_figure},
    {"lesson", "List the lessons, or step through one, forwards and backwards",
     "lodlab lesson traversal", "[LESSON] --step --pictures --theme", run_lesson},
    {"exercise", "List the exercises of the lessons, begin one, or check what you wrote",
     "lodlab exercise meet", "[EXERCISE] --hint --solution --reset --watch --json", run_exercise},
    {"book", "Write the lessons as web pages that need no network",
     "lodlab book --out book", "--folder --no-video --quality", run_book},
    {"page", "Write a scene of the plane as a page that one plays with, in one file",
     "lodlab page figure9 --out figure9.html",
     "[SCENE] --playground --level --budget --duration --response --contact-model --point-model --policy --fixation --finest --sweep "
     "--page-file --no-cache --raise-limits", run_page},
    {"doctor", "What is installed, what is missing, and how to get it",
     "lodlab doctor", "--json", run_doctor},
    {"completion", "Print what completes lodlab's commands and options in bash",
     "lodlab completion > ~/.local/share/bash-completion/completions/lodlab", "", run_completion},
};
// clang-format on

}  // namespace

std::span<const Command> commands() {
    return table;
}

}  // namespace cli
