#include "lodlab/viz/draw/draw_turntable.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace viz {
namespace {

constexpr double fade_share = 0.15;  ///< of a level's time in which the next one appears

struct TurntableShot {
    Actor<3> actor;
    std::vector<int> levels;
    Turntable choice;
    lod::Sphere<3> whole;  ///< holds every node: the same frame from every side
    int frames_per_level = 1;

    [[nodiscard]] int frames() const { return frames_per_level * static_cast<int>(levels.size()); }
};

/// A ball about the root's centre that holds all that the film shows.
lod::Sphere<3> whole_of(const Actor<3>& actor, const std::vector<int>& levels) {
    lod::Sphere<3> whole{carried_node(actor.body, 0).centre, 0};
    for (const int level : levels) {
        for (const int node : actor.body.tree->level_nodes(level)) {
            const lod::Sphere<3> ball = carried_node(actor.body, node);
            whole.radius =
                std::max(whole.radius, (ball.centre - whole.centre).norm() + ball.radius);
        }
    }
    return whole;
}

Figure picture(const TurntableShot& film, int frame) {
    const double share = static_cast<double>(frame) / film.frames();
    const auto at = static_cast<std::size_t>(frame / film.frames_per_level);
    const double within =
        static_cast<double>(frame % film.frames_per_level) / film.frames_per_level;
    const int level = film.levels[at];
    const int next = film.levels[(at + 1) % film.levels.size()];
    const double fade = std::max(0.0, (within - 1 + fade_share) / fade_share);

    SpaceView view({.azimuth = 2 * std::numbers::pi * film.choice.turns * share + 0.5,
                    .elevation = film.choice.elevation,
                    .perspective = true});
    take_in<3>(view, film.whole);
    Panel panel = blank_panel<3>(view);
    const double away = (vector3(panel.space->camera.eye) - film.whole.centre).norm();
    const double slope = film.whole.radius / away;
    const double rim = film.whole.radius / std::sqrt(1 - slope * slope);  // the ball's picture
    panel.view = {{-rim, -rim}, {rim, rim}};
    add_body(panel, film.actor, 0);
    const auto add_level = [&](int which, double opacity) {
        const std::vector<int> nodes = film.actor.body.tree->level_nodes(which);
        if (opacity > 0)
            add_nodes<3>(panel, film.actor.body, nodes,
                         Style{.role = Role::level_node, .body = 1, .opacity = opacity});
    };
    add_level(level, 1 - fade);
    add_level(next, fade);

    const int shown = fade < 0.5 ? level : next;
    const auto count = static_cast<long long>(film.actor.body.tree->level_nodes(shown).size());
    Figure figure;
    figure.title = film.choice.title.empty()
                       ? "The sphere tree of " + literal_text(film.actor.visual.name)
                       : film.choice.title;
    figure.numbers = {{"level", std::to_string(shown)},
                      {"spheres", number_text(static_cast<double>(count), 9)}};
    figure.alt = "The sphere tree of " + film.actor.visual.name + " from one side: level " +
                 std::to_string(shown) + ", " + count_text(count, "sphere") + ".";
    figure.scale_bar = false;  // in perspective a metre has no one length
    figure.panels.push_back(std::move(panel));
    return figure;
}

}  // namespace

Animation turntable(const Actor<3>& actor, std::vector<int> levels, const Turntable& choice) {
    if (!(choice.frames_per_second >= 1) || !(choice.seconds_per_level > 0))
        throw lod::Error(lod::ErrorKind::usage,
                         "cannot film a turntable: its frame rate and the time of a level must be "
                         "above zero; give positive numbers");
    if (levels.empty()) levels = montage_levels(actor.body.tree->levels());
    const lod::Sphere<3> whole = whole_of(actor, levels);
    const double frames = std::round(choice.frames_per_second * choice.seconds_per_level);
    const auto film = std::make_shared<const TurntableShot>(TurntableShot{
        actor, std::move(levels), choice, whole, std::max(1, static_cast<int>(frames))});
    Animation animation;
    animation.frames_per_second = choice.frames_per_second;
    animation.title = "The sphere tree of " + actor.visual.name;
    for (int frame = 0; frame < film->frames(); ++frame)
        animation.shots.push_back({[film, frame] { return picture(*film, frame); }, 1});
    return animation;
}

}  // namespace viz
