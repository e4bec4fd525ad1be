#include "lessons/exercises/exercise.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/arguments/command.hpp"
#include "cli/arguments/misused.hpp"
#include "cli/terminal/output.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/exercises/workshop.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/scenes/spelling.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;
using exercises::Exercise;
using exercises::Judgement;
using exercises::Workshop;
using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

constexpr const char* progress_words[] = {"not begun", "fails", "passes"};

const Exercise& named_exercise(const std::string& word) {
    if (const Exercise* found = exercises::find_exercise(word)) return *found;
    const auto& all = exercises::all();
    std::vector<std::string_view> names;
    for (const Exercise& exercise : all) names.emplace_back(exercise.words.name);
    misused("no exercise " + word + scenes::did_you_mean(word, names) + "; there are 1 to " +
            std::to_string(all.size()) + ", and lodlab exercise lists them");
}

std::string command_for(const Exercise& exercise) {
    return "lodlab exercise " + exercise.words.name;
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - text.size(), ' ');
}

/// Of a column of the list, for the longest that stands in it.
std::size_t width_of(std::string exercises::Words::*column) {
    std::size_t width = 0;
    for (const Exercise& exercise : exercises::all())
        width = std::max(width, (exercise.words.*column).size());
    return width + 2;
}

std::string heading_of(const std::string& lesson) {
    for (const lessons::Entry& entry : lessons::list())
        if (entry.slug == lesson)
            return "Lesson " + std::to_string(entry.number) + ": " + entry.title + "\n";
    return lesson + "\n";
}

void print_list(Workshop& workshop, bool json) {
    Json list = Json::array();
    std::string text;
    std::string lesson;
    const std::size_t name = width_of(&exercises::Words::name);
    const std::size_t title = width_of(&exercises::Words::title);
    for (const Exercise& exercise : exercises::all()) {
        const exercises::Words& words = exercise.words;
        const std::string progress =
            progress_words[static_cast<std::size_t>(workshop.progress(exercise))];
        list.push_back({{"number", exercise.number},
                        {"name", words.name},
                        {"title", words.title},
                        {"lesson", words.lesson},
                        {"state", progress}});
        if (words.lesson != lesson) text += heading_of(words.lesson);
        lesson = words.lesson;
        text += right(std::to_string(exercise.number), 4) + "  " + padded(words.name, name) +
                padded(words.title, title) + progress + "\n";
    }
    if (json) return print(Json{{"exercises", std::move(list)}});
    print(text + "Begin one, or check what you wrote: lodlab exercise 1\n");
}

void begin(Workshop& workshop, const Exercise& exercise) {
    workshop.begin(exercise);
    print("Wrote " + workshop.file(exercise).string() + ": complete the function " +
          exercise.words.name + " there, then check it: " + command_for(exercise) + "\n");
}

void reset(Workshop& workshop, const Exercise& exercise) {
    const fs::path kept = workshop.reset(exercise);
    print("Wrote " + workshop.file(exercise).string() + " anew" +
          (kept.empty() ? "" : "; what you had is " + kept.string()) + "\n");
}

void print_hint(Workshop& workshop, const Exercise& exercise) {
    const std::size_t hint = workshop.next_hint(exercise);
    const auto& hints = exercise.words.hints;
    print("Hint " + std::to_string(hint + 1) + " of " + std::to_string(hints.size()) + ": " +
          hints[hint] + "\n" +
          (hint + 1 < hints.size() ? ""
                                   : "That was the last one; " + command_for(exercise) +
                                         " --solution prints a solution.\n"));
}

/// What readers get: why it fails, or that it passes.
std::string report_of(const Exercise& exercise, const fs::path& file, const Judgement& found) {
    std::string text;
    for (const std::string& line : found.lines) text += line + "\n";
    if (!found.passes) return text;
    text = file.string() + " passes: " + found.verdict +
           " (edge cases, and those of the seeds 1 to " + std::to_string(exercises::random_seeds) +
           ").\n";
    const auto& all = exercises::all();
    const auto next = static_cast<std::size_t>(exercise.number);
    return next < all.size() ? text + "Next: " + command_for(all[next]) + "\n" : text;
}

std::string verdict_of(const Exercise& exercise, const fs::path& file, const Judgement& found) {
    return file.string() + ": " + found.verdict + "; mend it and check it again, or see " +
           command_for(exercise) + " --hint";
}

Json result_of(const Exercise& exercise, const Judgement& found) {
    Json mistakes = Json::array();
    for (const int mistake : found.mistakes)
        mistakes.push_back(exercise.words.mistakes[static_cast<std::size_t>(mistake)].name);
    return {{"exercise", exercise.words.name},
            {"state", found.passes ? "passes" : "fails"},
            {"cases", found.cases},
            {"wrong", found.wrong},
            {"mistakes", std::move(mistakes)},
            {"verdict", found.verdict},
            {"lines", found.lines}};
}

void check(Workshop& workshop, const Exercise& exercise, bool json) {
    const Judgement found = workshop.check(exercise);
    const fs::path file = workshop.file(exercise);
    if (json)
        print(result_of(exercise, found));
    else
        print(report_of(exercise, file, found));
    if (!found.passes)
        throw lod::Error(lod::ErrorKind::input_refused, verdict_of(exercise, file, found));
}

/// When the file was written last; nothing while there is none, as in the middle of a save.
fs::file_time_type saved(const fs::path& file) {
    std::error_code failed;
    const fs::file_time_type time = fs::last_write_time(file, failed);
    return failed ? fs::file_time_type::min() : time;
}

void watch(Workshop& workshop, const Exercise& exercise) {
    const fs::path file = workshop.file(exercise);
    if (!workshop.is_begun(exercise)) begin(workshop, exercise);
    for (;;) {
        const fs::file_time_type checked = saved(file);
        if (checked != fs::file_time_type::min()) {
            const Judgement found = workshop.check(exercise);
            print(report_of(exercise, file, found));
            if (found.passes) return;
            print(verdict_of(exercise, file, found) + "\nWaiting until " + file.string() +
                  " is saved; Ctrl-C ends.\n");
        }
        while (saved(file) == checked) {
            std::this_thread::sleep_for(100ms);
            lod::check_interrupted();
        }
    }
}

}  // namespace

void run_exercise(const Options& options) {
    Workshop workshop;
    if (options.exercise.empty()) return print_list(workshop, options.json);
    const Exercise& exercise = named_exercise(options.exercise);
    if (options.hint) return print_hint(workshop, exercise);
    if (options.solution) return print(exercises::code_with(exercise.words, {}));
    if (options.reset) return reset(workshop, exercise);
    if (options.watch) return watch(workshop, exercise);
    if (!workshop.is_begun(exercise)) return begin(workshop, exercise);
    check(workshop, exercise, options.json);
}

}  // namespace cli
