#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lessons/exercises/exercise.hpp"

namespace exercises {

/// What a student's file did when it was compiled and asked.
struct Attempt {
    enum class End {
        answered,  ///< every case
        did_not_compile,
        threw,    ///< an exception left the function
        crashed,  ///< a signal ended it
        endless,  ///< no answer within the time
        left,     ///< it ended the program itself
    };
    End end = End::answered;
    std::vector<Numbers> answers;    ///< to the first cases
    std::vector<std::string> lines;  ///< the compiler's errors, or what the program printed
    int signal = 0;
};

/// The words of the compiler: $CXX, else c++, found in $PATH. Throws lod::Error (not installed).
[[nodiscard]] std::vector<std::string> compiler();

/// Where <lodlab/...> is found: beside the installed program, else in the tree that it was built
/// in. Throws lod::Error (not installed).
[[nodiscard]] std::filesystem::path headers();

/// Compiles the code, a few seconds, and asks it every case, under limits of time and memory.
/// `folder`: where its own headers may lie.
[[nodiscard]] Attempt attempt(const Exercise& exercise, const std::string& code,
                              std::span<const Case> cases, const std::filesystem::path& folder);

}  // namespace exercises
