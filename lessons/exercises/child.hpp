#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace exercises {

/// A program to run to its end, in a process group of its own, without a keyboard.
struct ChildCommand {
    std::vector<std::string> words;  ///< a path, and the arguments
    std::filesystem::path output;    ///< where what it prints goes, errors too
    double most_seconds = 0;         ///< of the processor; ten times as long on the clock
    std::size_t most_memory = 0;     ///< [bytes]; 0: as it likes
};

/// How it ended.
struct ChildEnd {
    bool late = false;  ///< it took longer than was granted
    int signal = 0;     ///< that ended it; 0: none
    int code = 0;       ///< its own, where no signal did
};

/// Throws lod::Error (not installed) where it cannot be started, lod::Interrupted when lodlab is
/// asked to end.
[[nodiscard]] ChildEnd run_child(const ChildCommand& command);

}  // namespace exercises
