#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <iostream>

#include "cli/arguments/command.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/terminal/output.hpp"
#include "lessons/engine/lessons.hpp"
#include "lodlab/core/base/error.hpp"

namespace cli {
namespace {

void print_lessons() {
    std::string text;
    for (const lessons::Entry& entry : lessons::list())
        text += right(std::to_string(entry.number), 3) + "  " + entry.title + "\n";
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

}  // namespace

void run_lesson(const Options& options) {
    if (!options.number) return print_lessons();
    const lessons::Lesson lesson = lessons::run(*options.number);
    const bool on_terminal = ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1;
    lessons::StepperOptions stepper;
    if (!options.out.empty()) stepper.pictures = options.out.back();
    stepper.theme = theme_of(options);
    stepper.styled = on_terminal;
    stepper.ascii = on_terminal && !takes_utf8();
    stepper.show_inline = on_terminal;
    if (on_terminal) stepper.keyboard = STDIN_FILENO;
    lessons::step_in_terminal(lesson, std::cin, std::cout, stepper);
    print(std::string());  // checks that all of it went out
}

}  // namespace cli
