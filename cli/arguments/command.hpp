#pragma once

#include <span>
#include <string_view>

#include "cli/arguments/options.hpp"

namespace cli {

/// One command of the program: its file in this folder has its name.
struct Command {
    std::string_view name;
    std::string_view summary;  ///< one line
    std::string_view example;  ///< a whole command line
    std::string_view options;  ///< rows of the table of options, separated by spaces
    void (*run)(const Options& options);
};

/// Every command, in the order of the help.
[[nodiscard]] std::span<const Command> commands();

void run_tree(const Options& options);
void run_collide(const Options& options);
void run_simulate(const Options& options);
void run_compare(const Options& options);
void run_degrade(const Options& options);
void run_crowd(const Options& options);
void run_figure(const Options& options);
void run_lesson(const Options& options);
void run_exercise(const Options& options);
void run_book(const Options& options);
void run_page(const Options& options);
void run_doctor(const Options& options);
void run_completion(const Options& options);

}  // namespace cli
