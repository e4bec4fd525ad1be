#pragma once

#include "cli/arguments/command.hpp"

namespace cli {

/// Throws lod::Error (usage), with the mend, where options were given together of which one means
/// nothing beside the others or without another.
void check_options(const Command& command, const Options& options);

}  // namespace cli
