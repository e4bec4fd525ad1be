#include "lodlab/scenes/keys.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/scenes/spelling.hpp"

namespace scenes {
namespace {

constexpr double most_metres = 1e6;
constexpr double most_speed = 1e6;  // m/s and rad/s
constexpr double most_degrees = 1e6;
constexpr double least_mass = 1e-9;  // kg, kg/m^2
constexpr double most_mass = 1e12;
constexpr double least_step = 1e-7;  // s
constexpr double longest = 3600;     // s

[[noreturn]] void refuse(const TomlEntry& entry, const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, entry.where + ": " + entry.key + " " + why);
}

std::optional<double> as_number(const TomlEntry& entry) {
    if (const auto* integer = std::get_if<std::int64_t>(&entry.value))
        return static_cast<double>(*integer);
    if (const auto* number = std::get_if<double>(&entry.value)) return *number;
    return {};
}

void check_range(const TomlEntry& entry, double value, double low, double high) {
    if (!(value >= low && value <= high))  // NaN fails too
        refuse(entry, "must lie between " + lod::number_text(low) + " and " +
                          lod::number_text(high) + ", not " + lod::number_text(value));
}

double number(const TomlEntry& entry, double low, double high) {
    const auto value = as_number(entry);
    if (!value) refuse(entry, "must be a number");
    check_range(entry, *value, low, high);
    return *value;
}

double mass(const TomlEntry& entry) {
    const auto value = as_number(entry);
    if (value && *value <= 0)
        refuse(entry, "must be above 0, not " + lod::number_text(*value) +
                          "; for a body that never moves write static = true");
    return number(entry, least_mass, most_mass);
}

int integer(const TomlEntry& entry, int low, int high) {
    const auto* value = std::get_if<std::int64_t>(&entry.value);
    if (!value) refuse(entry, "must be a whole number");
    check_range(entry, static_cast<double>(*value), low, high);
    return static_cast<int>(*value);
}

std::string text(const TomlEntry& entry) {
    const auto* value = std::get_if<std::string>(&entry.value);
    if (!value) refuse(entry, "must be a text in quotes");
    if (value->empty()) refuse(entry, "must not be empty; leave the key out instead");
    constexpr std::size_t longest_text = 1000;
    if (value->size() > longest_text) refuse(entry, "is too long; use at most 1000 characters");
    if (std::any_of(value->begin(), value->end(), [](unsigned char c) { return c < ' '; }))
        refuse(entry, "must be one line");
    return *value;
}

/// Of a SHA-256 in hexadecimal.
void check_digest(const TomlEntry& entry, std::string_view digits) {
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (digits.size() != 64 || !std::all_of(digits.begin(), digits.end(), is_digit))
        refuse(entry, "must be 64 digits 0 to f, as sha256sum prints them");
}

bool truth(const TomlEntry& entry) {
    const auto* value = std::get_if<bool>(&entry.value);
    if (!value) refuse(entry, "must be true or false");
    return *value;
}

Triple vector(const TomlEntry& entry, const Reading& reading, double most) {
    const auto* values = std::get_if<std::vector<double>>(&entry.value);
    if (!values || values->size() != static_cast<std::size_t>(reading.dim))
        refuse(entry, reading.dim == 2 ? "must be two numbers, as in [0.5, -1]"
                                       : "must be three numbers, as in [0.5, -1, 2]");
    Triple triple{};
    for (std::size_t i = 0; i < values->size(); ++i) {
        check_range(entry, (*values)[i], -most, most);
        triple[i] = (*values)[i];
    }
    return triple;
}

/// Refuses a key that means nothing in the plane.
void check_in_space(const TomlEntry& entry, const Reading& reading) {
    if (reading.dim != 3) refuse(entry, "is a key of scenes in space; drop it, or write dim = 3");
}

Triple axis(const TomlEntry& entry, const Reading& reading) {
    check_in_space(entry, reading);
    Triple along = vector(entry, reading, most_metres);
    const double length =
        std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    constexpr double least_length = 1e-6;
    if (length < least_length) refuse(entry, "must not be [0, 0, 0]; it says what to turn about");
    for (double& part : along) part /= length;
    return along;
}

Triple spin(const TomlEntry& entry, const Reading& reading) {
    if (reading.dim == 3) return vector(entry, reading, most_speed);
    return {0, 0, number(entry, -most_speed, most_speed)};
}

template <class Choice>
Choice choice(const TomlEntry& entry) {
    const std::string name = text(entry);
    const std::optional<Choice> found = lod::named<Choice>(name);
    const auto names = names_of(Choice{});
    if (!found)
        refuse(entry,
               "must be one of " + listed(names) + ", not " + name + did_you_mean(name, names));
    return *found;
}

/// Level, node tests and milliseconds exclude each other.
void check_only_limit(const TomlEntry& entry, const Scene& scene) {
    const Limits& limits = scene.limits;
    if (limits.level || limits.node_tests || limits.milliseconds)
        refuse(entry, "is a second limit; keep one of level, node_tests and milliseconds");
}

std::vector<TomlTable> tables(const TomlEntry& entry, const char* example) {
    const auto* all = std::get_if<std::vector<TomlTable>>(&entry.value);
    if (!all) refuse(entry, std::string("must be a table; write ") + example);
    return *all;
}

void read_bodies(const TomlEntry& entry, Reading& reading) {
    if (!entry.is_array) refuse(entry, "must be a list; write [[body]], with two brackets");
    reading.bodies = tables(entry, "[[body]]");
    if (reading.bodies.size() > most_bodies)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         entry.where + ": " + std::to_string(reading.bodies.size()) +
                             " bodies, the limit is " + std::to_string(most_bodies) +
                             "; use fewer");
}

void read_camera(const TomlEntry& entry, Reading& reading) {
    if (entry.is_array) refuse(entry, "must be one table; write [camera], with one bracket");
    reading.cameras = tables(entry, "[camera]");
}

constexpr double radians(double degrees) {
    return degrees * (std::numbers::pi / 180);
}

/// Both bounds are the builders' own; they check what a builder can do with them.
constexpr int least_branching = 2;
constexpr int most_branching = 64;
constexpr int most_depth = 12;
constexpr int most_level = 1000;

// clang-format off
using E = TomlEntry;
const Key<Scene> scene_table[] = {
    {"name", "", "the file's name", [](const E& e, Scene& s, Reading&) { s.name = text(e); }},
    {"title", "", "none", [](const E& e, Scene& s, Reading&) { s.title = text(e); }},
    {"dim", "", "2", [](const E& e, Scene& s, Reading&) { s.dim = read_dim(e); }},
    {"time_step", "s", "1/240", [](const E& e, Scene& s, Reading&) { s.time_step = number(e, least_step, 1); }},
    {"duration", "s", "2", [](const E& e, Scene& s, Reading&) { s.duration = number(e, least_step, longest); }},
    {"level", "", "the leaves", [](const E& e, Scene& s, Reading&) { check_only_limit(e, s); s.limits.level = integer(e, 0, most_level); }},
    {"node_tests", "tests a frame", "no limit", [](const E& e, Scene& s, Reading&) { check_only_limit(e, s); s.limits.node_tests = static_cast<std::uint64_t>(integer(e, 0, 2'000'000'000)); }},
    {"milliseconds", "ms a frame", "no limit", [](const E& e, Scene& s, Reading&) { check_only_limit(e, s); s.limits.milliseconds = number(e, 0, 1e6); }},
    {"response", "", "net", [](const E& e, Scene& s, Reading&) { s.response = choice<lod::Response>(e); }},
    {"contact_model", "", "hull", [](const E& e, Scene& s, Reading&) { s.contact_model = choice<lod::ContactModel>(e); }},
    {"point_model", "", "radius_ratio", [](const E& e, Scene& s, Reading&) { s.point_model = choice<lod::PointModel>(e); }},
    {"priority", "", "closing_speed", [](const E& e, Scene& s, Reading&) { s.priority = choice<lod::Priority>(e); }},
    {"organisation", "", "interleaved", [](const E& e, Scene& s, Reading&) { s.organisation = choice<lod::Organisation>(e); }},
    {"fixation", "m", "the origin", [](const E& e, Scene& s, Reading& r) { s.viewer.fixation = vector(e, r, most_metres); }},
    {"eye", "m", "10 m before it", [](const E& e, Scene& s, Reading& r) { check_in_space(e, r); s.viewer.eye = vector(e, r, most_metres); }},
    {"finest", "", "leaves", [](const E& e, Scene& s, Reading&) { s.finest.level = choice<lod::Finest>(e); }},
    {"finest_pairs", "pairs a frame", "8", [](const E& e, Scene& s, Reading&) { s.finest.most_pairs = integer(e, 0, 1'000'000); }},
    {"sweep", "", "true with finest", [](const E& e, Scene& s, Reading&) { s.sweep = truth(e); }},
    {"restitution", "", "1", [](const E& e, Scene&, Reading& r) { r.defaults.restitution = number(e, 0, 1); }},
    {"density", "kg/m^2, kg/m^3", "1", [](const E& e, Scene&, Reading& r) { r.defaults.density = mass(e); }},
    {"builder", "", "the best one", [](const E& e, Scene&, Reading& r) { r.defaults.builder = text(e); }},
    {"branching", "children", "the builder's", [](const E& e, Scene&, Reading& r) { r.defaults.branching = integer(e, least_branching, most_branching); }},
    {"depth", "levels", "the builder's", [](const E& e, Scene&, Reading& r) { r.defaults.depth = integer(e, 0, most_depth); }},
    {"camera", "", "all that moves", [](const E& e, Scene&, Reading& r) { read_camera(e, r); }},
    {"body", "", "required", [](const E& e, Scene&, Reading& r) { read_bodies(e, r); }},
};

const Key<BodySpec> body_table[] = {
    {"name", "", "body N", [](const E& e, BodySpec& b, Reading&) { b.name = text(e); }},
    {"shape", "", "required", [](const E& e, BodySpec& b, Reading&) { b.shape = text(e); }},
    {"size", "m", "see there", [](const E& e, BodySpec& b, Reading&) { b.size = number(e, 1e-6, most_metres); }},
    {"sha256", "", "any file", [](const E& e, BodySpec& b, Reading&) { b.sha256 = text(e); check_digest(e, b.sha256); }},
    {"fill", "", "false", [](const E& e, BodySpec& b, Reading& r) { check_in_space(e, r); b.fill = truth(e); }},
    {"strokes", "", "false", [](const E& e, BodySpec& b, Reading&) { b.strokes = truth(e); }},
    {"page", "", "false", [](const E& e, BodySpec& b, Reading&) { b.page = truth(e); }},
    {"strict", "", "false", [](const E& e, BodySpec& b, Reading&) { b.strict = truth(e); }},
    {"density", "kg/m^2, kg/m^3", "the scene's", [](const E& e, BodySpec& b, Reading&) { b.density = mass(e); }},
    {"mass", "kg", "density x measure", [](const E& e, BodySpec& b, Reading&) { b.mass = mass(e); }},
    {"static", "", "false", [](const E& e, BodySpec& b, Reading&) { b.is_static = truth(e); }},
    {"position", "m", "the origin", [](const E& e, BodySpec& b, Reading& r) { b.position = vector(e, r, most_metres); }},
    {"axis", "", "[0, 0, 1]", [](const E& e, BodySpec& b, Reading& r) { b.axis = axis(e, r); }},
    {"angle", "degrees", "0", [](const E& e, BodySpec& b, Reading&) { b.angle = radians(number(e, -most_degrees, most_degrees)); }},
    {"velocity", "m/s", "at rest", [](const E& e, BodySpec& b, Reading& r) { b.velocity = vector(e, r, most_speed); }},
    {"spin", "rad/s", "none", [](const E& e, BodySpec& b, Reading& r) { b.spin = spin(e, r); }},
    {"restitution", "", "the scene's", [](const E& e, BodySpec& b, Reading&) { b.restitution = number(e, 0, 1); }},
    {"builder", "", "the scene's", [](const E& e, BodySpec& b, Reading&) { b.builder = text(e); }},
    {"branching", "children", "the scene's", [](const E& e, BodySpec& b, Reading&) { b.branching = integer(e, least_branching, most_branching); }},
    {"depth", "levels", "the scene's", [](const E& e, BodySpec& b, Reading&) { b.depth = integer(e, 0, most_depth); }},
};

const Key<Camera> camera_table[] = {
    {"centre", "m", "the origin", [](const E& e, Camera& c, Reading& r) { c.centre = vector(e, r, most_metres); }},
    {"width", "m", "required", [](const E& e, Camera& c, Reading&) { c.width = number(e, 1e-6, most_metres); }},
    {"azimuth", "degrees", "see there", [](const E& e, Camera& c, Reading& r) { check_in_space(e, r); c.azimuth = radians(number(e, -360, 360)); }},
    {"elevation", "degrees", "24", [](const E& e, Camera& c, Reading& r) { check_in_space(e, r); c.elevation = radians(number(e, -89, 89)); }},
    {"perspective", "", "false", [](const E& e, Camera& c, Reading& r) { check_in_space(e, r); c.perspective = truth(e); }},
};
// clang-format on

template <class Target>
void note(std::span<const Key<Target>> keys, const char* section, std::vector<KeyNote>& notes) {
    for (const Key<Target>& key : keys)
        notes.push_back(
            {section, std::string(key.name), std::string(key.unit), std::string(key.otherwise)});
}

}  // namespace

std::span<const Key<Scene>> scene_keys() {
    return scene_table;
}
std::span<const Key<BodySpec>> body_keys() {
    return body_table;
}
std::span<const Key<Camera>> camera_keys() {
    return camera_table;
}

int read_dim(const TomlEntry& entry) {
    return integer(entry, 2, 3);
}

std::vector<KeyNote> key_notes() {
    std::vector<KeyNote> notes;
    note(scene_keys(), "scene", notes);
    note(body_keys(), "body", notes);
    note(camera_keys(), "camera", notes);
    return notes;
}

}  // namespace scenes
