#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scenes {

struct TomlTable;

/// One value of a TOML file and where it stands. Only what scenes use is told apart; the rest
/// (dates, arrays of anything but numbers or tables) is `other`.
struct TomlEntry {
    struct Other {};
    using Value = std::variant<Other, bool, std::int64_t, double, std::string, std::vector<double>,
                               std::vector<TomlTable>>;
    std::string key;
    Value value;  ///< a table is an array of one
    bool is_array = false;
    std::string where;  ///< "file:line:column"
};

/// A table of a TOML file, its entries in the order of the file.
struct TomlTable {
    std::string where;
    std::vector<TomlEntry> entries;
};

/// Parses TOML. Throws lod::Error (input refused) with file, line and column.
[[nodiscard]] TomlTable parse_toml(std::string_view text, const std::filesystem::path& path);

}  // namespace scenes
