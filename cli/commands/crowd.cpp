#include "cli/commands/crowd.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/arguments/choices.hpp"
#include "cli/arguments/command.hpp"
#include "cli/terminal/output.hpp"

namespace cli {

using Json = nlohmann::ordered_json;

void show(const Options& options, std::function<viz::Figure()> figure,
          const std::function<Json()>& json, const std::function<std::string()>& report) {
    Drawing drawing;
    drawing.figure = std::move(figure);
    write_outputs(options, drawing);
    if (options.json)
        print(json());
    else
        print(report());
}

std::size_t moving_in(const scenes::Scene& scene) {
    return static_cast<std::size_t>(
        std::count_if(scene.bodies.begin(), scene.bodies.end(),
                      [](const scenes::BodySpec& body) { return !body.is_static; }));
}

Json json_of(const measure::Spread& spread) {
    return {{"p10", spread.p10}, {"median", spread.median}, {"p90", spread.p90}};
}

Json quota_json(const Options& options) {
    return {{"milliseconds", options.milliseconds ? Json(*options.milliseconds) : Json()},
            {"node_tests", options.budget ? Json(*options.budget) : Json()}};
}

std::string quota_words(const Options& options) {
    if (options.milliseconds) return readable(*options.milliseconds) + " ms";
    return std::to_string(*options.budget) + " node tests";
}

std::vector<lod::Priority> policies_of(const Options& options, const scenes::Scene& scene) {
    if (options.policies.empty()) return {scene.priority};
    return choices_in<lod::Priority>(options.policies, "--policies");
}

void run_crowd(const Options& options) {
    if (!options.bodies.empty()) return show_times(options);
    if (options.levels) return show_levels(options);
    show_errors(options);
}

}  // namespace cli
