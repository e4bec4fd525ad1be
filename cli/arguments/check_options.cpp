#include "cli/arguments/check_options.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "cli/arguments/misused.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/sphere_files.hpp"
#include "lodlab/viz/film/write.hpp"

namespace cli {
namespace {

/// An option beside which most others mean nothing.
struct Alone {
    std::string_view command;
    std::string_view option;
    std::string_view beside;  ///< what may be given too
    std::string_view why;
};
constexpr Alone alone[] = {
    {"tree", "--list", "", "only prints what there is"},
    {"degrade", "--merge", "--out --json --theme --quality", "takes the rest from the shares"},
    {"page", "--playground", "--out", "takes no scene and begins with nothing set"},
    {"simulate", "--replay",
     "SCENE --threads --strip --plot --quota --out --trace --records --key-frames --seek "
     "--no-cache "
     "--raise-limits --theme --quality --json",
     "takes its limit, duration and models from the trace"},
    {"simulate", "--continue",
     "SCENE --threads --duration --trace --no-cache --raise-limits --json",
     "takes all but the duration from the trace"},
    {"simulate", "--seek",
     "SCENE --replay --out --theme --quality --no-cache --raise-limits --json", "shows one moment"},
    {"crowd", "--bodies",
     "SCENE --budget --milliseconds --policies --fixation --duration --response --contact-model "
     "--point-model --out --no-cache --raise-limits --theme --quality --json",
     "measures the processor time of one thread, of one seed"},
    {"crowd", "--levels",
     "SCENE --budget --milliseconds --policies --fixation --duration --response --contact-model "
     "--point-model --out --no-cache --raise-limits --theme --quality --json",
     "follows one run of one thread"},
    {"exercise", "--hint", "EXERCISE", "only prints the next hint"},
    {"exercise", "--solution", "EXERCISE", "only prints a solution"},
    {"exercise", "--reset", "EXERCISE", "only writes the file anew"},
    {"exercise", "--watch", "EXERCISE", "checks for readers, again and again"},
};

/// An option that says how something else is done.
struct Needed {
    std::string_view command;
    std::string_view option;
    std::string_view what;
    bool (*given)(const Options& options);
    std::string_view mend;
};

bool has_output(const Options& options) {
    return !options.out.empty();
}
bool has_picture(const Options& options) {
    return std::ranges::any_of(options.out,
                               [](const auto& path) { return !viz::is_video_path(path); });
}
bool has_one_level(const Options& options) {
    return std::ranges::any_of(options.out, [](const std::string& path) {
        const io::SphereFormat* format = io::sphere_format_of(path);
        return format != nullptr && format->one_level;
    });
}
bool has_trace(const Options& options) {
    return !options.trace.empty();
}
bool has_replay(const Options& options) {
    return !options.replay.empty();
}
bool has_quota(const Options& options) {
    return options.budget || options.milliseconds;
}
bool is_timed(const Options& options) {
    return !options.bodies.empty() || options.levels;
}
bool has_lesson(const Options& options) {
    return !options.lesson.empty();
}
bool has_exercise(const Options& options) {
    return !options.exercise.empty();
}
constexpr std::string_view name_a_lesson = "name one, as in lodlab lesson 3";
constexpr std::string_view name_an_exercise = "name one, as in lodlab exercise 1";
constexpr Needed needed[] = {
    {"collide", "--projected", "what a picture shows", has_picture, "add --out FILE.png"},
    {"simulate", "--strip", "what a still picture shows", has_picture, "add --out FILE.png"},
    {"simulate", "--plot", "what a still picture shows", has_picture, "add --out FILE.png"},
    {"simulate", "--quota", "what pictures and videos show", has_output, "add --out FILE.mp4"},
    {"crowd", "--budget", "the quota of --bodies and --levels", is_timed,
     "add --levels, or drop it: errors are measured at shares of what frames need"},
    {"crowd", "--milliseconds", "the quota of --bodies and --levels", is_timed,
     "add --levels, or drop it: errors are measured at shares of what frames need"},
    {"crowd", "--bodies", "how long frames take with a quota and without", has_quota,
     "add --milliseconds 1"},
    {"crowd", "--levels", "which level pairs reach under a quota", has_quota,
     "add --milliseconds 1, or --budget TESTS"},
    {"simulate", "--records", "what a trace holds", has_trace, "add --trace FILE"},
    {"simulate", "--key-frames", "what a trace holds", has_trace, "add --trace FILE"},
    {"simulate", "--seek", "which moment of a trace is shown", has_replay, "add --replay FILE"},
    {"tree", "--level", "which level a .urdf file holds", has_one_level,
     "add --out FILE.urdf; --depth limits the levels of the tree"},
    {"lesson", "--out", "where the pictures of a lesson go", has_lesson, name_a_lesson},
    {"lesson", "--step", "where a lesson begins", has_lesson, name_a_lesson},
    {"exercise", "--hint", "what you want of an exercise", has_exercise, name_an_exercise},
    {"exercise", "--solution", "what you want of an exercise", has_exercise, name_an_exercise},
    {"exercise", "--reset", "what you want of an exercise", has_exercise, name_an_exercise},
    {"exercise", "--watch", "what you want of an exercise", has_exercise, name_an_exercise},
};

bool has_word(std::string_view words, std::string_view word) {
    const std::string between = ' ' + std::string(words) + ' ';
    return between.find(' ' + std::string(word) + ' ') != std::string::npos;
}

}  // namespace

void check_options(const Command& command, const Options& options) {
    const auto given = [&](std::string_view option) {
        return std::ranges::find(options.given, option) != options.given.end();
    };
    constexpr std::array<std::string_view, 3> pictures{"--strip", "--plot", "--quota"};
    for (const std::string_view one : pictures)
        for (const std::string_view other : pictures)
            if (one < other && given(one) && given(other))
                misused(std::string(other) + " and " + std::string(one) +
                        " are two pictures; give one of them, and run again for the other");
    for (const Alone& one : alone) {
        if (one.command != command.name || !given(one.option)) continue;
        for (const std::string& other : options.given)
            if (other != one.option && !has_word(one.beside, other))
                misused(std::string(one.option) + " " + std::string(one.why) + "; drop " + other);
    }
    for (const Needed& one : needed)
        if (one.command == command.name && given(one.option) && !one.given(options))
            misused(std::string(one.option) + " says " + std::string(one.what) + "; " +
                    std::string(one.mend));
}

}  // namespace cli
