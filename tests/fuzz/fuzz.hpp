#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "lodlab/core/base/error.hpp"

/// What a reader promises of any bytes: a result, or an error whose message is one line.
template <class Read>
int try_reading(const std::uint8_t* bytes, std::size_t size, const Read& read) {
    try {
        read(std::string_view(reinterpret_cast<const char*>(bytes), size));
    } catch (const lod::Error& error) {
        const std::string_view line = error.what();
        if (!line.empty() && line.find('\n') == std::string_view::npos) return 0;
        std::fprintf(stderr, "not one line: \"%s\"\n", error.what());
        std::abort();
    }
    return 0;
}
