#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/pictures.hpp"
#include "cli/staging.hpp"
#include "core/error.hpp"
#include "core/traversal.hpp"
#include "viz/draw_traversal.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> verdict_names{"apart", "possible", "true"};

/// One instant of a scene, and all that detection finds there.
struct Instant {
    double time = 0;
    std::vector<lod::Body<2>> bodies;
    lod::FrameRecord<2> record;
};

bool leaves_meet(const scenes::Step<2>& step) {
    return std::any_of(step.record.pairs.begin(), step.record.pairs.end(), [](const auto& pair) {
        return pair.verdict == lod::Verdict::true_collision;
    });
}

/// The first frame in which leaves meet; where they never do, the one with the most node tests:
/// there the bodies come nearest.
std::size_t telling_frame(const scenes::Run<2>& run) {
    const auto meeting = std::find_if(run.steps.begin(), run.steps.end(), leaves_meet);
    if (meeting != run.steps.end()) return static_cast<std::size_t>(meeting - run.steps.begin());
    const auto busiest = std::max_element(
        run.steps.begin(), run.steps.end(),
        [](const auto& x, const auto& y) { return x.record.tests < y.record.tests; });
    return static_cast<std::size_t>(busiest - run.steps.begin());
}

Instant instant_of(const scenes::Setup& setup, const Options& options) {
    // The bodies move under the finest detection; --level limits what is looked at.
    scenes::Setup finest = setup;
    finest.scene.limits = {};
    if (options.at) finest.scene.duration = *options.at + finest.scene.time_step;
    const scenes::Run<2> run = play(finest, options, "Moving to the instant");
    const std::size_t frame =
        options.at ? static_cast<std::size_t>(std::lround(*options.at / setup.scene.time_step))
                   : telling_frame(run);
    const std::size_t index = std::min(frame, run.steps.size() - 1);

    Instant instant;
    instant.time = static_cast<double>(index) * setup.scene.time_step;
    instant.bodies = setup.bodies;
    for (std::size_t i = 0; i < instant.bodies.size(); ++i)
        scenes::put(run.steps[index].before[i], instant.bodies[i]);
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    instant.record = lod::detect<2>(
        instant.bodies, scenes::frame_settings(setup.scene, setup.scene.limits), budget, storage);
    return instant;
}

std::vector<lod::Front> levels_of(const Instant& instant, const lod::PairRecord& pair) {
    return lod::traverse_levels(instant.bodies[static_cast<std::size_t>(pair.bodies.a)],
                                instant.bodies[static_cast<std::size_t>(pair.bodies.b)],
                                pair.level);
}

std::string name_of(const scenes::Setup& setup, std::int32_t body) {
    return setup.scene.bodies[static_cast<std::size_t>(body)].name;
}

Json contacts_of(const Instant& instant, const lod::PairRecord& pair) {
    Json list = Json::array();
    for (std::int32_t k = 0; k < pair.contact_count; ++k) {
        const lod::Contact<2>& contact =
            instant.record.impacts[static_cast<std::size_t>(pair.first_contact + k)].contact;
        list.push_back({{"point", {contact.point.x(), contact.point.y()}},
                        {"normal", {contact.normal.x(), contact.normal.y()}},
                        {"depth", contact.depth}});
    }
    return list;
}

Json result_of(const scenes::Setup& setup, const Instant& instant) {
    Json pairs = Json::array();
    for (const lod::PairRecord& pair : instant.record.pairs) {
        Json levels = Json::array();
        std::uint64_t before = 0;
        for (const lod::Front& front : levels_of(instant, pair)) {
            levels.push_back({{"level", front.level},
                              {"tests", front.tests - before},
                              {"intersecting", front.pairs.size()}});
            before = front.tests;
        }
        pairs.push_back({{"a", name_of(setup, pair.bodies.a)},
                         {"b", name_of(setup, pair.bodies.b)},
                         {"verdict", verdict_names[static_cast<std::size_t>(pair.verdict)]},
                         {"levels", std::move(levels)},
                         {"contacts", contacts_of(instant, pair)}});
    }
    return {{"pairs", std::move(pairs)}};
}

std::string report_of(const scenes::Setup& setup, const Instant& instant) {
    std::string text = setup.scene.name + " at " + readable(instant.time) +
                       " s: " + std::to_string(instant.record.pairs.size()) + " candidate pairs\n";
    for (const lod::PairRecord& pair : instant.record.pairs) {
        text += "  " + name_of(setup, pair.bodies.a) + " and " + name_of(setup, pair.bodies.b) +
                ": " + (pair.verdict == lod::Verdict::apart ? "apart" : "") +
                (pair.verdict == lod::Verdict::possible ? "a possible collision" : "") +
                (pair.verdict == lod::Verdict::true_collision ? "a true collision" : "") + "\n";
        for (const lod::Front& front : levels_of(instant, pair))
            text += "    level " + std::to_string(front.level) + ": " +
                    std::to_string(front.pairs.size()) + " intersecting node pairs after " +
                    std::to_string(front.tests) + " tests\n";
    }
    return text;
}

/// The traversal of the pair that took the most tests: the one worth a look.
viz::Figure figure_of(const scenes::Setup& setup, const Instant& instant) {
    const auto& pairs = instant.record.pairs;
    const auto busiest = std::max_element(
        pairs.begin(), pairs.end(), [](const auto& x, const auto& y) { return x.tests < y.tests; });
    if (busiest == pairs.end())
        throw lod::Error(
            lod::ErrorKind::input_refused,
            "no two bodies come near each other at " + readable(instant.time) +
                " s, so there is no traversal to draw; choose another instant by --at");
    return viz::traversal(actor_of(setup, instant.bodies, busiest->bodies.a),
                          actor_of(setup, instant.bodies, busiest->bodies.b),
                          levels_of(instant, *busiest));
}

}  // namespace

void run_collide(const Options& options) {
    check_outputs(options, false);
    const scenes::Setup setup = stage(options);
    const Instant instant = instant_of(setup, options);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(setup, instant); };
    write_outputs(options, drawing);
    if (options.json)
        print(result_of(setup, instant));
    else
        print(report_of(setup, instant));
}

}  // namespace cli
