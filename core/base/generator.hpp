#pragma once

/// \file
/// Things made from a name and a few numbers, "gear:9": what the generators of shapes and of solids
/// share.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/base/error.hpp"

namespace lod {

/// One number that a generator takes, in the order of the spec.
struct GeneratorParameter {
    std::string_view name;
    std::string_view meaning;  ///< with its unit
    double standard;           ///< taken where the spec leaves it out
    double least;
    double most;
    bool whole = false;  ///< must be a whole number
};

/// How a generator is written: "gear:TEETH,DEPTH,BORE".
[[nodiscard]] std::string generator_usage(std::string_view name,
                                          std::span<const GeneratorParameter> parameters);

/// Something made from a name and a few numbers, written "gear:9" or "box:2,1".
template <typename Product>
struct Generator {
    std::string_view name;
    std::string_view description;  ///< one line
    std::vector<GeneratorParameter> parameters;
    Product (*make)(std::span<const double> values);

    /// How it is written: "gear:TEETH,DEPTH,BORE".
    [[nodiscard]] std::string usage() const { return generator_usage(name, parameters); }
};

/// The numbers of a spec, standard values where it leaves them out. Throws Error: usage where the
/// spec is not understood (naming what is), input refused where a number is out of its range.
[[nodiscard]] std::vector<double> read_generator_values(
    std::string_view spec, std::span<const GeneratorParameter> parameters);

/// The generator that the spec begins with, or null.
template <typename Product>
[[nodiscard]] const Generator<Product>* find_generator(
    std::span<const Generator<Product>> generators, std::string_view spec) {
    for (const Generator<Product>& generator : generators)
        if (generator.name == spec.substr(0, spec.find(':'))) return &generator;
    return nullptr;
}

/// Makes what the spec names. Throws as read_generator_values and refuse_choice do.
template <typename Product>
[[nodiscard]] Product make_from_spec(std::span<const Generator<Product>> generators,
                                     std::string_view spec) {
    if (const Generator<Product>* generator = find_generator(generators, spec))
        return generator->make(read_generator_values(spec, generator->parameters));
    std::vector<std::string_view> names;
    for (const Generator<Product>& generator : generators) names.push_back(generator.name);
    refuse_choice("generator", spec.substr(0, spec.find(':')), names);
}

}  // namespace lod
