#include "lessons/course/05_possible_and_true/lesson.hpp"

#include <algorithm>

#include "lodlab/viz/draw/draw_traversal.hpp"

namespace lessons {
namespace alarms {

using lod::Front;

namespace {

constexpr int depth = 3;

viz::Box view_of_roots(const Bodies& bodies) {
    return viz::grown(box_round({viz::carried_node(bodies.letter.body, 0),
                                 viz::carried_node(bodies.star.body, 0)}),
                      0.02);
}

/// Where a level of a body's tree stands out furthest: a line from there to the outline.
void add_whisker(viz::Panel& panel, const viz::Actor<2>& actor, const lod2d::Shape& shape,
                 int level, int body) {
    std::vector<lod::Sphere<2>> discs;
    for (const int node : actor.body.tree->level_nodes(level))
        discs.push_back(viz::carried_node(actor.body, node));
    lessons::add_whisker(panel, outline_of(shape, actor.body), discs, body);
}

/// The shortest way from one outline to the other.
void add_gap(viz::Panel& panel, const Bodies& bodies) {
    const lod2d::ClosestPoints closest = bodies.closest();
    add_line(panel, viz::Role::normal, closest.on_a, closest.on_b);
    for (const Vec& end : {closest.on_a, closest.on_b}) add_dot(panel, viz::Role::contact, end);
    add_label(panel, viz::Role::note, (closest.on_a + closest.on_b) / 2, "gap");
}

void give_reach(Lesson& lesson, const Bodies& bodies) {
    const std::vector<Front> levels = bodies.traverse();
    viz::Figure figure = viz::traversal_level(bodies.letter, bodies.star, levels, 0);
    viz::Panel panel = std::move(figure.panels[0]);
    panel.view = view_of_roots(bodies);
    add_whisker(panel, bodies.letter, bodies.letter_shape, 0, 0);
    add_whisker(panel, bodies.star, bodies.star_shape, 0, 1);
    add_gap(panel, bodies);
    for (std::size_t level = 0; level < bodies.letter_out.size(); ++level)
        give(lesson, "reach " + std::to_string(level), number(bodies.reach(level), 3, "m"));
    for (const std::size_t level : {0, 2})
        give(lesson, "L out " + std::to_string(level), number(bodies.letter_out[level], 3, "m"));
    for (const std::size_t level : {0, 1, 2})
        give(lesson, "star out " + std::to_string(level), number(bodies.star_out[level], 3, "m"));
    give(lesson, "near gap", number(bodies.closest().distance, 3, "m"));
    give(lesson, "roots", std::move(panel), {{"gap", "near gap"}});
}

/// The first level whose circles cannot reach over that gap; of one of two bodies alone if asked.
int latest_level(const Bodies& bodies, double gap, bool alone) {
    int level = 0;
    const auto reach = [&] {
        const auto k = static_cast<std::size_t>(level);
        return alone ? std::max(bodies.letter_out[k], bodies.star_out[k]) : bodies.reach(k);
    };
    while (reach() >= gap) ++level;
    return level;
}

viz::Panel reach_plot(const Bodies& bodies) {
    viz::Panel panel;
    const auto deepest = static_cast<double>(bodies.letter_out.size() - 1);
    constexpr double room = 1.06;
    panel.view = box(0, 0, deepest, room * bodies.reach(0));
    panel.axes = viz::Axes{{"level", viz::Scale::linear, {}, true},
                           {"stands out by [m]", viz::Scale::linear, {}, false}};
    viz::Polyline both = curve(2, "both: reach");
    viz::Polyline letter = curve(0, "L");
    viz::Polyline star = curve(1, "star");
    for (std::size_t level = 0; level < bodies.letter_out.size(); ++level) {
        const auto x = static_cast<double>(level);
        both.points.push_back({x, bodies.reach(level)});
        letter.points.push_back({x, bodies.letter_out[level]});
        star.points.push_back({x, bodies.star_out[level]});
    }
    for (viz::Polyline* line : {&letter, &star, &both}) panel.marks.push_back(std::move(*line));
    return panel;
}

/// The nearest place of two bodies at a level, with the gap.
viz::Panel magnified(const Bodies& bodies, int level, double reach) {
    viz::Panel panel =
        viz::traversal_level(bodies.letter, bodies.star, bodies.traverse(), level).panels[0];
    std::erase_if(panel.marks,
                  [](const viz::Mark& mark) { return std::holds_alternative<viz::Label>(mark); });
    const lod2d::ClosestPoints closest = bodies.closest();
    const Vec middle = (closest.on_a + closest.on_b) / 2;
    panel.view =
        box(middle.x() - reach, middle.y() - reach, middle.x() + reach, middle.y() + reach);
    add_gap(panel, bodies);
    return panel;
}

void give_near_miss(Lesson& lesson, const Bodies& bodies) {
    const std::vector<Front> levels = bodies.traverse();
    const double gap = bodies.closest().distance;
    viz::Figure figure = viz::traversal(bodies.letter, bodies.star, levels);
    for (viz::Panel& panel : figure.panels) panel.view = view_of_roots(bodies);
    name_levels(figure, levels);
    const auto proof = static_cast<int>(levels.size()) - 1;
    viz::Panel near = magnified(bodies, proof, 1.4 * gap);
    near.title = "Level " + std::to_string(proof) + ", magnified";
    figure.panels.push_back(std::move(near));
    figure.columns = 2;
    figure.aspect = page_aspect;
    figure.shared_scale = false;
    const int latest = latest_level(bodies, gap, false);
    give(lesson, "latest", count(latest));
    give(lesson, "latest alone", count(latest_level(bodies, gap, true)));
    give(lesson, "proof level", count(proof));
    give(lesson, "early", words(proof < latest ? "earlier than it had to" : "and not before"));
    give(lesson, "near miss", std::move(figure));
    give(lesson, "reach plot", reach_plot(bodies));
}

/// "1 pair of leaves overlaps", "2 pairs of leaves overlap".
std::string leaves_overlap(std::size_t pairs) {
    return pairs_text(pairs) + (pairs == 1 ? " of leaves overlaps" : " of leaves overlap");
}

void give_false_collision(Lesson& lesson, const Bodies& bodies, Bodies deeper) {
    const std::vector<Front> levels = bodies.traverse();
    const double gap = bodies.closest().distance;
    const auto last = static_cast<int>(levels.size()) - 1;
    viz::Figure figure = viz::traversal(bodies.letter, bodies.star, levels, {.levels = {last}});
    figure.caption.clear();
    figure.panels[0].title = "Leaves";
    figure.panels.push_back(magnified(bodies, last, 4 * gap));
    figure.panels[1].title = "Magnified";
    figure.aspect = page_aspect;
    figure.shared_scale = false;
    give(lesson, "false gap", number(gap, 3, "m"));
    give(lesson, "false pairs", words(leaves_overlap(levels.back().pairs.size())));
    give(lesson, "false verdict", words(in_words(levels.back().verdict)));
    figure.numbers = {{"verdict", in_words(levels.back().verdict)},
                      {"gap", lesson.numbers["false gap"].text}};
    give(lesson, "false collision", std::move(figure));
    deeper.place_star(bodies.star.body.position, bodies.star.body.orientation);
    const std::vector<Front> finer = deeper.traverse();
    const auto deep_last = static_cast<int>(finer.size()) - 1;
    give(lesson, "deep level", count(deeper.letter_out.size() - 1));
    give(lesson, "deep verdict", words(in_words(finer.back().verdict)));
    give(lesson, "deep reach", number(deeper.reach(deeper.letter_out.size() - 1), 3, "m"));
    viz::Figure deep = figure_of(magnified(deeper, deep_last, 4 * gap));
    deep.numbers = {{"verdict", in_words(finer.back().verdict)},
                    {"gap", lesson.numbers["false gap"].text}};
    give(lesson, "deeper leaves", std::move(deep));
}

/// Circles of a tree that hold a point, one a level from the root to a leaf; empty: there are none.
std::vector<int> chain_to(const lod::Body<2>& body, const Vec& point, int node = 0) {
    constexpr double rounding = 1e-9;  // [m]
    const lod::Sphere<2> ball = viz::carried_node(body, node);
    if ((point - ball.centre).norm() > ball.radius + rounding) return {};
    const auto i = lod::SphereTree<2>::index(node);
    if (body.tree->is_leaf(node)) return {node};
    for (int child = 0; child < body.tree->child_count[i]; ++child) {
        std::vector<int> chain = chain_to(body, point, body.tree->first_child[i] + child);
        if (chain.empty()) continue;
        chain.insert(chain.begin(), node);
        return chain;
    }
    return {};
}

/// The first corner of the star that lies in the L.
Vec shared_point(const Bodies& bodies) {
    return corner_within(bodies.star, outline_of(bodies.letter_shape, bodies.letter.body));
}

void give_chain(Lesson& lesson, const Bodies& bodies) {
    const Vec point = shared_point(bodies);
    const std::vector<int> of_letter = chain_to(bodies.letter.body, point);
    const std::vector<int> of_star = chain_to(bodies.star.body, point);
    const std::vector<Front> levels = bodies.traverse();
    int found = 0;
    viz::Panel panel;
    panel.view = view_of_roots(bodies);
    add_body(panel, bodies.letter, 0);
    add_body(panel, bodies.star, 1);
    for (std::size_t level = 0; level < std::min(of_letter.size(), of_star.size()); ++level) {
        const lod::NodePair pair{of_letter[level], of_star[level]};
        const auto& front = levels[level].pairs;
        found += std::count(front.begin(), front.end(), pair) == 1 ? 1 : 0;
        const auto k = static_cast<int>(level);
        add_ball(panel, viz::carried_node(bodies.letter.body, pair.a),
                 style(viz::Role::level_node, 0, k));
        add_ball(panel, viz::carried_node(bodies.star.body, pair.b),
                 style(viz::Role::level_node, 1, k));
    }
    add_dot(panel, viz::Role::contact, point);
    add_label(panel, viz::Role::contact, point, "*p*");
    give(lesson, "levels", count(levels.size()));
    give(lesson, "levels with p", count(found));
    give(lesson, "chain", std::move(panel));
}

void animate(Lesson& lesson, const Bodies& start) {
    constexpr int frames = 90;
    constexpr double way = 1.2;  // [m]
    const std::string title = video_words(lesson, "title");
    for (int i = 0; i <= frames; ++i) {
        const auto draw = [start, i, title] {
            Bodies now = start;
            now.place_star((2.0 - way * i / frames) * Vec(0.8, 0.6), first_angle);
            const std::vector<Front> levels = now.traverse();
            viz::Figure figure = viz::traversal_level(now.letter, now.star, levels,
                                                      static_cast<int>(levels.size()) - 1);
            figure.title = title;
            figure.caption.clear();
            figure.aspect = page_aspect;
            figure.panels[0].view = box(-1.5, -1.4, 2.4, 1.9);
            figure.numbers = {{"gap", shown(now.closest().distance, 3) + " m"},
                              {"level", std::to_string(levels.size() - 1)},
                              {"verdict", in_words(levels.back().verdict)}};
            return figure;
        };
        lesson.animation.shots.push_back({draw, i == frames ? 60 : 3});
    }
}

}  // namespace
}  // namespace alarms

void make_possible_and_true(Lesson& lesson) {
    const alarms::Bodies bodies(alarms::depth);
    const alarms::Bodies deeper(alarms::depth + 1);
    const alarms::Bodies near = alarms::near_miss(bodies);
    alarms::give_reach(lesson, near);
    alarms::give_near_miss(lesson, near);
    alarms::give_false_collision(lesson, alarms::false_collision(bodies), deeper);
    alarms::give_chain(lesson, alarms::overlapping(bodies));
    alarms::give_counts(lesson, bodies, deeper);
    alarms::animate(lesson, bodies);
}

}  // namespace lessons
