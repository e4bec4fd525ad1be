#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/cli/program.hpp"

using Json = nlohmann::json;

/// What the program prints with --json.
inline Json result(const std::vector<std::string>& arguments) {
    const Outcome outcome = lodlab(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out);
}

/// Every key of a result as the documentation writes it: "levels[].nodes". Arrays of numbers are
/// values.
inline void collect(const Json& json, const std::string& path, std::set<std::string>& keys) {
    if (json.is_object()) {
        for (const auto& [key, value] : json.items())
            collect(value, path.empty() ? key : path + "." + key, keys);
    } else if (json.is_array() && !json.empty() && json.front().is_object()) {
        for (const Json& one : json) collect(one, path + "[]", keys);
    } else {
        keys.insert(path);
    }
}

/// The keys that the manual lists for the results of a command.
inline std::set<std::string> documented(const std::string& command) {
    std::ifstream page(LODLAB_SOURCE_DIR "/cli/README.md");
    std::set<std::string> keys;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) inside = line == "## JSON: `" + command + "`";
        if (inside && line.starts_with("| `")) keys.insert(line.substr(3, line.find('`', 3) - 3));
    }
    return keys;
}

/// Its keys are those that the manual lists.
inline void check_keys(const std::string& command, const Json& json) {
    std::set<std::string> keys;
    collect(json, "", keys);
    CHECK(keys == documented(command));
}
