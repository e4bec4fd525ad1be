#include "lodlab/live/module.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/live/choices.hpp"
#include "lodlab/live/outline.hpp"
#include "lodlab/live/picture.hpp"
#include "lodlab/live/sources.hpp"
#include "lodlab/viz/figure/json.hpp"

struct lodlab_live {
    live::Stage stage;
    std::string text;
};

namespace {

constexpr double largest_whole = 1e15;

std::string& last_error() {
    static std::string error;
    return error;
}

/// Does something and gives 0; where it throws, -1, and keeps what was said.
template <class Work>
int tried(const Work& work) {
    last_error().clear();
    try {
        work();
        return 0;
    } catch (const std::exception& error) {
        last_error() = error.what();
        return -1;
    }
}

template <class Text>
const char* told(lodlab_live* live, const Text& text) {
    return tried([&] { live->text = text(live->stage); }) == 0 ? live->text.c_str() : nullptr;
}

double whole(double value) {
    if (!(std::abs(value) < largest_whole) || value != std::floor(value))
        throw lod::Error(lod::ErrorKind::usage, "this must be a whole number");
    return value;
}

void set(live::Stage& stage, const std::string& what, double value) {
    if (what == "level") return stage.set_level(static_cast<int>(std::min(whole(value), 1000.0)));
    if (what == "budget")
        return whole(value) < 0 ? stage.set_budget({})
                                : stage.set_budget(static_cast<std::uint64_t>(value));
    if (what == "pair_cost") return stage.set_pair_cost(value);
    if (what == "restitution") return stage.set_restitution(value);
    if (what == "event")
        return stage.look_inside(whole(value) < 0 ? std::nullopt
                                                  : std::optional(static_cast<std::size_t>(value)));
    throw lod::Error(lod::ErrorKind::usage, "a stage has no " + what);
}

/// A stage, or null where its scene is refused.
template <class Make>
lodlab_live* opened(const Make& make) {
    lodlab_live* live = nullptr;
    static_cast<void>(tried([&] { live = new lodlab_live{live::Stage(make()), {}}; }));
    return live;
}

}  // namespace

lodlab_live* lodlab_live_open(const char* scene) {
    return opened([&] { return live::scene_from(scene); });
}

lodlab_live* lodlab_live_draw(const char* outlines) {
    return opened([&] { return live::scene_of_outlines(outlines); });
}

const char* lodlab_live_sources() {
    return live::sources();
}

void lodlab_live_close(lodlab_live* live) {
    delete live;
}

const char* lodlab_live_error() {
    return last_error().c_str();
}

const char* lodlab_live_figure(lodlab_live* live) {
    return told(live, [](const live::Stage& stage) {
        return viz::json_text(live::picture(stage), viz::Spacing::none);
    });
}

const char* lodlab_live_state(lodlab_live* live) {
    return told(live, live::report);
}

const char* lodlab_live_events(lodlab_live* live) {
    return told(live, live::events_report);
}

int lodlab_live_step(lodlab_live* live, int frames) {
    return tried([&] { live->stage.step(frames); });
}

int lodlab_live_reset(lodlab_live* live) {
    return tried([&] { live->stage.reset(); });
}

int lodlab_live_place(lodlab_live* live, int body, double x, double y, double angle) {
    return tried([&] { live->stage.place(static_cast<std::size_t>(body), {x, y}, angle); });
}

int lodlab_live_move(lodlab_live* live, int body, double x, double y, double spin) {
    return tried([&] { live->stage.move(static_cast<std::size_t>(body), {x, y}, spin); });
}

int lodlab_live_fixate(lodlab_live* live, double x, double y) {
    return tried([&] { live->stage.set_fixation({x, y}); });
}

int lodlab_live_set(lodlab_live* live, const char* what, double value) {
    return tried([&] { set(live->stage, what, value); });
}

int lodlab_live_choose(lodlab_live* live, const char* what, const char* name) {
    return tried([&] { live::stage_choice(what).choose(live->stage, name); });
}
