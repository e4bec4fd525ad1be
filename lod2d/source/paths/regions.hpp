#pragma once

#include <span>

#include "lodlab/lod2d/source/paths/clean.hpp"

namespace lod2d {

/// The union of what an outline encloses, by its rule, as rings for the nonzero rule. Coordinates
/// are rounded to 2^-29 of its box.
[[nodiscard]] Outline united(const Outline& outline);

/// What an outline and all of the clips enclose, each by its own rule, as rings for the nonzero
/// rule; no rings where that is nothing. Coordinates are rounded to 2^-29 of the outline's box.
[[nodiscard]] Outline intersected(const Outline& outline, std::span<const Outline> clips);

}  // namespace lod2d
