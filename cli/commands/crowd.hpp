#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/arguments/options.hpp"
#include "cli/stage/pictures.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/scenes/setup.hpp"

/// The three questions of `crowd`, a file each. What measures them prints their results.
namespace cli {

/// What quotas cost: crowd_errors.cpp.
void show_errors(const Options& options);
/// How long frames take: crowd_times.cpp.
void show_times(const Options& options);
/// Which levels are reached: crowd_levels.cpp.
void show_levels(const Options& options);

/// Writes the picture of what was measured wherever the options say so, and prints it.
void show(const Options& options, std::function<viz::Figure()> figure,
          const std::function<nlohmann::ordered_json()>& json,
          const std::function<std::string()>& report);

/// How many bodies are no walls.
[[nodiscard]] std::size_t moving_in(const scenes::Scene& scene);

/// {"p10", "median", "p90"}
[[nodiscard]] nlohmann::ordered_json json_of(const measure::Spread& spread);

/// {"milliseconds", "node_tests"}: the quota that the options name, null where it is the other.
[[nodiscard]] nlohmann::ordered_json quota_json(const Options& options);

/// "1 ms", "3000 node tests".
[[nodiscard]] std::string quota_words(const Options& options);

/// The policies that the options name, or the scene's.
[[nodiscard]] std::vector<lod::Priority> policies_of(const Options& options,
                                                     const scenes::Scene& scene);

}  // namespace cli
