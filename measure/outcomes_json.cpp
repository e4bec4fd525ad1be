#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/whole_number.hpp"
#include "lodlab/measure/curves.hpp"
#include "lodlab/scenes/scene.hpp"

namespace measure {
namespace {

using Json = nlohmann::ordered_json;

constexpr int outcomes_version = 1;
constexpr std::size_t most_bytes = std::size_t{1} << 31;
constexpr std::size_t numbers_per_outcome = 9;

template <class Choice>
Json names_json(const std::vector<Choice>& choices) {
    Json list = Json::array();
    for (const Choice choice : choices) list.push_back(lod::name_of(choice));
    return list;
}

template <class Choice>
std::vector<Choice> choices_from(const Json& json) {
    std::vector<Choice> choices;
    for (const Json& entry : json) {
        const auto& name = entry.get_ref<const std::string&>();
        const std::optional<Choice> found = lod::named<Choice>(name);
        if (!found) throw std::invalid_argument("\"" + name + "\" is no setting");
        choices.push_back(*found);
    }
    return choices;
}

Json plan_json(const Plan& plan) {
    return {{"dim", plan.dim},
            {"shapes", plan.shapes},
            {"builder", plan.builder},
            {"branching", plan.branching},
            {"depth", plan.depth},
            {"impacts", plan.impacts},
            {"time_step", plan.time_step},
            {"seed", plan.ensemble.seed},
            {"speed", plan.ensemble.speed},
            {"spin", plan.ensemble.spin},
            {"aim", plan.ensemble.aim},
            {"restitution", plan.ensemble.restitution},
            {"models", names_json(plan.models)},
            {"responses", names_json(plan.responses)}};
}

Plan plan_from(const Json& json) {
    Plan plan;
    plan.dim = io::whole_number<int>(json.at("dim"));
    plan.shapes = json.at("shapes").get<std::vector<std::string>>();
    plan.builder = json.at("builder").get<std::string>();
    plan.branching = io::whole_number<int>(json.at("branching"));
    plan.depth = io::whole_number<int>(json.at("depth"));
    plan.impacts = io::whole_number<int>(json.at("impacts"));
    plan.time_step = json.at("time_step").get<double>();
    plan.ensemble.seed = io::whole_number<std::uint64_t>(json.at("seed"));
    plan.ensemble.speed = json.at("speed").get<double>();
    plan.ensemble.spin = json.at("spin").get<double>();
    plan.ensemble.aim = json.at("aim").get<double>();
    plan.ensemble.restitution = json.at("restitution").get<double>();
    plan.models = choices_from<lod::ContactModel>(json.at("models"));
    plan.responses = choices_from<lod::Response>(json.at("responses"));
    if (plan.depth < 0 || plan.depth > 12) throw std::invalid_argument("depth is out of range");
    return plan;
}

Json outcome_json(const Outcome& o) {
    return {o.impulse_error, o.angle_error, o.spin_error,   o.gap,   o.gap_bound,
            o.delay,         o.tests,       o.microseconds, o.missed};
}

Outcome outcome_from(const Json& json) {
    if (!json.is_array() || json.size() != numbers_per_outcome)
        throw std::invalid_argument("an outcome is not a list of " +
                                    std::to_string(numbers_per_outcome));
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>(),
            json[3].get<double>(), json[4].get<double>(), json[5].get<double>(),
            json[6].get<double>(), json[7].get<double>(), json[8].get<bool>()};
}

Outcomes outcomes_from(const Json& json) {
    if (io::whole_number<int>(json.at("lodlab_outcomes")) != outcomes_version)
        throw std::invalid_argument("it has another version");
    Outcomes outcomes{plan_from(json.at("plan")), {}};
    for (const Json& entry : json.at("impacts")) {
        ImpactSample impact{io::whole_number<int>(entry.at("number")), {}};
        for (const Json& outcome : entry.at("outcomes"))
            impact.outcomes.push_back(outcome_from(outcome));
        if (impact.outcomes.size() != outcomes.plan.curves() * outcomes.plan.levels())
            throw std::invalid_argument("impact " + std::to_string(impact.number) +
                                        " lacks outcomes");
        outcomes.impacts.push_back(std::move(impact));
    }
    return outcomes;
}

}  // namespace

std::string outcomes_json(const Outcomes& outcomes) {
    std::string text = "{\"lodlab_outcomes\": ";
    text.append(std::to_string(outcomes_version));
    text.append(",\n \"plan\": ")
        .append(plan_json(outcomes.plan).dump(-1, ' ', false, Json::error_handler_t::replace));
    text +=
        ",\n \"outcome\": \"impulse_error, angle_error, spin_error, gap, gap_bound, delay, "
        "tests, microseconds, missed\",\n \"impacts\": [";
    const char* separator = "\n  ";
    for (const ImpactSample& impact : outcomes.impacts) {
        Json list = Json::array();
        for (const Outcome& outcome : impact.outcomes) list.push_back(outcome_json(outcome));
        text += separator;
        text += Json({{"number", impact.number}, {"outcomes", std::move(list)}}).dump();
        separator = ",\n  ";
    }
    text += "]}\n";
    return text;
}

Outcomes outcomes_from_json(const std::string& text, const std::string& source) {
    try {
        return outcomes_from(Json::parse(text));
    } catch (const std::exception& error) {
        if (dynamic_cast<const lod::Error*>(&error) != nullptr) throw;
        throw lod::Error(lod::ErrorKind::input_refused,
                         source + " holds no outcomes of lodlab degrade: " + error.what() +
                             "; write it again with --out");
    }
}

void save_outcomes(const std::filesystem::path& path, const Outcomes& outcomes) {
    lod::write_text_file(path, outcomes_json(outcomes));
}

Outcomes load_outcomes(const std::filesystem::path& path) {
    return outcomes_from_json(lod::read_text_file(path, most_bytes), path.string());
}

}  // namespace measure
