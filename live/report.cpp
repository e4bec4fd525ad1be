#include <algorithm>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/live/picture.hpp"

namespace live {
namespace {

using Json = nlohmann::ordered_json;

/// Tests of the finished levels of all pairs, level by level.
std::vector<std::uint64_t> tests_by_level(const Stage& stage) {
    std::vector<std::uint64_t> tests;
    for (const NearPair& near : stage.pairs()) {
        std::uint64_t before = 0;
        for (std::size_t level = 0; level < near.fronts.size(); ++level) {
            if (tests.size() <= level) tests.resize(level + 1);
            tests[level] += near.fronts[level].tests - before;
            before = near.fronts[level].tests;
        }
    }
    return tests;
}

/// Tests of levels that the budget ended before their last one.
std::uint64_t dropped_tests(const Stage& stage) {
    std::uint64_t dropped = 0;
    for (const NearPair& near : stage.pairs())
        if (!near.fronts.empty() && near.record.tests > near.fronts.back().tests)
            dropped += near.record.tests - near.fronts.back().tests;
    return dropped;
}

int deepest_levels(const Stage& stage) {
    int levels = 0;
    for (const lod::Body<2>& body : stage.bodies()) levels = std::max(levels, body.tree->levels());
    return levels;
}

Json pair_json(const NearPair& near) {
    const lod::PairRecord& pair = near.record;
    return {{"a", pair.bodies.a},
            {"b", pair.bodies.b},
            {"level", pair.level},
            {"verdict", lod::name_of(pair.verdict)},
            {"tests", pair.tests},
            {"contacts", pair.contact_count},
            {"gap", near.gap < 0 ? Json() : Json(near.gap)},
            {"stands_out", near.stands_out}};
}

Json body_json(const viz::Actor<2>& actor) {
    const lod::Body<2>& body = actor.body;
    return {{"name", actor.visual.name},
            {"x", body.position.x()},
            {"y", body.position.y()},
            {"angle", body.orientation},
            {"reach", body.tree->is_half_space() ? 0.0 : body.tree->sphere(0).radius},
            {"fixed", body.tree->is_half_space()}};
}

std::string hexadecimal(std::uint64_t number) {
    std::string text(16, '0');
    for (std::size_t i = 0; i < text.size(); ++i)
        text[i] = "0123456789abcdef"[number >> (60 - 4 * i) & 0xf];
    return text;
}

/// The deepest contact, and the terms of equation (1) there; null where there is none.
Json contact_json(const Stage& stage) {
    const auto& impacts = stage.record().impacts;
    const auto deepest = std::max_element(
        impacts.begin(), impacts.end(),
        [](const auto& one, const auto& other) { return one.contact.depth < other.contact.depth; });
    if (deepest == impacts.end()) return {};
    const lod::Body<2>& a = stage.bodies()[lod::at(deepest->a)];
    const lod::Body<2>& b = stage.bodies()[lod::at(deepest->b)];
    return {{"a", deepest->a},
            {"b", deepest->b},
            {"normal", {deepest->contact.normal.x(), deepest->contact.normal.y()}},
            {"closing", lod::closing_velocity<2>(a, b, deepest->contact)},
            {"K", lod::inverse_effective_mass<2>(a, b, deepest->contact)},
            {"e", lod::pair_restitution(a, b)},
            {"j", lod::single_impulse<2>(a, b, deepest->contact)}};
}

}  // namespace

std::string report(const Stage& stage) {
    const lod::FrameRecord<2>& record = stage.record();
    const Scene& scene = stage.scene();
    Json json{{"frame", stage.frame()},
              {"time", stage.time()},
              {"hash", hexadecimal(stage.state_hash())},
              {"level", scene.settings.deepest_level},
              {"levels", deepest_levels(stage)},
              {"tests", record.tests},
              {"dropped", dropped_tests(stage)},
              {"by_level", tests_by_level(stage)},
              {"event", stage.event() ? Json(*stage.event()) : Json()},
              {"budget", scene.budget ? Json(*scene.budget) : Json()},
              {"reserved", scene.pair_cost * static_cast<double>(record.node_pairs.size())},
              {"left", record.spending.tests_left ? Json(*record.spending.tests_left) : Json()},
              {"interrupted", record.interrupted()},
              {"contacts", record.impacts.size()},
              {"contact", contact_json(stage)},
              {"energy", lod::kinetic_energy<2>(stage.bodies())},
              {"policy", lod::name_of(scene.settings.priority)},
              {"contact_model", lod::name_of(scene.settings.contact_model)},
              {"response", lod::name_of(scene.settings.response)},
              {"pairs", Json::array()},
              {"bodies", Json::array()}};
    for (const NearPair& near : stage.pairs()) json["pairs"].push_back(pair_json(near));
    for (std::size_t i = 0; i < stage.bodies().size(); ++i)
        json["bodies"].push_back(body_json(stage.actor(i)));
    return json.dump();
}

std::string events_report(Stage& stage) {
    const std::vector<std::string> names = stage.names();
    Json events = Json::array();
    for (const scenes::Event<2>& event : stage.apart().events)
        events.push_back({{"name", scenes::event_name(event)},
                          {"kind", lod::name_of(event.kind)},
                          {"a", event.a},
                          {"b", event.b},
                          {"pair", names[lod::at(event.a)] + " and " + names[lod::at(event.b)]},
                          {"short", scenes::sentence<2>(event, names, scenes::Places::left_out)},
                          {"sentence", scenes::sentence<2>(event, names)}});
    return Json{{"events", std::move(events)}}.dump();
}

}  // namespace live
