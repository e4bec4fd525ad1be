#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lod2d/shape.hpp"

namespace lod2d {

/// One number that a generator takes, in the order of the spec.
struct GeneratorParameter {
    std::string_view name;
    std::string_view meaning;  ///< with its unit
    double standard;           ///< taken where the spec leaves it out
    double least;
    double most;
    bool whole = false;  ///< must be a whole number
};

/// A shape made from a name and a few numbers.
struct Generator {
    std::string_view name;
    std::string_view description;  ///< one line
    std::vector<GeneratorParameter> parameters;
    Polygon (*make)(std::span<const double> values);
};

/// Every generator, in the order in which a reader should meet them.
[[nodiscard]] std::span<const Generator> generators();

/// How a generator is written: "gear:TEETH,DEPTH,BORE".
[[nodiscard]] std::string usage(const Generator& generator);

/// Whether the spec begins with a generator's name.
[[nodiscard]] bool names_generator(std::string_view spec);

/// Makes "gear:9", "box:2,1", "L", ... Unless a parameter sets it, the longer side of the shape's
/// bounding box is about 1 m (gear, star, disc, ring, polygon: the diameter of their outer circle
/// is 1 m). Curves have their vertices on the curve. The same spec gives the same bits everywhere.
/// Throws lod::Error: usage where the spec is not understood (naming what is), input refused where
/// a number is out of its range (naming the range).
[[nodiscard]] Shape generate(std::string_view spec);

}  // namespace lod2d
