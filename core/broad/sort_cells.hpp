#pragma once

#include <cstdint>
#include <vector>

namespace lod {

/// Where a box lies in a grid of pencils.
struct GridCell {
    std::uint64_t pencil = 0;  ///< across, its number; in space the second axis in the higher half
    std::uint32_t along = 0;   ///< place along the pencil
    std::int32_t box = 0;
};

/// Puts cells in order of pencils and, within each, of places along it; equal ones keep theirs. By
/// digits: costs linear time, for any numbers. `spare` is storage that the caller keeps.
void sort_cells(std::vector<GridCell>& cells, std::vector<GridCell>& spare);

}  // namespace lod
