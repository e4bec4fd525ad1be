#pragma once

#include <string>

#include "lodlab/core/base/error.hpp"

namespace cli {

/// Throws lod::Error, usage: the line says what was asked for, and what to type instead.
[[noreturn]] inline void misused(const std::string& line) {
    throw lod::Error(lod::ErrorKind::usage, line);
}

}  // namespace cli
