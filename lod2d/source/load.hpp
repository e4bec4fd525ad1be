#pragma once

/// \file
/// The shape that a user names: a drawing's file, a text or a generator.

#include <cstdint>
#include <string>
#include <string_view>

#include "lodlab/lod2d/source/paths/filled_paths.hpp"

namespace lod2d {

/// How a shape is read, whatever it is.
struct LoadSettings {
    OutlineSettings outline;  ///< of files and texts; generators are in metres by their parameters
    std::string font = "Inter";                 ///< of texts: a fontconfig name
    std::size_t most_bytes = 64'000'000;        ///< of a file
    std::size_t most_elements = 200'000;        ///< of an SVG file
    std::uint64_t most_memory = 2048ull << 20;  ///< of what draws an SVG file [bytes]
    double most_seconds = 60;  ///< of the processor's time, of what draws an SVG file
    bool strokes = false;      ///< of an SVG file: take strokes in, beside fills too
    bool page = false;         ///< of an SVG file: stretched and cut off by its page
    bool strict = false;       ///< refuse an SVG file of which something is left out
};

/// The shape that a reader names: a file ending in .svg or .svgz (see svg.hpp), "text:R" (see
/// font.hpp), or a generator with its numbers, "gear:9" (see lod2d/shape/generators.hpp). Throws
/// lod::Error, as those do; usage, naming what is understood, for anything else.
[[nodiscard]] Shape load_shape(std::string_view spec, const LoadSettings& settings = {});

/// Whether load_shape() would take the spec for a shape of the plane (it may still refuse it).
[[nodiscard]] bool names_shape(std::string_view spec);

/// Whether files with this ending, in small letters, are drawings: svg, svgz.
[[nodiscard]] bool is_drawing_format(std::string_view ending);

}  // namespace lod2d
