#include "lessons/course/14_too_early/lesson.hpp"
#include "lodlab/measure/crowd/quota.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/viz/draw/motion/draw_crowd.hpp"

namespace lessons::early {
namespace {

using lod::Body;

constexpr std::int64_t frames = 60;
constexpr int bodies = 48;

struct Crowd {
    scenes::Setup<2> setup;
    lod::FrameSettings settings;
    measure::QuotaOutcomes quotas;
};

const std::vector<double> shares{0.02, 0.05, 0.1, 0.2, 0.5, 1};

Crowd make_crowd() {
    scenes::Scene scene = scenes::crowd("implode:" + std::to_string(bodies) + ",3");
    for (scenes::BodySpec& body : scene.bodies) body.depth = 4;
    Crowd crowd{scenes::set_up<2>(scene), scenes::frame_settings(scene, {}), {}};
    crowd.settings.priority = lod::Priority::closing_speed;
    measure::QuotaPlan<2> plan;
    plan.bodies = crowd.setup.bodies;
    plan.settings = crowd.settings;
    plan.frames = frames;
    plan.shares = shares;
    plan.priorities = {lod::Priority::closing_speed};
    crowd.quotas = measure::try_quotas<2>(plan);
    return crowd;
}

viz::Run<2> run_under(const Crowd& crowd, std::uint64_t quota) {
    viz::Run<2> run;
    run.time_step = crowd.settings.time_step;
    for (const auto& shape : crowd.setup.shapes) run.visuals.push_back(viz::visual_of(*shape));
    std::vector<Body<2>> moving = crowd.setup.bodies;
    lod::FrameStorage<2> storage;
    for (std::int64_t i = 0; i < frames; ++i) {
        const std::vector<Body<2>> now = moving;
        lod::Budget budget = lod::Budget::node_tests(quota);
        viz::add_instant(run, now, lod::advance<2>(moving, crowd.settings, budget, storage));
    }
    return run;
}

/// The crowd and the list of levels, large enough for a page of the book.
viz::Figure bodies_and_levels(const viz::Figure& picture) {
    viz::Figure figure = figure_of({picture.panels[0], picture.panels[1]}, 2);
    figure.column_weights = {2.6, 1};
    figure.panels[0].view = box(-3.9, -3.9, 3.9, 3.9);
    figure.panels[1].title.clear();
    for (viz::Panel& panel : figure.panels) panel.cell.reset();
    return figure;
}

}  // namespace

void give_crowd(Lesson& lesson) {
    const Crowd crowd = make_crowd();
    const std::vector<measure::QuotaOutcome>& outcomes = crowd.quotas.of_priority[0];
    viz::Curve curve;
    curve.dots = true;
    for (const measure::QuotaOutcome& outcome : outcomes)
        curve.points.push_back({static_cast<double>(outcome.quota), outcome.error});
    const measure::QuotaOutcome& tenth = outcomes[2];
    const viz::Run<2> run = run_under(crowd, tenth.quota);
    const std::size_t fullest = viz::fullest_instant(run);
    const lod::FrameRecord<2>& record = run.instants[fullest].record;
    const lod::LevelsReached reached = record.levels_reached();
    viz::CrowdChoice choice;
    choice.quota.node_tests = tenth.quota;
    const viz::Figure picture = viz::crowd_picture<2>(run, fullest, choice);
    give(lesson, "crowd", bodies_and_levels(picture));
    give(lesson, "bodies", count(bodies));
    give(lesson, "dearest", count(crowd.quotas.dearest));
    give(lesson, "quota", count(tenth.quota));
    give(lesson, "spent", count(record.tests));
    give(lesson, "pairs", count(reached.pairs));
    give(lesson, "least", count(reached.least));
    give(lesson, "mean level", number(reached.mean, 1));
    give(lesson, "tenth error", number(100 * tenth.error, 0, "%"));
    give(lesson, "half error", number(100 * outcomes[4].error, 1, "%"));
    give(lesson, "least error", number(100 * outcomes[0].error, 0, "%"));
    give(lesson, "least quota", count(outcomes[0].quota));
    const viz::Axes axes{{"quota of a frame [distance tests]", viz::Scale::logarithmic, {}, true},
                         {"error of all impulses", viz::Scale::linear, {}, false}};
    choice.title = video_words(lesson, "title");
    lesson.animation = viz::crowd_motion<2>(run, choice);
    give(lesson, "quotas", viz::plot_panel("", axes, {curve}));
}

}  // namespace lessons::early
