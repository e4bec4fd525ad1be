#include "cli/stage/moment.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/arguments/misused.hpp"
#include "cli/stage/run_pictures.hpp"
#include "cli/terminal/numbers.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/scenes/trace/events.hpp"
#include "lodlab/scenes/trace/trace_player.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_lines = 20;  // of bodies, and of events, for readers
constexpr double arrow_share = 0.06;    // of the picture

/// A frame of a trace, and what happens in it.
template <int Dim>
struct Moment {
    const scenes::Setup<Dim>& setup;
    const scenes::TracePlayer<Dim>& player;
    std::uint64_t frames_run = 0;             ///< to get there
    const scenes::Step<Dim>* step = nullptr;  ///< none at the end
    std::vector<std::string> names{};         ///< of the bodies
    std::vector<scenes::Event<Dim>> events{};
    std::optional<std::size_t> event{};  ///< that was asked for

    [[nodiscard]] double time() const {
        return static_cast<double>(player.frame()) * player.trace().head().settings.time_step;
    }
};

/// FRAME[.EVENT], an event by its number, or by its kind and which of that kind.
struct Place {
    std::int64_t frame = 0;
    std::string event;
};

template <class Whole>
Whole whole_in(std::string_view digits) {
    Whole number{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size())
        misused("--seek " + std::string(digits) + " is beyond every trace; name a frame of this");
    return number;
}

Place place_in(const std::string& text) {
    const std::size_t point = std::min(text.find('.'), text.size());
    return {whole_in<std::int64_t>(std::string_view(text).substr(0, point)),
            text.substr(std::min(point + 1, text.size()))};
}

template <int Dim>
[[noreturn]] void refuse_event(const Moment<Dim>& moment, const std::string& asked) {
    const std::string frame = "frame " + std::to_string(moment.player.frame());
    if (moment.events.empty()) misused("nothing happens in " + frame + "; drop ." + asked);
    misused(frame + " has no event " + asked + ": it has the events 0 to " +
            std::to_string(moment.events.size() - 1) + ", " +
            scenes::kinds_text<Dim>(moment.events) + "; seek one of them");
}

/// The event that was asked for, as a place in the list.
template <int Dim>
std::size_t place_of(const Moment<Dim>& moment, const std::string& asked) {
    const std::size_t colon = std::min(asked.find(':'), asked.size());
    const bool by_number = asked.find_first_not_of("0123456789") == std::string::npos;
    const auto nth = colon < asked.size()
                         ? whole_in<std::uint64_t>(std::string_view(asked).substr(colon + 1))
                         : 1;
    const auto kind = by_number
                          ? scenes::EventKind{}
                          : lod::chosen<scenes::EventKind>(asked.substr(0, colon), "kind of event");
    const std::uint64_t number = by_number ? whole_in<std::uint64_t>(asked) : 0;
    for (std::size_t i = 0; i < moment.events.size(); ++i) {
        const scenes::Event<Dim>& event = moment.events[i];
        if (by_number ? i == number
                      : event.kind == kind && static_cast<std::uint64_t>(event.nth) == nth)
            return i;
    }
    refuse_event(moment, asked);
}

/// "event 3, contact:1: A and B touch ...".
template <int Dim>
std::string told(const Moment<Dim>& moment, std::size_t place) {
    const scenes::Event<Dim>& event = moment.events[place];
    return "event " + std::to_string(place) + ", " + scenes::event_name(event) + ": " +
           scenes::sentence<Dim>(event, moment.names);
}

/// Of a level that was finished, or was not.
template <int Dim>
void add_level(const scenes::Event<Dim>& event, Json& json) {
    json["level"] = event.level;
    if (event.kind != scenes::EventKind::skipped) json["tests"] = event.tests;
    if (event.kind == scenes::EventKind::level)
        json["overlapping"] = event.overlapping;
    else
        json["needed"] = event.needed;
}

template <int Dim>
Json json_of(const Moment<Dim>& moment, const scenes::Event<Dim>& event) {
    using Kind = scenes::EventKind;
    Json json = {{"name", scenes::event_name(event)},
                 {"kind", lod::name_of(event.kind)},
                 {"a", moment.names[lod::at(event.a)]},
                 {"b", moment.names[lod::at(event.b)]}};
    if (event.kind <= Kind::skipped) {
        add_level(event, json);
    } else if (event.kind == Kind::exact) {
        json["contacts"] = event.overlapping;
        json["time"] = event.time;
    } else {
        if (event.kind == Kind::round) {
            json["round"] = event.round;
            json["rounds"] = event.rounds;
            json["contacts"] = event.overlapping;
        }
        json["point"] = list_of(event.contact.point);
        json["normal"] = list_of(event.contact.normal);
        json["depth"] = event.contact.depth;
        if (event.kind != Kind::contact) json["impulse"] = event.impulse;
        if (event.kind == Kind::swept) json["time"] = event.time;
    }
    json["sentence"] = scenes::sentence<Dim>(event, moment.names);
    return json;
}

Json turn_of(double angle) {
    return angle;
}
Json turn_of(const lod::Quaternion& q) {
    return list_of(q.coeffs());
}
std::string turned_by(double angle) {
    return readable(angle * 180 / std::numbers::pi) + " degrees";
}
std::string turned_by(const lod::Quaternion& q) {
    return in_brackets(q.coeffs());
}

template <int Dim>
Json result_of(const Moment<Dim>& moment) {
    Json bodies = Json::array();
    for (std::size_t i = 0; i < moment.player.bodies().size(); ++i) {
        const lod::Body<Dim>& body = moment.player.bodies()[i];
        bodies.push_back({{"name", moment.setup.scene.bodies[i].name},
                          {"position", list_of(body.position)},
                          {"orientation", turn_of(body.orientation)},
                          {"velocity", list_of(body.velocity)},
                          {"spin", list_of(body.spin)}});
    }
    Json events = Json::array();
    for (const scenes::Event<Dim>& event : moment.events) events.push_back(json_of(moment, event));
    return {{"dim", Dim},
            {"frame", moment.player.frame()},
            {"frames", moment.player.frames()},
            {"time", moment.time()},
            {"state_hash", scenes::hexadecimal(moment.player.state_hash())},
            {"frames_run", moment.frames_run},
            {"event", moment.event ? Json(*moment.event) : Json()},
            {"events", std::move(events)},
            {"bodies", std::move(bodies)}};
}

/// An event, and those before and after it.
template <int Dim>
std::string around(const Moment<Dim>& moment, std::size_t place) {
    const bool is_last = place + 1 == moment.events.size();
    return "  before it: " + (place == 0 ? "nothing" : told(moment, place - 1)) + "\n  " +
           told(moment, place) +
           "\n  after it: " + (is_last ? "nothing" : told(moment, place + 1)) + "\n";
}

template <int Dim>
std::string report_of(const Moment<Dim>& moment) {
    const std::string more = " more; --json lists all\n";
    std::string text = moment.setup.scene.name + ": frame " +
                       std::to_string(moment.player.frame()) + " of " +
                       std::to_string(moment.player.frames()) + ", " + readable(moment.time()) +
                       " s\n  state hash " + scenes::hexadecimal(moment.player.state_hash()) + "\n";
    const auto bodies = moment.player.bodies();
    for (std::size_t i = 0; i < std::min(bodies.size(), most_lines); ++i)
        text += "  " + moment.setup.scene.bodies[i].name + " is at " +
                in_brackets(bodies[i].position) + " m, turned by " +
                turned_by(bodies[i].orientation) + ", moves by " + in_brackets(bodies[i].velocity) +
                " m/s, turns by " + in_brackets(bodies[i].spin) + " rad/s\n";
    if (bodies.size() > most_lines)
        text += "  " + std::to_string(bodies.size() - most_lines) + more;
    if (moment.event) return text + around(moment, *moment.event);
    for (std::size_t i = 0; i < std::min(moment.events.size(), most_lines); ++i)
        text += "  " + told(moment, i) + "\n";
    if (moment.events.size() > most_lines)
        text += "  " + std::to_string(moment.events.size() - most_lines) + more;
    return text;
}

/// The nodes of a level that was finished, begun, or not begun: then those that wait.
template <int Dim>
void add_level(const Moment<Dim>& moment, const scenes::Event<Dim>& event, viz::Panel& panel) {
    const lod::Body<Dim>& a = moment.player.bodies()[lod::at(event.a)];
    const lod::Body<Dim>& b = moment.player.bodies()[lod::at(event.b)];
    const bool is_whole = event.kind == scenes::EventKind::level;
    const lod::Front front =
        lod::traverse_levels(a, b, is_whole ? event.level : event.level - 1).back();
    if (!is_whole) {
        const viz::TestedNodes lost = viz::tested_nodes<Dim>(a, b, front, event.tests);
        viz::add_nodes<Dim>(panel, a, lost.a, viz::Role::dropped_node, 0);
        viz::add_nodes<Dim>(panel, b, lost.b, viz::Role::dropped_node, 1);
    }
    viz::add_meeting_nodes<Dim>(panel, {a, 0}, {b, 1}, front.pairs);
}

/// The contacts that push in a round, the hardest with its impulse.
template <int Dim>
void add_round(const Moment<Dim>& moment, const scenes::Event<Dim>& event, viz::Panel& panel) {
    const double length = arrow_share * viz::longer_side(panel.view);
    const auto& impacts = moment.step->record.impacts;
    for (std::size_t i = 0; i < event.pushes.size(); ++i) {
        if (event.pushes[i] <= 0) continue;
        const lod::Contact<Dim>& contact = impacts[i].contact;
        const bool is_hardest = event.pushes[i] == event.impulse;
        viz::add_arrow<Dim>(
            panel, {.role = viz::Role::impulse}, contact.point,
            contact.point + length * event.pushes[i] / event.impulse * contact.normal,
            is_hardest ? readable(event.impulse, 3) + "\u00A0N\u00A0s" : std::string());
    }
}

/// What an event is, over the picture of its frame.
template <int Dim>
void add_event(const Moment<Dim>& moment, const scenes::Event<Dim>& event, viz::Panel& panel) {
    using Kind = scenes::EventKind;
    if (event.kind <= Kind::skipped) return add_level(moment, event, panel);
    if (event.kind == Kind::exact) return;
    if (event.kind == Kind::round) return add_round(moment, event, panel);
    const double length = arrow_share * viz::longer_side(panel.view);
    const std::vector<lod::Contact<Dim>> contacts{event.contact};
    const bool pushes = event.kind != Kind::contact;
    viz::add_contact_points<Dim>(panel, contacts);
    viz::add_arrow<Dim>(panel, {.role = pushes ? viz::Role::impulse : viz::Role::normal},
                        event.contact.point, event.contact.point + length * event.contact.normal,
                        pushes ? readable(event.impulse, 3) + "\u00A0N\u00A0s" : std::string());
}

/// The frame as `simulate --quota` films it, and in it the event that was asked for.
template <int Dim>
viz::Figure figure_of(const Moment<Dim>& moment) {
    const scenes::TraceHead& head = moment.player.trace().head();
    scenes::Run<Dim> run;
    run.settings = head.settings;
    run.end = scenes::states_of(moment.player.bodies());
    if (moment.step != nullptr) run.steps.push_back(*moment.step);
    viz::Run<Dim> shown = seen(moment.setup, run, "");
    shown.instants.resize(1);
    viz::CrowdChoice choice = crowd_choice(head.settings, head.limits);
    choice.first_frame = moment.player.frame();
    choice.frames = moment.player.frames();
    if (moment.step == nullptr) {
        choice.quota = {};
        choice.title = "After the last frame, " + std::to_string(moment.player.frames());
    }
    if (moment.event) {
        std::string words = scenes::sentence<Dim>(moment.events[*moment.event], moment.names,
                                                  scenes::Places::left_out);
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
        choice.title = viz::literal_text(words);
    }
    viz::Figure figure =
        viz::crowd_picture<Dim>(shown, 0, choice, viewpoint_of<Dim>(moment.setup.scene));
    if (moment.event) add_event(moment, moment.events[*moment.event], figure.panels[0]);
    return framed<Dim>(std::move(figure), moment.setup.scene);
}

}  // namespace

template <int Dim>
void show_moment(const scenes::Setup<Dim>& setup, const Options& options,
                 const scenes::Trace& trace) {
    const Place place = place_in(options.seek);
    if (place.frame > trace.frames())
        misused("the trace has the frames 0 to " + std::to_string(trace.frames() - 1) + ", and " +
                std::to_string(trace.frames()) + " is its end; seek one of them");
    scenes::TracePlayer<Dim> player(trace, setup.bodies);
    player.seek(place.frame);
    Moment<Dim> moment{setup, player, player.frames_run()};
    for (const scenes::BodySpec& body : setup.scene.bodies) moment.names.push_back(body.name);
    if (place.frame < trace.frames()) {
        moment.step = &player.step();
        moment.events = scenes::events_of<Dim>(*moment.step, setup.bodies, trace.head().settings);
    }
    if (!place.event.empty()) moment.event = place_of(moment, place.event);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(moment); };
    write_outputs(options, drawing);
    if (options.json)
        print(result_of(moment));
    else
        print(report_of(moment));
}

template void show_moment(const scenes::Setup<2>&, const Options&, const scenes::Trace&);
template void show_moment(const scenes::Setup<3>&, const Options&, const scenes::Trace&);

}  // namespace cli
