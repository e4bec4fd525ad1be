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
    std::uint64_t frames_run = 0;  ///< to get there
    std::vector<scenes::Event<Dim>> events;
    std::optional<std::size_t> event;  ///< that was asked for

    [[nodiscard]] const std::string& name(std::int32_t body) const {
        return setup.scene.bodies[lod::at(body)].name;
    }
    [[nodiscard]] double time() const {
        return static_cast<double>(player.frame()) * player.trace().head().settings.time_step;
    }
};

/// FRAME[.EVENT], two whole numbers.
struct Place {
    std::int64_t frame = 0;
    std::optional<std::size_t> event;
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
    const std::size_t point = text.find('.');
    Place place{whole_in<std::int64_t>(std::string_view(text).substr(0, point)), {}};
    if (point != std::string::npos)
        place.event = whole_in<std::size_t>(std::string_view(text).substr(point + 1));
    return place;
}

/// What happened, as a sentence without its full stop.
template <int Dim>
std::string sentence(const Moment<Dim>& moment, const scenes::Event<Dim>& event) {
    const std::string& a = moment.name(event.a);
    const std::string& b = moment.name(event.b);
    const auto where = [&] {
        return " at " + in_brackets(event.contact.point) + " m along " +
               in_brackets(event.contact.normal);
    };
    switch (event.kind) {
        case scenes::EventKind::level:
            return "level " + std::to_string(event.level) + " of " + a + " and " + b + ": " +
                   std::to_string(event.overlapping) + " node pairs overlap, " +
                   std::to_string(event.tests) + " tested";
        case scenes::EventKind::exact:
            return "the true shapes of " + a + " and " + b +
                   (event.overlapping == 0
                        ? std::string(" are apart")
                        : " touch in " + std::to_string(event.overlapping) + " contacts at " +
                              readable(event.time) + " s from the frame");
        case scenes::EventKind::contact:
            return a + " and " + b + " touch" + where() + ", " + readable(event.contact.depth) +
                   " m deep";
        case scenes::EventKind::impulse:
            return a + " pushes " + b + " by " + readable(event.impulse) + " N s" + where();
        case scenes::EventKind::swept:
            break;
    }
    return a + " runs into " + b + " " + readable(event.time) +
           " s after the frame, and pushes by " + readable(event.impulse) + " N s" + where();
}

template <int Dim>
Json json_of(const Moment<Dim>& moment, const scenes::Event<Dim>& event) {
    Json json = {{"kind", lod::name_of(event.kind)},
                 {"a", moment.name(event.a)},
                 {"b", moment.name(event.b)}};
    using Kind = scenes::EventKind;
    if (event.kind == Kind::level) {
        json["level"] = event.level;
        json["tests"] = event.tests;
        json["overlapping"] = event.overlapping;
    } else if (event.kind == Kind::exact) {
        json["contacts"] = event.overlapping;
        json["time"] = event.time;
    } else {
        json["point"] = list_of(event.contact.point);
        json["normal"] = list_of(event.contact.normal);
        json["depth"] = event.contact.depth;
        if (event.kind != Kind::contact) json["impulse"] = event.impulse;
        if (event.kind == Kind::swept) json["time"] = event.time;
    }
    json["sentence"] = sentence(moment, event);
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
    if (moment.event)
        return text + "  event " + std::to_string(*moment.event) + ": " +
               sentence(moment, moment.events[*moment.event]) + "\n";
    for (std::size_t i = 0; i < std::min(moment.events.size(), most_lines); ++i)
        text += "  event " + std::to_string(i) + ": " + sentence(moment, moment.events[i]) + "\n";
    if (moment.events.size() > most_lines)
        text += "  " + std::to_string(moment.events.size() - most_lines) + more;
    return text;
}

template <int Dim>
void check_event(const Moment<Dim>& moment) {
    const std::size_t count = moment.events.size();
    if (!moment.event || *moment.event < count) return;
    const std::string frame = "frame " + std::to_string(moment.player.frame());
    if (count == 0)
        misused("nothing happens in " + frame + "; drop ." + std::to_string(*moment.event));
    misused(frame + " has the events 0 to " + std::to_string(count - 1) + "; seek one of them");
}

/// What an event is, over the picture of its frame.
template <int Dim>
void add_event(const Moment<Dim>& moment, const scenes::Event<Dim>& event, viz::Panel& panel) {
    const std::vector<lod::Body<Dim>> bodies(moment.player.bodies().begin(),
                                             moment.player.bodies().end());
    const lod::Body<Dim>& a = bodies[lod::at(event.a)];
    const lod::Body<Dim>& b = bodies[lod::at(event.b)];
    if (event.kind == scenes::EventKind::level) {
        const std::vector<lod::Front> fronts = lod::traverse_levels(a, b, event.level);
        viz::add_meeting_nodes<Dim>(panel, {a, 0}, {b, 1}, fronts.back().pairs);
        return;
    }
    if (event.kind == scenes::EventKind::exact) return;
    const double length = arrow_share * viz::longer_side(panel.view);
    const std::vector<lod::Contact<Dim>> contacts{event.contact};
    const bool pushes = event.kind != scenes::EventKind::contact;
    viz::add_contact_points<Dim>(panel, contacts);
    viz::add_arrow<Dim>(panel, {.role = pushes ? viz::Role::impulse : viz::Role::normal},
                        event.contact.point, event.contact.point + length * event.contact.normal,
                        pushes ? readable(event.impulse, 3) + "\u00A0N\u00A0s" : std::string());
}

/// The frame as `simulate --quota` films it, and in it the event that was asked for.
template <int Dim>
viz::Figure figure_of(const Moment<Dim>& moment, const scenes::Step<Dim>* step) {
    const scenes::TraceHead& head = moment.player.trace().head();
    scenes::Run<Dim> run;
    run.settings = head.settings;
    run.end = scenes::states_of(moment.player.bodies());
    if (step != nullptr) run.steps.push_back(*step);
    viz::Run<Dim> shown = seen(moment.setup, run, "");
    shown.instants.resize(1);
    viz::CrowdChoice choice = crowd_choice(head.settings, head.limits);
    choice.first_frame = moment.player.frame();
    choice.frames = moment.player.frames();
    if (step == nullptr) {
        choice.quota = {};
        choice.title = "After the last frame, " + std::to_string(moment.player.frames());
    }
    if (moment.event) {
        std::string words = sentence(moment, moment.events[*moment.event]);
        words.resize(std::min(words.size(), words.find(" at (")));  // the picture shows where
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
    Moment<Dim> moment{setup, player, player.frames_run(), {}, place.event};
    const scenes::Step<Dim>* step = place.frame < trace.frames() ? &player.step() : nullptr;
    if (step != nullptr) moment.events = scenes::events_of<Dim>(*step, setup.bodies);
    check_event(moment);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(moment, step); };
    write_outputs(options, drawing);
    if (options.json)
        print(result_of(moment));
    else
        print(report_of(moment));
}

template void show_moment(const scenes::Setup<2>&, const Options&, const scenes::Trace&);
template void show_moment(const scenes::Setup<3>&, const Options&, const scenes::Trace&);

}  // namespace cli
