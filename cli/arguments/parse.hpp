#pragma once

#include <string>
#include <vector>

#include "cli/arguments/command.hpp"

namespace cli {

/// A command line that was understood: run `command` with `options`; or nothing to run, because
/// `text` answers it (help, version).
struct Parsed {
    const Command* command = nullptr;
    Options options;
    std::string text;
};

/// Throws lod::Error (usage), one line with the mend, for a command line that is not understood.
[[nodiscard]] Parsed parse(int argc, const char* const* argv);

/// The flags that a command takes ("--level"), without its positional arguments.
[[nodiscard]] std::vector<std::string> flags_of(const Command& command);

}  // namespace cli
