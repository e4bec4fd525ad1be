#pragma once

/// \file
/// How an SVG drawing is read.

#include <cstddef>
#include <cstdint>

#include "lodlab/lod2d/source/paths/filled_paths.hpp"

namespace lod2d {

/// How a drawing is read.
struct SvgSettings {
    OutlineSettings outline;
    std::size_t most_bytes = 64'000'000;
    std::size_t most_elements = 200'000;        ///< drawn, each time that `use` draws them
    int most_depth = 200;                       ///< of elements within elements
    std::uint64_t most_memory = 2048ull << 20;  ///< of librsvg [bytes]
    double most_seconds = 60;  ///< of librsvg, on a processor; 0 accepts plain drawings only
    bool in_child = true;      ///< librsvg draws in a child process; else under no limit of its own
    bool strokes = false;      ///< strokes belong to the shape, beside fills too
    bool strict = false;       ///< refuse what a browser shows in another way
    bool page = false;         ///< stretched and cut off as by the page of a browser
};

}  // namespace lod2d
