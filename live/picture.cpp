#include "lodlab/live/picture.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/live/parts.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace live {
namespace {

using namespace detail;

constexpr std::size_t few_bodies = 4;     ///< are named, and their velocities told
constexpr std::size_t most_lines = 48;    ///< between meeting nodes of a pair
constexpr double longest_velocity = 0.1;  ///< of the view's longer side

std::size_t moving_bodies(const Stage& stage) {
    const auto bodies = stage.bodies();
    return static_cast<std::size_t>(
        std::count_if(bodies.begin(), bodies.end(),
                      [](const lod::Body<2>& body) { return !body.tree->is_half_space(); }));
}

/// Whether a scene asks about one circle a body, and no more.
bool asks_circles_alone(const Stage& stage) {
    return stage.scene().told == Told::verdicts && stage.scene().settings.deepest_level == 0;
}

/// The nodes of a pair's last level. Of many bodies only what meets: the rest would hide it.
void add_pair(viz::Panel& panel, const Stage& stage, const NearPair& near, bool tested_too) {
    const viz::NumberedBody<2> a{stage.bodies()[lod::at(near.record.bodies.a)],
                                 near.record.bodies.a};
    const viz::NumberedBody<2> b{stage.bodies()[lod::at(near.record.bodies.b)],
                                 near.record.bodies.b};
    if (tested_too) {
        const viz::TestedNodes tested = viz::tested_nodes<2>(
            a.body, b.body, near.fronts, static_cast<int>(near.fronts.size()) - 1);
        viz::add_nodes<2>(panel, a.body, tested.a, tested_role(stage), a.number);
        viz::add_nodes<2>(panel, b.body, tested.b, tested_role(stage), b.number);
    }
    const auto meeting = stage.record().nodes_of(near.record.nodes);
    viz::add_meeting_nodes<2>(panel, a, b, meeting);
    if (moving_bodies(stage) <= few_bodies) add_lines(panel, a.body, b.body, meeting);
}

/// All nodes of a body's deepest level, or their hulls.
void add_level(viz::Panel& panel, const Stage& stage, std::size_t body) {
    const viz::Actor<2> actor = stage.actor(body);
    const lod::SphereTree<2>& tree = *actor.body.tree;
    if (tree.is_half_space()) return;
    const int number = static_cast<int>(body);
    const std::vector<int> nodes =
        tree.level_nodes(std::min(stage.scene().settings.deepest_level, tree.levels() - 1));
    if (stage.shown() != Shown::hulls || !tree.has_hulls())
        return viz::add_nodes<2>(panel, actor.body, nodes, viz::Role::level_node, number);
    const viz::Style style{.role = viz::Role::level_node, .body = number};
    for (const int node : nodes) {
        viz::Ring ring;
        for (const lod::Vector<2>& corner : tree.hulls.of(tree.hulls.best(node)).corners)
            ring.push_back(viz::carried(actor.body, viz::point_of(corner)));
        if (ring.size() > 2) panel.marks.push_back(viz::Path{style, {std::move(ring)}});
    }
}

void add_hits(viz::Panel& panel, const Stage& stage) {
    double most = 0;
    for (const Hit& hit : stage.hits()) most = std::max(most, hit.impulse);
    const double scale = longest_impulse * viz::longer_side(panel.view);
    for (const Hit& hit : stage.hits()) {
        const double age =
            static_cast<double>(stage.frame() - hit.frame) * stage.scene().settings.time_step * 3;
        const std::string words = stage.hits().size() <= told_impulses
                                      ? viz::quantity_text(hit.impulse, "N\u00A0s", 2)
                                      : "";
        viz::add_arrow<2>(
            panel, {.role = viz::Role::impulse, .opacity = std::clamp(1.2 - age, 0.0, 1.0)},
            hit.contact.point, hit.contact.point + scale * hit.impulse / most * hit.contact.normal,
            words);
    }
}

void add_velocities(viz::Panel& panel, const Stage& stage) {
    double fastest = 0;
    for (const lod::Body<2>& body : stage.bodies())
        fastest = std::max(fastest, body.velocity.norm());
    if (fastest == 0) return;
    const double scale = longest_velocity * viz::longer_side(panel.view) / fastest;
    for (std::size_t i = 0; i < stage.bodies().size(); ++i)
        viz::add_velocity<2>(panel, {stage.bodies()[i], static_cast<int>(i)}, scale);
}

/// Whether the event that is looked at is about the body.
bool is_concerned(const Stage& stage, std::size_t body) {
    const scenes::Event<2>& event = stage.inside().events[*stage.event()];
    return body == lod::at(event.a) || body == lod::at(event.b);
}

/// Names beside the outlines, on the side away from the middle of the others. Of many bodies only
/// those that the event is about.
void add_body_names(viz::Panel& panel, const Stage& stage, bool few) {
    const std::vector<std::string> names = stage.names();
    const auto moving = static_cast<double>(moving_bodies(stage));
    lod::Vector<2> middle = lod::Vector<2>::Zero();
    for (const lod::Body<2>& body : stage.bodies())
        if (!body.tree->is_half_space()) middle += body.position / moving;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!stage.bodies()[i].tree->is_half_space() && (few || is_concerned(stage, i)))
            viz::add_name<2>(panel, stage.actor(i), names[i], static_cast<int>(i),
                             viz::point_of(middle));
}

void add_fixation(viz::Panel& panel, const Stage& stage) {
    if (stage.scene().settings.priority != lod::Priority::perceptual) return;
    const auto& [x, y, z] = stage.scene().settings.viewer.fixation;
    panel.marks.push_back(viz::Dot{{.role = viz::Role::reference}, {x, y}, 1.4});
    panel.marks.push_back(
        viz::Label{{.role = viz::Role::reference}, {x, y}, "the point looked at", 0});
}

/// Contacts and what came of them.
void add_answers(viz::Panel& panel, const Stage& stage) {
    const auto contacts = viz::contacts_of<2>(stage.record());
    viz::add_normals<2>(panel, contacts, normal_length * viz::longer_side(panel.view));
    add_hits(panel, stage);
    viz::add_contact_points<2>(panel, contacts);
    if (moving_bodies(stage) <= few_bodies) add_velocities(panel, stage);
}

/// Where no pair is near: the level of a single body, the root circles of more.
void add_untested(viz::Panel& panel, const Stage& stage) {
    if (stage.bodies().size() == 1) return add_level(panel, stage, 0);
    for (std::size_t i = 0; i < stage.bodies().size(); ++i)
        if (!stage.bodies()[i].tree->is_half_space())
            viz::add_nodes<2>(panel, stage.bodies()[i], std::vector<int>{0}, tested_role(stage),
                              static_cast<int>(i));
}

/// What a frame finds of the bodies as they stand, and the impulses of those before.
void add_present(viz::Panel& panel, const Stage& stage, bool few) {
    for (const NearPair& near : stage.pairs())
        if (few || near.record.verdict != lod::Verdict::apart)
            add_pair(panel, stage, near, few && stage.shown() == Shown::near);
    if (few && stage.pairs().empty() && stage.shown() == Shown::near) add_untested(panel, stage);
    if (stage.scene().told == Told::answers) add_answers(panel, stage);
}

viz::Panel panel_of(const Stage& stage) {
    viz::Panel panel;
    panel.view = stage.scene().view;
    const bool few = moving_bodies(stage) <= few_bodies;
    for (std::size_t i = 0; i < stage.bodies().size(); ++i)
        viz::add_body<2>(panel, stage.actor(i), static_cast<int>(i));
    for (std::size_t i = 0; i < stage.bodies().size() && stage.shown() != Shown::near; ++i)
        add_level(panel, stage, i);
    if (!stage.event())
        add_present(panel, stage, few);
    else
        add_inside(panel, stage);
    if (few || stage.event()) add_body_names(panel, stage, few);
    add_fixation(panel, stage);
    return panel;
}

std::string name_of_body(const Stage& stage, std::int32_t body) {
    return viz::literal_text(stage.scene().actors[lod::at(body)].visual.name);
}

std::string capitalised(std::string text) {
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// Whether the shapes themselves meet, where that was asked.
std::string truth_of(const NearPair& near) {
    if (near.gap < 0) return "";
    return near.gap > 0 ? "; the shapes are still " + viz::length_text(near.gap) + " apart"
                        : "; the shapes do overlap";
}

std::string circles_apart(const Stage& stage, std::int32_t a, std::int32_t b) {
    return "the circles are apart, and so are " + name_of_body(stage, a) + " and " +
           name_of_body(stage, b) + ".";
}

/// Of a single pair: what its last level says.
std::string finding_of(const Stage& stage, const NearPair& near) {
    const lod::PairRecord& pair = near.record;
    if (asks_circles_alone(stage))
        return pair.verdict == lod::Verdict::apart
                   ? circles_apart(stage, pair.bodies.a, pair.bodies.b)
                   : "the circles meet" + truth_of(near) + ".";
    const std::string who =
        name_of_body(stage, pair.bodies.a) + " and " + name_of_body(stage, pair.bodies.b);
    const std::string tests = viz::count_text(static_cast<long long>(pair.tests), "node test");
    if (pair.verdict == lod::Verdict::apart)
        return who + " do not collide: proved at level " + std::to_string(pair.level) + " by " +
               tests + ".";
    std::string text = who + ": " + viz::verdict_words(pair.verdict) + " at level " +
                       std::to_string(pair.level) + " after " + tests;
    if (stage.scene().told == Told::answers)
        text += ", " + viz::count_text(pair.contact_count, "contact");
    return text + truth_of(near) + ".";
}

/// Of a scene of which no pair is near.
std::string nothing_near(const Stage& stage) {
    if (stage.bodies().size() == 2 && asks_circles_alone(stage))
        return capitalised(circles_apart(stage, 0, 1));  // as even their boxes are
    if (stage.bodies().size() > 1) return "No two bodies are near: nothing is tested.";
    const lod::SphereTree<2>& tree = *stage.bodies()[0].tree;
    const int level = std::min(stage.scene().settings.deepest_level, tree.levels() - 1);
    return "Level " + std::to_string(level) + ": " +
           viz::count_text(static_cast<long long>(tree.level_nodes(level).size()), "circle") + ".";
}

/// Of all pairs, in a sentence.
std::string finding(const Stage& stage) {
    if (stage.pairs().empty()) return nothing_near(stage);
    if (stage.pairs().size() == 1) return capitalised(finding_of(stage, stage.pairs()[0]));
    const auto apart = std::count_if(
        stage.pairs().begin(), stage.pairs().end(),
        [](const NearPair& near) { return near.record.verdict == lod::Verdict::apart; });
    return viz::count_text(static_cast<long long>(stage.pairs().size()), "pair") + " near, " +
           (apart == static_cast<std::ptrdiff_t>(stage.pairs().size()) ? "all"
                                                                       : std::to_string(apart)) +
           " of them proved apart, by " +
           viz::count_text(static_cast<long long>(stage.record().tests), "node test") +
           (stage.scene().told == Told::answers
                ? "; " + viz::count_text(static_cast<long long>(stage.record().impacts.size()),
                                         "contact")
                : std::string()) +
           ".";
}

}  // namespace

namespace detail {

viz::Role tested_role(const Stage& stage) {
    return asks_circles_alone(stage) ? viz::Role::level_node : viz::Role::node;
}

void add_lines(viz::Panel& panel, const lod::Body<2>& a, const lod::Body<2>& b,
               std::span<const lod::NodePair> pairs, double opacity) {
    if (a.tree->is_half_space() || b.tree->is_half_space() || pairs.size() > most_lines) return;
    for (const lod::NodePair& pair : pairs)
        viz::add_line<2>(
            panel, {.role = viz::Role::construction, .opacity = opacity},
            std::array{viz::carried_node(a, pair.a).centre, viz::carried_node(b, pair.b).centre},
            1);
}

}  // namespace detail

viz::Figure picture(const Stage& stage) {
    const Scene& scene = stage.scene();
    viz::Figure figure;
    figure.title = viz::literal_text(scene.title.empty() ? scene.name : scene.title);
    figure.numbers = {
        {"time", viz::fixed_text(stage.time(), 2) + "\u00A0s"},
        {"node tests", viz::number_text(static_cast<double>(stage.record().tests), 9)},
        {"contacts", viz::number_text(static_cast<double>(stage.record().impacts.size()), 9)}};
    figure.caption = stage.event() ? inside_finding(stage) : finding(stage);
    figure.alt = viz::plain_text(figure.title) + ", " +
                 viz::count_text(static_cast<long long>(stage.bodies().size()), "body") +
                 " after " + viz::fixed_text(stage.time(), 2) + " s. " +
                 viz::plain_text(figure.caption);
    figure.panels.push_back(panel_of(stage));
    return figure;
}

}  // namespace live
