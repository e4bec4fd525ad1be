#include <algorithm>

#include "lessons/course/09_graceful_degradation/lesson.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"

namespace lessons::degradation {
namespace {

constexpr std::uint64_t budget = 50;  // distance tests a pair may spend

// listing: plan
measure::Outcomes measure_impacts() {
    measure::Plan plan;
    plan.shapes = {"box", "L", "star:5"};
    plan.builder = "pieces";
    plan.depth = depth;
    plan.impacts = 40;
    plan.models = {lod::ContactModel::centre_line, lod::ContactModel::hull};
    plan.responses = {lod::Response::net};
    std::vector<measure::MeasuredShape<2>> shapes;
    scenes::TreeChoice tree;
    tree.builder = plan.builder;
    tree.depth = depth;
    for (const std::string& name : plan.shapes)
        shapes.push_back(
            measure::measured_shape<2>(name, scenes::Shapes<2>::named(name, {}), tree, {}));
    return measure::degrade<2>(plan, shapes);
}
// end of listing

/// In how many of the impacts a level is further off than level 0, by centre lines.
std::size_t worse_than_level_0(const measure::Outcomes& outcomes, std::size_t level) {
    return static_cast<std::size_t>(
        std::count_if(outcomes.impacts.begin(), outcomes.impacts.end(), [&](const auto& impact) {
            return impact.outcomes[level].impulse_error > impact.outcomes[0].impulse_error;
        }));
}

std::string digits(double error) {
    return shown(error, error < 0.1 ? 4 : 3);
}

void give_levels(Lesson& lesson, const measure::DegradationCurve& curve, const std::string& model) {
    for (int level = 0; level <= depth; ++level) {
        const measure::CurveLevel& one = curve.levels[lod::at(level)];
        const std::string name = model + " " + std::to_string(level);
        const double error = one.impulse_error.median;
        give(lesson, name, Number{error, digits(error), ""});
        if (model == "hull") continue;
        give(lesson, "tests " + std::to_string(level), count(static_cast<int>(one.tests.median)));
    }
}

/// The median error of the last level that so many tests pay for.
viz::Polyline by_budget(const measure::DegradationCurve& curve, int series,
                        const std::string& name) {
    viz::Polyline stairs = lessons::curve(series, name);
    for (int level = 0; level <= depth; ++level) {
        const measure::CurveLevel& one = curve.levels[lod::at(level)];
        if (!stairs.points.empty())
            stairs.points.push_back({one.tests.median, stairs.points.back().y});
        stairs.points.push_back({one.tests.median, one.impulse_error.median});
    }
    stairs.points.push_back({1.15 * stairs.points.back().x, stairs.points.back().y});
    return stairs;
}

viz::Figure budget_plot(const measure::DegradationCurve& curve) {
    viz::Panel panel;
    viz::Polyline stairs = by_budget(curve, 0, "");
    panel.view = box(0, 0, stairs.points.back().x, 1.15 * stairs.points.front().y);
    panel.axes = viz::Axes{{"budget of the pair [distance tests]", viz::Scale::linear, {}, true},
                           {"error of the impulse, median", viz::Scale::linear, {}, false}};
    panel.marks.push_back(std::move(stairs));
    return figure_of(std::move(panel));
}

}  // namespace

void give_curves(Lesson& lesson) {
    const measure::Outcomes outcomes = measure_impacts();
    const auto curves = measure::curves_of(outcomes);
    const measure::DegradationCurve& line = curves[0];
    const measure::DegradationCurve& hull = curves[1];
    give_levels(lesson, line, "line");
    give_levels(lesson, hull, "hull");
    give(lesson, "impacts", count(outcomes.plan.impacts));
    give(lesson, "worse", count(worse_than_level_0(outcomes, 1)));
    const std::size_t at_last = worse_than_level_0(outcomes, depth);
    give(lesson, "worse at last",
         words(at_last == 0 ? "none" : shown_count(at_last), static_cast<double>(at_last)));
    give(lesson, "budget", count(budget));
    int affordable = 0;
    while (line.levels[lod::at(affordable + 1)].tests.median <= budget) ++affordable;
    give(lesson, "affordable", count(affordable));
    const measure::CurveLevel& first = hull.levels[1];
    give(lesson, "hull gap", number(100 * first.gap.median, 1, "cm"));
    give(lesson, "line gap", number(100 * line.levels[1].gap.median, 1, "cm"));
    give(lesson, "hull widest gap", number(100 * first.most_gap, 1, "cm"));
    give(lesson, "hull tail", number(first.impulse_error.p90, 2));
    const viz::Axes axes{{"level", viz::Scale::linear, {0, 1, 2, 3, 4}, true},
                         {"error of the impulse", viz::Scale::logarithmic, {}, false}};
    const std::vector<viz::Curve> both{errors_by_level(line, 0, "centre line"),
                                       errors_by_level(hull, 1, "hull")};
    give(lesson, "many", viz::plot_panel("", axes, {both[0]}));
    give(lesson, "hulls", viz::plot_panel("", axes, both));
    give(lesson, "budgets", budget_plot(line));
}

}  // namespace lessons::degradation
