#include "lodlab/live/stage.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"

namespace live {
namespace {

constexpr double hits_seen = 1.0 / 3;  ///< [s] that an impulse stays to be seen
constexpr double furthest = 1e6;       ///< [m] that a body may be put from the origin
constexpr std::size_t most_gaps = 24;  ///< pairs whose true distance is asked
constexpr int most_frames = 100'000;   ///< at once

double gap_of(const lod::Body<2>& a, const lod::Body<2>& b) {
    if (!a.exact || !b.exact) return -1;
    return lod::exactly_overlap<2>(a, b) ? 0 : lod::separation<2>(a, b).distance;
}

[[noreturn]] void refuse(const std::string& what) {
    throw lod::Error(lod::ErrorKind::usage, what);
}

}  // namespace

Stage::Stage(Scene scene) : scene_(std::move(scene)) {
    reset();
}

viz::Actor<2> Stage::actor(std::size_t body) const {
    return {scene_.actors[body].visual, bodies_[body]};
}

double Stage::time() const {
    return static_cast<double>(frame_) * scene_.settings.time_step;
}

std::uint64_t Stage::state_hash() const {
    return lod::state_hash<2>(bodies_);
}

lod::Budget Stage::budget() const {
    return scene_.budget ? lod::Budget::node_tests(*scene_.budget, scene_.pair_cost)
                         : lod::Budget::unlimited();
}

void Stage::step(int frames) {
    if (frames < 0 || frames > most_frames)
        refuse("a step is of 0 to " + std::to_string(most_frames) + " frames");
    const auto kept = static_cast<std::int64_t>(hits_seen / scene_.settings.time_step);
    for (int i = 0; i < frames; ++i) {
        lod::Budget budget = this->budget();
        const lod::FrameRecord<2>& record =
            lod::advance<2>(bodies_, scene_.settings, budget, running_);
        for (std::size_t c = 0; c < record.impacts.size(); ++c)
            if (record.impulses[c] > 0)
                hits_.push_back({frame_, record.impacts[c].contact, record.impulses[c]});
        for (const lod::SweptImpact<2>& swept : record.swept)
            if (swept.impulse > 0) hits_.push_back({frame_, swept.contact, swept.impulse});
        ++frame_;
        std::erase_if(hits_, [&](const Hit& hit) { return hit.frame < frame_ - kept; });
    }
    look();
}

void Stage::reset() {
    bodies_.clear();
    for (const viz::Actor<2>& actor : scene_.actors) bodies_.push_back(actor.body);
    frame_ = 0;
    hits_.clear();
    running_ = {};
    look();
}

void Stage::look() {
    apart_.reset();
    event_.reset();
    lod::Budget budget = this->budget();
    looking_.scheduler.trade = running_.scheduler.trade;
    const lod::FrameRecord<2>& record = lod::detect<2>(bodies_, scene_.settings, budget, looking_);
    pairs_.clear();
    std::size_t gaps = 0;
    for (const lod::PairRecord& pair : record.pairs) {
        const lod::Body<2>& a = bodies_[lod::at(pair.bodies.a)];
        const lod::Body<2>& b = bodies_[lod::at(pair.bodies.b)];
        NearPair near{pair, lod::traverse_levels<2>(a, b, pair.level), -1, 0};
        near.stands_out = a.tree->error_at(pair.level) + b.tree->error_at(pair.level);
        if (pair.verdict != lod::Verdict::apart && gaps++ < most_gaps) near.gap = gap_of(a, b);
        pairs_.push_back(std::move(near));
    }
}

const FrameApart& Stage::apart() {
    if (apart_) return *apart_;
    FrameApart apart;
    std::vector<lod::Body<2>> bodies = bodies_;
    apart.step.before = scenes::states_of<2>(bodies_);
    lod::FrameStorage<2> storage;
    storage.scheduler.trade = running_.scheduler.trade;
    lod::Budget budget = this->budget();
    apart.step.record = lod::advance<2>(bodies, scene_.settings, budget, storage);
    apart.step.state_hash = lod::state_hash<2>(bodies);
    apart.events = scenes::events_of<2>(apart.step, bodies_, scene_.settings);
    if (scene_.told == Told::verdicts)
        std::erase_if(apart.events, [](const scenes::Event<2>& event) {
            return event.kind > scenes::EventKind::exact;
        });
    apart_ = std::move(apart);
    return *apart_;
}

void Stage::look_inside(std::optional<std::size_t> event) {
    if (event && *event >= apart().events.size())
        refuse("this frame has " + scenes::kinds_text<2>(apart().events) +
               ", and nothing of the number " + std::to_string(*event));
    event_ = event;
}

std::vector<std::string> Stage::names() const {
    std::vector<viz::Visual<2>> visuals;
    for (const viz::Actor<2>& actor : scene_.actors) visuals.push_back(actor.visual);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < visuals.size(); ++i) names.push_back(viz::shown_name(visuals, i));
    return names;
}

lod::Body<2>& Stage::body_at(std::size_t body) {
    if (body >= bodies_.size()) refuse("there is no body " + std::to_string(body));
    return bodies_[body];
}

void Stage::place(std::size_t body, const lod::Vector<2>& position, double angle) {
    lod::Body<2>& moved = body_at(body);
    if (!(position.norm() <= furthest && std::abs(angle) <= furthest))
        refuse("a body cannot be put there");
    if (moved.tree->is_half_space()) return;
    moved.position = position;
    moved.orientation = angle;
    hits_.clear();
    look();
}

void Stage::move(std::size_t body, const lod::Vector<2>& velocity, double spin) {
    lod::Body<2>& moved = body_at(body);
    if (!(velocity.norm() <= furthest && std::abs(spin) <= furthest))
        refuse("a body cannot move like that");
    if (moved.is_static()) return;
    moved.velocity = velocity;
    moved.spin[0] = spin;
    look();
}

void Stage::set_level(int deepest) {
    if (deepest < 0) refuse("a level is at least 0");
    scene_.settings.deepest_level = deepest;
    look();
}

void Stage::set_budget(std::optional<std::uint64_t> tests) {
    scene_.budget = tests;
    look();
}

void Stage::set_pair_cost(double tests) {
    if (!(tests >= 0 && tests <= furthest)) refuse("a node pair costs at least 0 node tests");
    scene_.pair_cost = tests;
    look();
}

void Stage::set_restitution(double restitution) {
    if (!(restitution >= 0 && restitution <= 1)) refuse("a restitution is within 0 to 1");
    for (viz::Actor<2>& actor : scene_.actors) actor.body.restitution = restitution;
    for (lod::Body<2>& body : bodies_) body.restitution = restitution;
    look();
}

void Stage::set_policy(lod::Priority priority) {
    scene_.settings.priority = priority;
    look();
}

void Stage::set_contact_model(lod::ContactModel model) {
    scene_.settings.contact_model = model;
    look();
}

void Stage::set_response(lod::Response response) {
    scene_.settings.response = response;
    look();
}

void Stage::set_fixation(const lod::Vector<2>& point) {
    if (!(point.norm() <= furthest)) refuse("nobody can look there");
    scene_.settings.viewer.fixation = {point.x(), point.y(), 0};
    look();
}

}  // namespace live
