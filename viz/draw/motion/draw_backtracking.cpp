#include "lodlab/viz/draw/motion/draw_backtracking.hpp"

#include <array>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

/// The two bodies at one moment.
template <int Dim>
struct Moment {
    double time = 0;  ///< [s]
    Actor<Dim> a;
    Actor<Dim> b;
};

/// The three moments that the figure shows.
template <int Dim>
struct Story {
    Moment<Dim> found;    ///< the frame in which nodes overlap
    Moment<Dim> touched;  ///< the time of contact of the nodes
    Moment<Dim> nearest;  ///< the bodies' own nearest approach
    std::vector<lod::Contact<Dim>> contacts;
    lod::Separation<Dim> gap_then;  ///< of the bodies at `touched`
    lod::Separation<Dim> least_gap;
};

[[noreturn]] void refuse(const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, "no figure of backtracking: " + why);
}

template <int Dim>
Story<Dim> story_of(const Actor<Dim>& a, const Actor<Dim>& b,
                    const BacktrackingQuestion& question) {
    const lod::ImpactSettings ahead{.horizon = question.horizon};
    const auto touch = lod::level_impact(a.body, b.body, question.level, ahead);
    if (touch.outcome != lod::ImpactOutcome::touching)
        refuse("the nodes of level " + std::to_string(question.level) +
               " never begin to touch; choose another level or start");
    if (lod::time_of_impact(a.body, b.body, ahead).outcome != lod::ImpactOutcome::never)
        refuse("the bodies truly collide; let them pass each other");
    const double frame = question.time_step * std::ceil(touch.time / question.time_step + 1e-9);
    const auto at = [&](double time) {
        const auto moved = [&](const lod::Body<Dim>& body) {
            return lod::moved_freely(body, time, ahead.longest_turn);
        };
        return Moment<Dim>{time, {a.visual, moved(a.body)}, {b.visual, moved(b.body)}};
    };
    constexpr int looks = 2000;
    const auto nearest = lod::nearest_approach(a.body, b.body, ahead, looks);
    return {at(frame),
            {touch.time, {a.visual, touch.a}, {b.visual, touch.b}},
            {nearest.time, {a.visual, nearest.a}, {b.visual, nearest.b}},
            touch.contacts,
            lod::separation(touch.a, touch.b),
            nearest.gap};
}

std::string moment_words(double seconds) {
    return quantity_text(seconds, "s", 3);
}

template <int Dim>
void add_level(Panel& panel, const Moment<Dim>& moment, int level) {
    add_nodes<Dim>(panel, moment.a.body, moment.a.body.tree->level_nodes(level), Role::node, 0);
    add_nodes<Dim>(panel, moment.b.body, moment.b.body.tree->level_nodes(level), Role::node, 1);
}

/// Nodes of the level, or leaves above it, that overlap.
template <int Dim>
std::vector<lod::NodePair> meeting_pairs(const Moment<Dim>& moment, int level) {
    std::vector<lod::NodePair> pairs;
    for (const int i : moment.a.body.tree->level_nodes(level))
        for (const int j : moment.b.body.tree->level_nodes(level))
            if (lod::overlap(carried_node(moment.a.body, i), carried_node(moment.b.body, j)))
                pairs.push_back({i, j});
    return pairs;
}

template <int Dim>
Panel bodies_panel(const Moment<Dim>& moment, const View<Dim>& view, std::string title) {
    Panel panel = blank_panel<Dim>(view);
    panel.title = std::move(title);
    add_body(panel, moment.a, 0);
    add_body(panel, moment.b, 1);
    return panel;
}

/// The shortest way between two bodies, with its length.
template <int Dim>
void add_gap(Panel& panel, const lod::Separation<Dim>& gap) {
    const std::array<lod::Vector<Dim>, 2> ends{gap.on_a, gap.on_b};
    add_line<Dim>(panel, {.role = Role::reference}, ends, 1);
    for (const auto& end : ends)
        panel.marks.push_back(Dot{{.role = Role::reference}, DrawTraits<Dim>::on(panel, end), 0.6});
    panel.marks.push_back(Label{{.role = Role::reference},
                                DrawTraits<Dim>::on(panel, 0.5 * (gap.on_a + gap.on_b)),
                                "gap " + length_text(gap.distance),
                                0});
}

template <int Dim>
View<Dim> view_of(const Story<Dim>& story, int level,
                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    View<Dim> view(viewpoint, way_between(story.found.a.body, story.found.b.body));
    for (const Moment<Dim>* moment : {&story.found, &story.touched, &story.nearest})
        for (const Actor<Dim>* actor : {&moment->a, &moment->b}) take_in<Dim>(view, *actor);
    for (const Moment<Dim>* moment : {&story.found, &story.touched})
        for (const Actor<Dim>* actor : {&moment->a, &moment->b})
            for (const int node : actor->body.tree->level_nodes(level))
                take_in<Dim>(view, carried_node(actor->body, node));
    return view;
}

template <int Dim>
void describe(const Actor<Dim>& a, const Actor<Dim>& b, const Story<Dim>& story, int level,
              Figure& figure) {
    const std::string balls = std::string(DrawTraits<Dim>::ball_word) + "s";
    const std::string at_level = "level " + std::to_string(level);
    figure.title = "Backtracking at " + at_level + " finds a time of contact that never was";
    figure.numbers = {{"gap at that time", length_text(story.gap_then.distance)},
                      {"least gap ever", length_text(story.least_gap.distance)}};
    figure.caption = "Bold: " + balls + " of " + at_level +
                     " that overlap. Backtracking belongs after the leaves, to the true shapes.";
    figure.alt = "Three moments of " + plain_text(shown_name<Dim>({a.visual, b.visual}, 0)) +
                 " and " + plain_text(shown_name<Dim>({a.visual, b.visual}, 1)) + ". " + "At " +
                 moment_words(story.found.time) + " " + balls + " of " + at_level +
                 " overlap. Backtracking moves the bodies to " + moment_words(story.touched.time) +
                 ", where these " + balls + " touch; the bodies themselves are " +
                 length_text(story.gap_then.distance) +
                 " apart. They never touch: the least gap, at " + moment_words(story.nearest.time) +
                 ", is " + length_text(story.least_gap.distance) + ".";
}

}  // namespace

template <int Dim>
Figure inappropriate_backtracking(const Actor<Dim>& a, const Actor<Dim>& b,
                                  const BacktrackingQuestion& question,
                                  const typename DrawTraits<Dim>::Viewpoint& viewpoint) {
    const int level = question.level;
    const Story<Dim> story = story_of(a, b, question);
    const View<Dim> view = view_of(story, level, viewpoint);
    Figure figure;
    describe(a, b, story, level, figure);
    figure.columns = 3;

    Panel found = bodies_panel<Dim>(story.found, view,
                                    "*t_0* = " + moment_words(story.found.time) + ": " +
                                        DrawTraits<Dim>::ball_word + "s overlap");
    add_level(found, story.found, level);
    add_meeting_nodes<Dim>(found, {story.found.a.body, 0}, {story.found.b.body, 1},
                           meeting_pairs(story.found, level));
    add_names(found, story.found.a, story.found.b);

    Panel touched = bodies_panel<Dim>(
        story.touched, view,
        "Backtracked to *t* = " + moment_words(story.touched.time) + ": they touch");
    add_level(touched, story.touched, level);
    add_normals<Dim>(touched, story.contacts, 0.12 * longer_side(touched.view));
    add_contact_points<Dim>(touched, story.contacts);
    add_gap(touched, story.gap_then);

    Panel nearest =
        bodies_panel<Dim>(story.nearest, view,
                          "*t* = " + moment_words(story.nearest.time) + ": as near as they come");
    add_gap(nearest, story.least_gap);
    figure.panels = {std::move(found), std::move(touched), std::move(nearest)};
    return figure;
}

template Figure inappropriate_backtracking<2>(const Actor<2>&, const Actor<2>&,
                                              const BacktrackingQuestion&,
                                              const DrawTraits<2>::Viewpoint&);
template Figure inappropriate_backtracking<3>(const Actor<3>&, const Actor<3>&,
                                              const BacktrackingQuestion&,
                                              const DrawTraits<3>::Viewpoint&);

}  // namespace viz
