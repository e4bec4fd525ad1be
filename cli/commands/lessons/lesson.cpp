#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <iostream>

#include "cli/arguments/command.hpp"
#include "cli/commands/lessons/named_lesson.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/terminal/output.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/terminal/bookmarks.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace cli {
namespace {

void print_lessons() {
    std::string text;
    for (const lessons::Entry& entry : lessons::list())
        text += right(std::to_string(entry.number), 3) + "  " + entry.title + "  (" + entry.slug +
                ")\n";
    text += "Step through one: lodlab lesson 1\n";
    print(text);
}

/// Whether the terminal is told to be one of UTF-8, as the system's tools find out.
bool takes_utf8() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const char* value = std::getenv(name);
        if (!value || *value == '\0') continue;
        std::string locale(value);
        std::erase(locale, '-');
        for (char& c : locale) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return locale.find("utf8") != std::string::npos;
    }
    return false;
}

bool takes_24_bits() {
    const char* value = std::getenv("COLORTERM");
    const std::string_view colours = value ? value : "";
    return colours == "truecolor" || colours == "24bit";
}

/// By convention any value, but none, asks for no colours.
bool takes_colours() {
    const char* value = std::getenv("NO_COLOR");
    return value == nullptr || *value == '\0';
}

void fit_to_terminal(lessons::StepperOptions& stepper) {
    stepper.keyboard = STDIN_FILENO;
    stepper.styled = takes_colours();
    stepper.ascii = !takes_utf8();
    stepper.show_inline = !stepper.ascii && stepper.styled;
    if (takes_24_bits()) stepper.colours = viz::TerminalColours::direct;
}

/// Steps through the lesson, from where the student left it if asked, and remembers where she
/// leaves it now.
void resume(const lessons::Lesson& lesson, lessons::StepperOptions& stepper, bool goes_on) {
    const lessons::Bookmarks bookmarks = lessons::Bookmarks::of_user();
    const int last = static_cast<int>(lesson.steps.size());
    const int left = bookmarks.step(lesson.entry.slug);
    if (goes_on && left > 1 && left <= last) {
        stepper.first_step = left;
        std::cout << "You left at step " << left << "; g1 begins anew.\n";
    }
    int at = stepper.first_step;
    stepper.arrived = [&at](int step) { at = step; };
    const auto keep = [&] { bookmarks.keep(lesson.entry.slug, at == last ? 1 : at); };
    try {
        lessons::step_in_terminal(lesson, std::cin, std::cout, stepper);
    } catch (const lod::Interrupted&) {
        keep();
        throw;
    }
    keep();
}

}  // namespace

void run_lesson(const Options& options) {
    if (options.lesson.empty()) return print_lessons();
    const lessons::Lesson lesson = lessons::run(named_lesson(options.lesson).number);
    const bool on_terminal = ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1;
    lessons::StepperOptions stepper;
    if (!options.out.empty()) stepper.pictures = options.out.back();
    stepper.theme = theme_of(options);
    stepper.first_step = options.step.value_or(1);
    if (on_terminal) {
        fit_to_terminal(stepper);
        resume(lesson, stepper, !options.step);
    } else {
        lessons::step_in_terminal(lesson, std::cin, std::cout, stepper);
    }
    print(std::string());  // checks that all of it went out
}

}  // namespace cli
