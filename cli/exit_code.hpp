#pragma once

#include "lodlab/core/base/error.hpp"

namespace cli {

/// What the program's end says to whoever started it; cli/README.md lists them for users.
constexpr int done_code = 0;
constexpr int internal_error_code = 1;

[[nodiscard]] constexpr int exit_code(lod::ErrorKind kind) {
    switch (kind) {
        case lod::ErrorKind::usage:
            return 2;
        case lod::ErrorKind::input_refused:
            return 3;
        case lod::ErrorKind::output_failed:
            return 4;
        case lod::ErrorKind::limit_exceeded:
            return 5;
        case lod::ErrorKind::not_installed:
            return 6;
    }
    return internal_error_code;
}

/// Of a program that a signal stopped, as shells have it.
[[nodiscard]] constexpr int signal_code(int signal) {
    return 128 + signal;
}

}  // namespace cli
