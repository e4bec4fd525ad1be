#include "lessons/engine/meeting.hpp"

#include <array>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/measure/exact_shapes.hpp"
#include "lodlab/measure/plane_bodies.hpp"
#include "lodlab/viz/draw/motion/draw_comparison.hpp"

namespace lessons {
namespace {

using lod::Body;
using Collision = measure::Collision<2>;

Collision found(const std::optional<Collision>& collision) {
    if (!collision) throw lod::Error(lod::ErrorKind::input_refused, "the two bodies do not meet");
    return *collision;
}

viz::Actor<2> whole(const lod2d::Shape& shape, int depth) {
    viz::Actor<2> result = actor(shape.name, shape, tree_of(shape, depth, lod2d::Builder::medial));
    result.body.exact = measure::exact_shape(shape);
    return result;
}

}  // namespace

Meeting meeting_of(const std::string& a, const std::string& b, int depth) {
    Meeting meeting{lod2d::generate(a), lod2d::generate(b), {}, {}};
    meeting.a = whole(meeting.shape_a, depth);
    meeting.b = whole(meeting.shape_b, depth);
    return meeting;
}

Meeting L_and_U() {
    constexpr double degree = lod::full_turn / 360;
    Meeting meeting = meeting_of("L", "U", 4);
    Body<2>& a = meeting.a.body;
    Body<2>& b = meeting.b.body;
    a.position = lod::Vector<2>(-1.1, 0);
    a.orientation = 10 * degree;
    a.velocity = lod::Vector<2>(1, 0);
    a.spin[0] = 1;
    b.position = lod::Vector<2>(1.1, 0.25);
    b.orientation = 190 * degree;
    b.velocity = lod::Vector<2>(-1, 0);
    return meeting;
}

viz::Actor<2> earlier(viz::Actor<2> actor, double seconds) {
    actor.body.position -= seconds * actor.body.velocity;
    actor.body.orientation -= seconds * actor.body.spin[0];
    return actor;
}

lod::FrameSettings down_to(int level, lod::ContactModel model, double time_step) {
    lod::FrameSettings settings;
    settings.time_step = time_step;
    settings.deepest_level = level;
    settings.contact_model = model;
    return settings;
}

lod::FrameSettings to_the_true_shapes(double time_step) {
    lod::FrameSettings settings;
    settings.time_step = time_step;
    settings.finest.level = lod::Finest::backtrack;
    settings.finest.most_pairs = std::numeric_limits<int>::max();
    return settings;
}

viz::Run<2> run_of(const std::vector<viz::Actor<2>>& actors, const lod::FrameSettings& settings,
                   double seconds, const std::string& name) {
    viz::Run<2> run;
    run.name = name;
    run.time_step = settings.time_step;
    lod::FrameStorage<2> storage;
    std::vector<Body<2>> bodies;
    for (const viz::Actor<2>& actor : actors) {
        run.visuals.push_back(actor.visual);
        bodies.push_back(actor.body);
    }
    const auto frames = static_cast<int>(seconds / settings.time_step + 0.5);
    for (int i = 0; i < frames; ++i) {
        const std::vector<Body<2>> now = bodies;
        lod::Budget budget = lod::Budget::unlimited();
        viz::add_instant(run, now, lod::advance<2>(bodies, settings, budget, storage));
    }
    viz::add_instant(run, bodies, {});
    return run;
}

viz::Run<2> run_of(const Meeting& meeting, const lod::FrameSettings& settings, double seconds,
                   const std::string& name) {
    return run_of(std::vector<viz::Actor<2>>{meeting.a, meeting.b}, settings, seconds, name);
}

Collision collision_of(const Meeting& meeting, const lod::FrameSettings& settings, double horizon) {
    const std::array<const lod2d::Shape*, 2> shapes{&meeting.shape_a, &meeting.shape_b};
    constexpr double first_push = 0;
    return found(measure::framed_collision<2>(meeting.a.body, meeting.b.body, settings,
                                              measure::PlaneBodies(shapes), {horizon, first_push}));
}

Collision exact_collision_of(const Meeting& meeting, double horizon) {
    return found(
        measure::exact_collision<2>(meeting.a.body, meeting.b.body, lod::Response::net, horizon));
}

void add_gap(viz::Panel& panel, const Body<2>& a, const Body<2>& b, const std::string& words) {
    const lod::Separation<2> gap = lod::separation(a, b);
    add_line(panel, viz::Role::reference, gap.on_a, gap.on_b);
    for (const lod::Vector<2>& end : {gap.on_a, gap.on_b})
        panel.marks.push_back(viz::Dot{style(viz::Role::reference), at(end), 0.6});
    if (!words.empty()) add_label(panel, viz::Role::reference, (gap.on_a + gap.on_b) / 2, words);
}

viz::Panel found_at(const Meeting& meeting, const Collision& collision, int level,
                    const viz::Box& view) {
    const Body<2>& a = collision.before[0];
    const Body<2>& b = collision.before[1];
    viz::Panel panel;
    panel.view = view;
    viz::add_body(panel, meeting.at(0, a), 0);
    viz::add_body(panel, meeting.at(1, b), 1);
    const auto fronts = lod::traverse_levels<2>(a, b, level);
    viz::add_meeting_nodes<2>(panel, {a, 0}, {b, 1}, fronts.back().pairs);
    return panel;
}

viz::Figure over(const std::vector<viz::Run<2>>& runs, const viz::Run<2>& reference, double until,
                 const viz::Box& view) {
    viz::Figure figure = viz::comparison<2>(runs, reference, until);
    for (viz::Panel& panel : figure.panels) {
        panel.view = view;
        std::erase_if(panel.marks, [](const viz::Mark& mark) {
            const auto* path = std::get_if<viz::Path>(&mark);
            return path && path->style.role == viz::Role::ghost;
        });
    }
    figure.caption.clear();
    figure.alt.clear();
    figure.columns = figure.panels.size() > 1 ? 2 : 1;
    figure.aspect = page_aspect;
    return figure;
}

viz::Curve errors_by_level(const measure::DegradationCurve& curve, int series,
                           const std::string& name) {
    viz::Curve line;
    line.name = name;
    line.series = series;
    line.dots = true;
    for (int level = 0; level + 1 < static_cast<int>(curve.levels.size()); ++level) {
        const measure::Spread& error = curve.levels[lod::at(level)].impulse_error;
        line.points.push_back({static_cast<double>(level), error.median});
        line.low.push_back(error.p10);
        line.high.push_back(error.p90);
    }
    return line;
}

viz::Figure figure_of(std::vector<viz::Panel> panels, int columns) {
    viz::Figure figure;
    figure.aspect = page_aspect;
    figure.columns = columns;
    figure.panels = std::move(panels);
    return figure;
}

}  // namespace lessons
