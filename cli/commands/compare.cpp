#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/compare_pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/stage/threads.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/core/base/error.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;
using measure::Collision;
using measure::Comparison;
using measure::FirstImpact;
using Answer = std::optional<Collision<2>>;

/// What errors are taken against: the exact answer, or Box2D's where there is no exact one.
const Answer& truth_of(const FirstImpact& impact) {
    return impact.exact ? impact.exact : impact.box2d;
}

Json motion_of(const lod::Body<2>& body) {
    return {{"velocity", {body.velocity.x(), body.velocity.y()}}, {"spin", body.spin[0]}};
}

Json error_of(const Answer& truth, const Answer& seen) {
    if (!truth || !seen) return {};
    const measure::ImpactError error = measure::impact_error(*truth, *seen);
    return {{"impulse", error.impulse}, {"angle", error.angle}, {"spin", error.spin}};
}

/// An answer's time, gap and velocities after the impact; null where there is no collision.
void put_answer(Json& json, const Answer& answer) {
    json["time"] = answer ? Json(answer->time) : Json();
    json["gap"] = answer ? Json(answer->gap) : Json();
    json["a"] = answer ? motion_of(answer->after[0]) : Json();
    json["b"] = answer ? motion_of(answer->after[1]) : Json();
}

std::string name_of(const scenes::Setup<2>& setup, int body) {
    return setup.scene.bodies[static_cast<std::size_t>(body)].name;
}

Json json_of(const scenes::Setup<2>& setup, const FirstImpact& impact) {
    Json json{{"a", name_of(setup, impact.a)}, {"b", name_of(setup, impact.b)}};
    put_answer(json["exact"], impact.exact);
    put_answer(json["box2d"], impact.box2d);
    json["box2d"]["error"] = error_of(truth_of(impact), impact.box2d);
    json["levels"] = Json::array();
    for (std::size_t level = 0; level < impact.levels.size(); ++level) {
        Json one{{"level", level}};
        put_answer(one, impact.levels[level]);
        one["error"] = error_of(truth_of(impact), impact.levels[level]);
        json["levels"].push_back(std::move(one));
    }
    return json;
}

Json json_of(const scenes::Setup<2>& setup, const Comparison& comparison,
             const measure::ComparedRun& run, Json name) {
    Json matches = Json::array();
    for (const measure::CollisionError& match : run.perceived.collisions) {
        const auto& reference =
            comparison.box2d_collisions[static_cast<std::size_t>(match.reference)];
        const auto& error = match.error;
        matches.push_back({{"a", name_of(setup, reference.a)},
                           {"b", name_of(setup, reference.b)},
                           {"time", run.collisions[static_cast<std::size_t>(match.seen)].time},
                           {"reference_time", reference.time},
                           {"first", match.first},
                           {"gap", error.gap},
                           {"delay", error.delay},
                           {"angle", error.angle},
                           {"speed", error.speed},
                           {"spin", error.spin},
                           {"penetration", error.penetration},
                           {"energy", error.energy},
                           {"cost", match.cost.sum()}});
    }
    const measure::PerceivedCost& cost = run.perceived.cost;
    return {{"level", std::move(name)},
            {"collisions", run.collisions.size()},
            {"matched", run.perceived.collisions.size()},
            {"missing", run.perceived.missing.size()},
            {"extra", run.perceived.extra.size()},
            {"perceived",
             {{"total", run.perceived.total},
              {"gap", cost.gap},
              {"delay", cost.delay},
              {"angle", cost.angle},
              {"speed", cost.speed},
              {"spin", cost.spin},
              {"penetration", cost.penetration},
              {"energy", cost.energy},
              {"missing", run.perceived.missing_cost},
              {"extra", run.perceived.extra_cost}}},
            {"matches", std::move(matches)}};
}

Json result_of(const scenes::Setup<2>& setup, const Comparison& comparison) {
    Json impacts = Json::array();
    for (const FirstImpact& impact : comparison.first_impacts)
        impacts.push_back(json_of(setup, impact));
    Json runs = Json::array();
    for (const measure::ComparedRun& run : comparison.levels)
        runs.push_back(json_of(setup, comparison, run, run.level));
    runs.push_back(json_of(setup, comparison, comparison.exact, "exact"));
    return {{"scene", setup.scene.name},
            {"box2d",
             {{"time_step", comparison.box2d_settings.time_step},
              {"units_per_metre", comparison.box2d_settings.units_per_metre},
              {"collisions", comparison.box2d_collisions.size()}}},
            {"impacts", std::move(impacts)},
            {"runs", std::move(runs)}};
}

template <class... Values>
std::string row(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

constexpr double degrees = 180 / 3.14159265358979323846;

std::string motion_words(const lod::Body<2>& body) {
    if (body.is_static()) return row("%26s   ", "at rest");
    return row("(%7.3f, %7.3f) %7.3f   ", body.velocity.x(), body.velocity.y(), body.spin[0]);
}

std::string answer_row(const std::string& name, const Answer& truth, const Answer& answer) {
    if (!answer) return row("  %-8s  no collision\n", name.c_str());
    std::string text = row("  %-8s  %7.4f  %7.2f  ", name.c_str(), answer->time, 1e3 * answer->gap);
    if (truth) {
        const measure::ImpactError error = measure::impact_error(*truth, *answer);
        text += row("%8.2f %7.2f %7.3f   ", 100 * error.impulse, degrees * error.angle, error.spin);
    } else {
        text += row("%27s", "out of nothing   ");
    }
    return text + motion_words(answer->after[0]) + motion_words(answer->after[1]) + "\n";
}

std::string table_of(const scenes::Setup<2>& setup, const FirstImpact& impact) {
    const Answer& truth = truth_of(impact);
    std::string text = "First impact of ";
    text.append(name_of(setup, impact.a)).append(" (A) and ").append(name_of(setup, impact.b));
    text.append(" (B), the two alone; ");
    text.append(impact.exact   ? "errors against the exact impact\n"
                : impact.box2d ? "errors against Box2D: there is no exact impact\n"
                               : "exactly they never touch\n");
    text += row("  %-8s  %7s  %7s  %8s %7s %7s   %-27s  %s\n", "", "time", "gap", "impulse",
                "angle", "spin", "A after: velocity, spin", "B after: velocity, spin");
    text += row("  %-8s  %7s  %7s  %8s %7s %7s   %-27s  %s\n", "", "s", "mm", "off, %", "off, deg",
                "off", "m/s, rad/s", "m/s, rad/s");
    for (std::size_t level = 0; level < impact.levels.size(); ++level)
        text += answer_row(row("level %zu", level), truth, impact.levels[level]);
    if (impact.exact) text += answer_row("exact", truth, impact.exact);
    return text + answer_row("Box2D", truth, impact.box2d) + "\n";
}

std::string perceived_row(const std::string& name, const measure::PerceivedError& p) {
    const measure::PerceivedCost& c = p.cost;
    return row(
        "  %-8s %7zu %7zu %7zu  %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f "
        "%7.2f\n",
        name.c_str(), p.collisions.size(), p.missing.size(), p.extra.size(), p.total, c.gap,
        c.delay, c.angle, c.speed, c.spin, c.penetration, c.energy, p.missing_cost, p.extra_cost);
}

std::string perceived_table(const Comparison& comparison) {
    std::string text = row("Whole run against Box2D's (collisions: %zu), and what looks wrong: 1 "
                           "is about where a part "
                           "begins to show (METHOD.md)\n",
                           comparison.box2d_collisions.size()) +
                       row("  %-8s %7s %7s %7s  %7s %7s %7s %7s %7s %7s %7s %7s %7s %7s\n", "",
                           "matched", "missing", "extra", "total", "gap", "delay", "angle", "speed",
                           "spin", "overlap", "energy", "missing", "extra");
    for (const measure::ComparedRun& run : comparison.levels)
        text += perceived_row(row("level %d", run.level), run.perceived);
    text += perceived_row("exact", comparison.exact.perceived);
    if (comparison.box2d_collisions.size() > comparison.first_impacts.size())
        text +=
            "After several impacts paths part, however fine the level: every small difference "
            "has grown.\n";
    return text;
}

std::string report_of(const scenes::Setup<2>& setup, const Comparison& comparison) {
    constexpr std::size_t most_tables = 4;
    std::string text = setup.scene.name + ": " + std::to_string(comparison.levels.size()) +
                       " levels, exactly, and by Box2D\n\n";
    const std::size_t impacts = comparison.first_impacts.size();
    if (impacts == 0) text += "No two bodies collide, at any level or by Box2D.\n\n";
    for (std::size_t i = 0; i < std::min(impacts, most_tables); ++i)
        text += table_of(setup, comparison.first_impacts[i]);
    if (impacts > most_tables)
        text += std::to_string(impacts - most_tables) + " more first impacts: see --json\n\n";
    return text + perceived_table(comparison);
}

Comparison compared(const scenes::Setup<2>& setup, const Options& from) {
    ProgressBar bar("Comparing");
    measure::ComparisonOptions options;
    options.settings = scenes::frame_settings(setup.scene, {});
    options.frames = setup.scene.frames();
    const Threads threads(from);
    options.executor = threads.executor();
    options.progress = [&](double share) { bar.show(share); };
    std::vector<const lod2d::Shape*> shapes;
    for (const auto& shape : setup.shapes) shapes.push_back(shape.get());
    return measure::compare(setup.bodies, shapes, options);
}

}  // namespace

void run_compare(const Options& options) {
    check_outputs(options, {.video = true});
    const scenes::Scene scene = scene_of(options);
    if (scene.dim != 2)
        throw lod::Error(lod::ErrorKind::usage, scene.name +
                                                    " is a scene of space, and Box2D is of the "
                                                    "plane; compare a scene of the plane");
    const scenes::Setup<2> setup = stage<2>(scene, options);
    const Comparison comparison = compared(setup, options);
    write_outputs(options, drawing_of(setup, comparison));
    if (options.json)
        print(result_of(setup, comparison));
    else
        print(report_of(setup, comparison));
}

}  // namespace cli
