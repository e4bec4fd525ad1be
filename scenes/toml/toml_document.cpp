#include "lodlab/scenes/toml/toml_document.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "lodlab/core/base/error.hpp"

namespace scenes {
namespace {

std::string where(const std::filesystem::path& path, const toml::source_region& region) {
    return path.string() + ":" + std::to_string(region.begin.line) + ":" +
           std::to_string(region.begin.column);
}

TomlTable table_of(const toml::table& table, const std::filesystem::path& path);

/// An array of numbers, an array of tables, or something that no scene uses.
TomlEntry::Value array_of(const toml::array& array, const std::filesystem::path& path) {
    std::vector<double> numbers;
    std::vector<TomlTable> tables;
    for (const toml::node& node : array) {
        if (const toml::table* table = node.as_table())
            tables.push_back(table_of(*table, path));
        else if (node.is_number())
            numbers.push_back(node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                                : node.as_floating_point()->get());
    }
    if (!array.empty() && tables.size() == array.size()) return tables;
    if (numbers.size() == array.size()) return numbers;
    return TomlEntry::Other{};
}

TomlEntry::Value value_of(const toml::node& node, const std::filesystem::path& path) {
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* integer = node.as_integer()) return integer->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* text = node.as_string()) return text->get();
    if (const toml::table* table = node.as_table()) return std::vector{table_of(*table, path)};
    if (const toml::array* array = node.as_array()) return array_of(*array, path);
    return TomlEntry::Other{};
}

TomlTable table_of(const toml::table& table, const std::filesystem::path& path) {
    struct Placed {
        toml::source_position position;
        TomlEntry entry;
    };
    std::vector<Placed> placed;
    for (const auto& [key, node] : table) {
        const bool is_section = node.is_table() || node.is_array_of_tables();
        const auto& region = is_section ? node.source() : key.source();
        placed.push_back(
            {region.begin,
             {std::string(key.str()), value_of(node, path), node.is_array(), where(path, region)}});
    }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const Placed& a, const Placed& b) { return a.position < b.position; });
    TomlTable result{where(path, table.source()), {}};
    for (Placed& one : placed) result.entries.push_back(std::move(one.entry));
    return result;
}

}  // namespace

TomlTable parse_toml(std::string_view text, const std::filesystem::path& path) {
    try {
        return table_of(toml::parse(text, path.string()), path);
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        std::replace(what.begin(), what.end(), '\n', ' ');
        throw lod::Error(
            lod::ErrorKind::input_refused,
            where(path, error.source()) + ": this is no TOML: " + what + "; mend the line");
    }
}

}  // namespace scenes
