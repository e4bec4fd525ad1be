#include "cli/arguments/parse.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "cli/arguments/check_options.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/arguments/version.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/io/sphere_files.hpp"
#include "lodlab/scenes/scene.hpp"
#include "lodlab/scenes/spelling.hpp"
#include "lodlab/scenes/threads/thread_pool.hpp"

namespace cli {
namespace {

/// One of several words, with the nearest one named when none fits.
CLI::Validator one_of(std::vector<std::string_view> words) {
    const std::string all = scenes::listed(words);
    return CLI::Validator(
        [words, all](std::string& word) -> std::string {
            if (std::find(words.begin(), words.end(), word) != words.end()) return {};
            return word + " is none of " + all + scenes::did_you_mean(word, words);
        },
        all);
}

template <class Choice>
CLI::Validator name_of_a() {
    const auto names = names_of(Choice{});
    return one_of({names.begin(), names.end()});
}

std::string sphere_endings() {
    std::vector<std::string_view> endings;
    for (const io::SphereFormat& format : io::sphere_formats())
        endings.push_back(format.ending.substr(1));
    return scenes::listed(endings);
}

/// The number that a word is in decimal digits. C's functions, and so CLI11, take 010 for eight,
/// 0x10 for sixteen, and "nan".
std::optional<double> decimal_in(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const std::string_view digits = word.substr(word.starts_with('-') ? 1 : 0);
    const bool octal =
        digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9';
    if (octal || word.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return {};
    double number = 0;
    const auto [end, error] = lod::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return number;
}

CLI::Validator range(double low, double high) {
    return CLI::Validator(
        [low, high](std::string& word) -> std::string {
            const auto number = decimal_in(word);
            if (number && *number >= low && *number <= high) return {};
            return "must be a decimal number between " + readable(low) + " and " + readable(high) +
                   ", not " + word;
        },
        "");
}

/// FRAME[.EVENT], from 0.
CLI::Validator place_of_a_trace() {
    return CLI::Validator(
        [](std::string& word) -> std::string {
            const std::string_view text = word;
            const std::size_t point = std::min(text.find('.'), text.size());
            const std::string_view event = text.substr(std::min(point + 1, text.size()));
            const std::size_t colon = std::min(event.find(':'), event.size());
            const auto is_whole = [](std::string_view digits) {
                return !digits.empty() &&
                       digits.find_first_not_of("0123456789") == std::string_view::npos;
            };
            const auto is_name = [](std::string_view name) {
                return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz") ==
                                            std::string_view::npos;
            };
            const bool is_event =
                is_whole(event) || (is_name(event.substr(0, colon)) &&
                                    (colon == event.size() || is_whole(event.substr(colon + 1))));
            if (is_whole(text.substr(0, point)) && (point == text.size() || is_event)) return {};
            return "must be a frame, as 120, or an event of one, as 120.3, 120.impulse or "
                   "120.contact:2, not " +
                   word;
        },
        "");
}

/// Two or three numbers, parted by commas.
std::optional<std::array<double, 3>> point_in(std::string_view text) {
    std::array<double, 3> point{};
    for (double& number : point) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::optional<double> found = decimal_in(text.substr(0, comma));
        if (!found || std::abs(*found) > 1e6) return {};
        number = *found;
        if (comma == text.size())
            return &number == point.data() ? std::nullopt : std::optional(point);
        text.remove_prefix(comma + 1);
    }
    return {};
}

void read_fixation(const std::string& text, Options& options) {
    options.fixation = point_in(text);
    if (!options.fixation)
        throw CLI::ValidationError("--fixation",
                                   "must be two or three numbers, as in 0.5,-1, not " + text);
}

/// A row of the table of options.
struct Row {
    std::string_view name;
    void (*add)(CLI::App& app, Options& o);
};

constexpr double most_tests = 2'000'000'000;
constexpr double most_pages = 1000;                          // of figures, and steps of lessons
constexpr double most_seeds = 18'446'744'073'709'549'568.0;  // the last double below 2^64

// clang-format off
const Row rows[] = {
    {"SHAPE", [](CLI::App& a, Options& o) { a.add_option("SHAPE", o.shape, "a file (svg, svgz; obj, ply, stl, off, 3ds, gltf, glb), text:R (font outlines), or a generator such as gear:9")->required(); }},
    {"[SHAPE]", [](CLI::App& a, Options& o) { a.add_option("SHAPE", o.shape, "a file (svg, svgz; obj, ply, stl, off, 3ds, gltf, glb), text:R (font outlines), or a generator such as gear:9"); }},
    {"SCENE", [](CLI::App& a, Options& o) { a.add_option("SCENE", o.scene, "a scene file (toml), the name of a scene that comes with lodlab, or a crowd, as in gas:1000")->required(); }},
    {"[SCENE]", [](CLI::App& a, Options& o) { a.add_option("SCENE", o.scene, "a scene file (toml), the name of a scene that comes with lodlab, a crowd, as in gas:30, or that of a lesson, as in lesson:traversal"); }},
    {"--playground", [](CLI::App& a, Options& o) { a.add_flag("--playground", o.playground, "no scene: a page on which shapes are drawn, or dropped as SVG, and collide"); }},
    {"FIGURE", [](CLI::App& a, Options& o) { a.add_option("N", o.number, "number of the figure in the paper")->check(range(0, most_pages))->required(); }},
    {"[LESSON]", [](CLI::App& a, Options& o) { a.add_option("LESSON", o.lesson, "number or name of the lesson; without it the lessons are listed"); }},
    {"--step", [](CLI::App& a, Options& o) { a.add_option("--step", o.step, "of the lesson, to begin with; without it, on a terminal, where you left")->check(range(1, most_pages)); }},
    {"[EXERCISE]", [](CLI::App& a, Options& o) { a.add_option("EXERCISE", o.exercise, "number or name of the exercise; without it the exercises are listed"); }},
    {"--hint", [](CLI::App& a, Options& o) { a.add_flag("--hint", o.hint, "print the next hint"); }},
    {"--solution", [](CLI::App& a, Options& o) { a.add_flag("--solution", o.solution, "print a solution"); }},
    {"--reset", [](CLI::App& a, Options& o) { a.add_flag("--reset", o.reset, "begin anew; your file is kept under another name"); }},
    {"--watch", [](CLI::App& a, Options& o) { a.add_flag("--watch", o.watch, "check whenever the file is saved, until it passes"); }},
    {"--list", [](CLI::App& a, Options& o) { a.add_flag("--list", o.list, "list generators and builders"); }},
    {"--size", [](CLI::App& a, Options& o) { a.add_option("--size", o.size, "longest side of the shape's box [m]")->check(range(1e-6, 1e6)); }},
    {"--builder", [](CLI::App& a, Options& o) { a.add_option("--builder", o.builder, "builder of the tree; tree --list names them"); }},
    {"--branching", [](CLI::App& a, Options& o) { a.add_option("--branching", o.branching, "most children of a node")->check(range(2, 64)); }},
    {"--depth", [](CLI::App& a, Options& o) { a.add_option("--depth", o.depth, "levels below the root")->check(range(0, 12)); }},
    {"--dim", [](CLI::App& a, Options& o) { a.add_option("--dim", o.dim, "2: the plane, 3: space; without it as the shape says, else the plane")->check(range(2, 3)); }},
    {"--fill", [](CLI::App& a, Options& o) { a.add_flag("--fill", o.fill, "take an open mesh, filled by winding number; its inertia is approximate"); }},
    {"--strokes", [](CLI::App& a, Options& o) { a.add_flag("--strokes", o.strokes, "the strokes of a drawing belong to the shape, beside its fills too"); }},
    {"--page", [](CLI::App& a, Options& o) { a.add_flag("--page", o.page, "a drawing is stretched and cut off by its page, as a browser does"); }},
    {"--strict", [](CLI::App& a, Options& o) { a.add_flag("--strict", o.strict, "refuse a drawing of which something is left out or taken in another way than a browser shows it"); }},
    {"--nodes", [](CLI::App& a, Options& o) { a.add_option("--nodes", o.nodes, "most nodes: levels that would take the tree beyond are left out")->check(range(1, most_tests)); }},
    {"--error", [](CLI::App& a, Options& o) { a.add_option("--error", o.error, "target: a node that stands out of the shape by no more than this share of the root's diameter is not divided")->check(range(0, 1)); }},
    {"--effort", [](CLI::App& a, Options& o) { a.add_option("--effort", o.effort, "of the search for spheres: 0.1 takes a fifth of the time and fits a tenth worse")->check(range(0, 100)); }},
    {"--no-cache", [](CLI::App& a, Options& o) { a.add_flag("--no-cache", o.no_cache, "build every tree; neither read nor keep built ones in the user's cache"); }},
    {"--exported-level", [](CLI::App& a, Options& o) { a.add_option("--level", o.level, "the level that --out FILE.urdf writes; without it the last")->check(range(0, 12)); }},
    {"--level", [](CLI::App& a, Options& o) { a.add_option("--level", o.level, "the last level that is tested")->check(range(0, 1000)); }},
    {"--budget", [](CLI::App& a, Options& o) { a.add_option("--budget", o.budget, "node tests a frame")->check(range(0, most_tests)); }},
    {"--milliseconds", [](CLI::App& a, Options& o) { a.add_option("--milliseconds", o.milliseconds, "time for the collision handling of a frame [ms]")->check(range(0, 1e6)); }},
    {"--threads", [](CLI::App& a, Options& o) { a.add_option("--threads", o.threads, "that do the parts of a frame; the bits are the same for any number")->check(range(1, scenes::ThreadPool::most_threads))->capture_default_str(); }},
    {"--at", [](CLI::App& a, Options& o) { a.add_option("--at", o.at, "the instant [s]; without it the first one in which leaves meet")->check(range(0, 3600)); }},
    {"--duration", [](CLI::App& a, Options& o) { a.add_option("--duration", o.duration, "simulated time [s]")->check(range(1e-7, 3600)); }},
    {"--response", [](CLI::App& a, Options& o) { a.add_option("--response", o.response, "how impulses combine")->check(name_of_a<lod::Response>()); }},
    {"--contact-model", [](CLI::App& a, Options& o) { a.add_option("--contact-model", o.contact_model, "where a contact's normal comes from")->check(name_of_a<lod::ContactModel>()); }},
    {"--point-model", [](CLI::App& a, Options& o) { a.add_option("--point-model", o.point_model, "where two circles touch")->check(name_of_a<lod::PointModel>()); }},
    {"--shapes", [](CLI::App& a, Options& o) { a.add_option("--shapes", o.shapes, "shapes that meet, parted by commas: files or generators")->type_name("SHAPE,..."); }},
    {"--impacts", [](CLI::App& a, Options& o) { a.add_option("--impacts", o.impacts, "how many impacts; without it 200")->check(range(1, 1e7)); }},
    {"--seed", [](CLI::App& a, Options& o) { a.add_option("--seed", o.seed, "of the random impacts")->check(range(0, most_seeds))->capture_default_str(); }},
    {"--seeds", [](CLI::App& a, Options& o) { a.add_option("--seeds", o.seeds, "of a crowd: how many, from its own on; without it 5")->check(range(1, 1000)); }},
    {"--policies", [](CLI::App& a, Options& o) { a.add_option("--policies", o.policies, "policies, parted by commas; without it all, with --bodies or --levels the scene's")->type_name("POLICY,..."); }},
    {"--bodies", [](CLI::App& a, Options& o) { a.add_option("--bodies", o.bodies, "how long frames take of so many bodies, with and without a quota; SCENE is a crowd's name")->type_name("NUMBER,..."); }},
    {"--levels", [](CLI::App& a, Options& o) { a.add_flag("--levels", o.levels, "which level pairs reach frame by frame under a quota"); }},
    {"--models", [](CLI::App& a, Options& o) { a.add_option("--models", o.models, "contact models, parted by commas; without it all")->type_name("MODEL,..."); }},
    {"--responses", [](CLI::App& a, Options& o) { a.add_option("--responses", o.responses, "responses, parted by commas; without it net")->type_name("RESPONSE,..."); }},
    {"--share", [](CLI::App& a, Options& o) { a.add_option("--share", o.share, "do one share of the impacts only, as in 3/8")->type_name("I/N")->capture_default_str(); }},
    {"--merge", [](CLI::App& a, Options& o) { a.add_option("--merge", o.merge, "put shares together that --out FILE.json wrote")->type_name("FILE"); }},
    {"--finest", [](CLI::App& a, Options& o) { a.add_option("--finest", o.finest, "what follows the leaves")->check(name_of_a<lod::Finest>()); }},
    {"--policy", [](CLI::App& a, Options& o) { a.add_option("--policy", o.policy, "which pair's next level comes first (a scene's priority)")->check(name_of_a<lod::Priority>()); }},
    {"--fixation", [](CLI::App& a, Options& o) { a.add_option_function<std::string>("--fixation", [&o](const std::string& text) { read_fixation(text, o); }, "the point that the observer looks at, for --policy perceptual [m]")->type_name("X,Y[,Z]"); }},
    {"--sweep", [](CLI::App& a, Options& o) { a.add_option("--sweep", o.sweep, "look between frames for what fast bodies would pass through; without it where --finest goes beyond the leaves")->check(one_of({"on", "off"})); }},
    {"--projected", [](CLI::App& a, Options& o) { a.add_flag("--projected", o.projected, "space: pictures show the last level's intersecting spheres in the plane of the contact normal"); }},
    {"--strip", [](CLI::App& a, Options& o) { a.add_flag_callback("--strip", [&o] { o.picture = "strip"; }, "still pictures show start, collision and after (two bodies: the default)"); }},
    {"--plot", [](CLI::App& a, Options& o) { a.add_flag_callback("--plot", [&o] { o.picture = "plot"; }, "still pictures show energy and momentum over time"); }},
    {"--quota", [](CLI::App& a, Options& o) { a.add_flag_callback("--quota", [&o] { o.picture = "quota"; }, "pictures and videos show the level that bodies reached and what the quota was spent on (crowds: the default)"); }},
    {"--out", [](CLI::App& a, Options& o) { a.add_option("--out", o.out, "write a file, its format by its ending; may be given several times")->type_name("FILE")->expected(1)->take_all(); }},
    {"--exported", [](CLI::App& a, Options& o) { a.add_option("--out", o.out, "write a file, its format by its ending, of spheres too (space): " + sphere_endings() + "; may be given several times")->type_name("FILE")->expected(1)->take_all(); }},
    {"--folder", [](CLI::App& a, Options& o) { a.add_option("--out", o.out, "folder of the pages")->type_name("FOLDER")->expected(1)->required(); }},
    {"--pictures", [](CLI::App& a, Options& o) { a.add_option("--out", o.out, "folder for the picture of each step")->type_name("FOLDER")->expected(1); }},
    {"--page-file", [](CLI::App& a, Options& o) { a.add_option("--out", o.out, "write the page: a file that ends in .html")->type_name("FILE")->expected(1)->required(); }},
    {"--trace", [](CLI::App& a, Options& o) { a.add_option("--trace", o.trace, "save the run so that it can be played again")->type_name("FILE"); }},
    {"--replay", [](CLI::App& a, Options& o) { a.add_option("--replay", o.replay, "play a trace of this scene again, to the same bits")->type_name("FILE"); }},
    {"--records", [](CLI::App& a, Options& o) { a.add_flag("--records", o.records, "the trace tells each frame's bodies, pairs and contacts, too, for other programs"); }},
    {"--key-frames", [](CLI::App& a, Options& o) { a.add_option("--key-frames", o.key_frames, "frames of the trace from one that is reached at once to the next; without it 100, fewer with more than 5,000 bodies")->check(range(1, most_tests)); }},
    {"--seek", [](CLI::App& a, Options& o) { a.add_option("--seek", o.seek, "print a moment of the trace: a frame, from 0, or an event of it, by number, from 0, or by kind (level, dropped, skipped, exact, contact, round, impulse, swept), as 120.impulse or 120.contact:2")->type_name("FRAME[.EVENT]")->check(place_of_a_trace()); }},
    {"--continue", [](CLI::App& a, Options& o) { a.add_option("--continue", o.continued, "go on where a trace of this scene ends, up to the duration")->type_name("FILE"); }},
    {"--raise-limits", [](CLI::App& a, Options& o) { a.add_option("--raise-limits", o.raise_limits, "multiply every limit on the size of the input by this")->check(range(1, 1e9))->capture_default_str(); }},
    {"--no-video", [](CLI::App& a, Options& o) { a.add_flag("--no-video", o.no_video, "leave the videos out"); }},
    {"--theme", [](CLI::App& a, Options& o) { a.add_option("--theme", o.theme, "ink and paper")->check(one_of({"light", "dark"}))->capture_default_str(); }},
    {"--quality", [](CLI::App& a, Options& o) { a.add_option("--quality", o.quality, "size of pictures and videos")->check(one_of({"draft", "720p", "1080p", "4k"}))->capture_default_str(); }},
    {"--json", [](CLI::App& a, Options& o) { a.add_flag("--json", o.json, "print the result for machines"); }},
};
// clang-format on

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

void add_options(const Command& command, CLI::App& app, Options& options) {
    for (const std::string& name : words_of(command.options)) {
        const auto row = std::find_if(std::begin(rows), std::end(rows),
                                      [&](const Row& r) { return r.name == name; });
        if (row == std::end(rows)) throw std::logic_error("no option " + name);
        row->add(app, options);
    }
}

/// CLI11 names what is wrong but not what was meant.
void check_spelling(int argc, const char* const* argv) {
    if (argc < 2) misused("no command given; lodlab --help lists all");
    const std::string first = argv[1];
    if (first.starts_with("-")) return;
    std::vector<std::string_view> names;
    for (const Command& command : commands()) names.push_back(command.name);
    const auto command = std::find_if(commands().begin(), commands().end(),
                                      [&](const Command& c) { return c.name == first; });
    if (command == commands().end())
        misused("unknown command " + first + scenes::did_you_mean(first, names) +
                "; lodlab --help lists all");
    std::vector<std::string> flags = flags_of(*command);
    flags.emplace_back("--help");
    const std::vector<std::string_view> known(flags.begin(), flags.end());
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string flag = word.substr(0, word.find('='));
        if (!flag.starts_with("--") || std::count(known.begin(), known.end(), flag) > 0) continue;
        misused("unknown option " + flag + scenes::did_you_mean(flag, known) + "; lodlab " + first +
                " --help lists all");
    }
}

/// CLI11 lets a flag have a value, and takes most for "yes".
void check_flags(int argc, const char* const* argv, const CLI::App& command) {
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        const std::size_t equals = word.find('=');
        if (!word.starts_with("--") || equals == std::string::npos) continue;
        const CLI::Option* option = command.get_option_no_throw(word.substr(0, equals));
        if (option != nullptr && option->get_items_expected_max() == 0)
            misused(option->get_name() + " takes no value; write it alone");
    }
}

std::vector<std::string> given_of(const CLI::App& command) {
    std::vector<std::string> given;
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0) given.push_back(option->get_name());
    return given;
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    return text;
}

/// CLI11's words; of many words too many, as a shell's * gives them, only the first.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> extra = app.remaining(true);
    if (!dynamic_cast<const CLI::ExtrasError*>(&error) || extra.size() < 2)
        return one_line(error.what());
    return extra.front() + " and " + std::to_string(extra.size() - 1) +
           " more words are too many here";
}

}  // namespace

std::vector<std::string> flags_of(const Command& command) {
    std::vector<std::string> flags;
    for (const std::string& name : words_of(command.options)) {
        if (name == "--folder" || name == "--pictures" || name == "--page-file" ||
            name == "--exported")
            flags.emplace_back("--out");
        else if (name == "--exported-level")
            flags.emplace_back("--level");
        else if (name.starts_with("--"))
            flags.push_back(name);
    }
    return flags;
}

Parsed parse(int argc, const char* const* argv) {
    check_spelling(argc, argv);
    Parsed parsed;
    CLI::App app("lodlab: a laboratory for level-of-detail collision handling", "lodlab");
    app.require_subcommand(1);
    app.set_version_flag("--version", version_text());
    app.footer(
        "Exit codes: 0 done, 2 usage, 3 input refused, 4 output failed, 5 limit exceeded,\n"
        "6 something not installed, 128 + N stopped by signal N.\n"
        "Example: lodlab figure 9 --out figure-9.png");
    for (const Command& command : commands()) {
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        sub->footer("Example: " + std::string(command.example));
        add_options(command, *sub, parsed.options);
        sub->callback([&parsed, &command, sub] {
            parsed.command = &command;
            parsed.options.given = given_of(*sub);
        });
        if (command.name == argv[1]) check_flags(argc, argv, *sub);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answer) {  // --help, --version
        std::ostringstream text;
        app.exit(answer, text, text);
        parsed.text = text.str();
    } catch (const CLI::ParseError& error) {
        const std::string of = argv[1][0] != '-' ? std::string(argv[1]) + " " : "";
        misused(complaint(app, error) + "; lodlab " + of + "--help shows how");
    }
    if (parsed.command) check_options(*parsed.command, parsed.options);
    return parsed;
}

}  // namespace cli
