#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/lod3d/source/mesh_draft.hpp"

namespace lod3d {

/// The types of PLY's numbers, and the whole ones of 64 bits that some programs add. Each fits into
/// a double without loss, those up to 2^53.
enum class PlyType {
    none,
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};
[[nodiscard]] std::size_t size_of(PlyType type);  ///< [bytes]

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::none;        ///< of the value, or of a list's values
    PlyType count_type = PlyType::none;  ///< of a list's length; none: a single value
    [[nodiscard]] bool is_list() const { return count_type != PlyType::none; }
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, little_endian, big_endian };

/// What a PLY file's header announces.
struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t end = 0;      ///< the first byte after it
    std::uint64_t lines = 0;  ///< that it takes
};

/// Reads the header and checks that the file can hold what it promises, within the limits of the
/// draft. Throws lod::Error as the readers do.
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes, const MeshDraft& draft);

}  // namespace lod3d
