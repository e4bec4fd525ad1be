#include "lodlab/scenes/trace/frame_mark.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/io/whole_number.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"

namespace scenes {
namespace {

constexpr std::size_t digits_of_a_body = 4;

template <int Dim>
void add_state(const State<Dim>& state, lod::BitHash& hash) {
    hash.add(state.position);
    hash.add(state.orientation);
    hash.add(state.velocity);
    hash.add(state.spin);
}

template <int Dim>
std::uint16_t small_hash(const State<Dim>& state) {
    lod::BitHash hash;
    add_state(state, hash);
    const std::uint64_t all = hash.value();
    return static_cast<std::uint16_t>(all ^ (all >> 16) ^ (all >> 32) ^ (all >> 48));
}

template <int Dim>
void hash_pairs(const lod::FrameRecord<Dim>& record, StageHashes& hashes) {
    lod::BitHash pairs;
    lod::BitHash levels;
    for (const lod::PairRecord& pair : record.pairs) {
        pairs.add(pair.bodies.a);
        pairs.add(pair.bodies.b);
        levels.add(static_cast<std::int32_t>(pair.level));
        levels.add(static_cast<std::int32_t>(pair.verdict));
        levels.add(pair.tests);
        levels.add(static_cast<std::int32_t>(pair.finest));
        levels.add(pair.impact_time);
    }
    hashes.pairs = pairs.value();
    hashes.levels = levels.value();
}

std::string digits(const std::vector<std::uint16_t>& bodies) {
    std::string text;
    text.reserve(digits_of_a_body * bodies.size());
    for (const std::uint16_t body : bodies) text += hexadecimal(body).substr(16 - digits_of_a_body);
    return text;
}

std::vector<std::uint16_t> bodies_from(const std::string& digits) {
    if (digits.size() % digits_of_a_body != 0) throw std::invalid_argument("marks are cut short");
    std::vector<std::uint16_t> bodies;
    bodies.reserve(digits.size() / digits_of_a_body);
    for (std::size_t i = 0; i < digits.size(); i += digits_of_a_body)
        bodies.push_back(
            static_cast<std::uint16_t>(from_hexadecimal(digits.substr(i, digits_of_a_body))));
    return bodies;
}

std::uint64_t hash_from(const Json& json) {
    return from_hexadecimal(json.get_ref<const std::string&>());
}

std::chrono::nanoseconds time_from(const Json& json) {
    return std::chrono::nanoseconds(io::whole_number<std::int64_t>(json));
}

}  // namespace

template <int Dim>
FrameMark mark_of(const Step<Dim>& step, const std::vector<State<Dim>>& after) {
    FrameMark mark;
    mark.cut = step.record.cut;
    hash_pairs(step.record, mark.hashes);
    lod::BitHash contacts;
    for (const lod::Impact<Dim>& impact : step.record.impacts) {
        contacts.add(impact.a);
        contacts.add(impact.b);
        contacts.add(impact.contact.point);
        contacts.add(impact.contact.normal);
        contacts.add(impact.contact.depth);
    }
    mark.hashes.contacts = contacts.value();
    lod::BitHash impulses;
    impulses.add_all(step.record.impulses);
    mark.hashes.impulses = impulses.value();
    mark.hashes.motion = step.state_hash;
    mark.bodies.reserve(after.size());
    for (const State<Dim>& state : after) mark.bodies.push_back(small_hash(state));
    mark.time_left = step.record.spending.time_left;
    mark.after_levels = step.record.spending.after_levels;
    return mark;
}

template <int Dim>
std::uint64_t hash_of(const std::vector<State<Dim>>& states) {
    lod::BitHash hash;
    for (const State<Dim>& state : states) add_state(state, hash);
    return hash.value();
}

Json json_of(std::int64_t frame, const FrameMark& mark) {
    Json json = {{"frame", frame},
                 {"cut", json_of(mark.cut)},
                 {"state_hash", hexadecimal(mark.hashes.motion)},
                 {"stages",
                  {{"pairs", hexadecimal(mark.hashes.pairs)},
                   {"levels", hexadecimal(mark.hashes.levels)},
                   {"contacts", hexadecimal(mark.hashes.contacts)},
                   {"impulses", hexadecimal(mark.hashes.impulses)}}},
                 {"marks", digits(mark.bodies)}};
    if (mark.time_left && mark.after_levels)
        json["time"] = {{"left", mark.time_left->count()},
                        {"after_levels", mark.after_levels->left.count()},
                        {"reserved", mark.after_levels->reserved.count()}};
    return json;
}

FrameMark mark_from(const Json& json) {
    FrameMark mark;
    mark.cut = cut_from(json.at("cut"));
    mark.hashes.motion = hash_from(json.at("state_hash"));
    const Json& stages = json.at("stages");
    mark.hashes.pairs = hash_from(stages.at("pairs"));
    mark.hashes.levels = hash_from(stages.at("levels"));
    mark.hashes.contacts = hash_from(stages.at("contacts"));
    mark.hashes.impulses = hash_from(stages.at("impulses"));
    mark.bodies = bodies_from(json.at("marks").get_ref<const std::string&>());
    if (!json.contains("time")) return mark;
    const Json& time = json.at("time");
    mark.time_left = time_from(time.at("left"));
    mark.after_levels = {time_from(time.at("after_levels")), time_from(time.at("reserved"))};
    return mark;
}

#define SCENES_INSTANTIATE(Dim)                                                   \
    template FrameMark mark_of(const Step<Dim>&, const std::vector<State<Dim>>&); \
    template std::uint64_t hash_of(const std::vector<State<Dim>>&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
