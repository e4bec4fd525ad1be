#include "lodlab/measure/curves.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/scenes/scene.hpp"

namespace measure {
namespace {

CurveLevel level_of(const Outcomes& outcomes, std::size_t curve, std::size_t level) {
    std::vector<const Outcome*> all;
    for (const ImpactSample& impact : outcomes.impacts)
        all.push_back(&impact.outcomes[curve * outcomes.plan.levels() + level]);
    const auto spread_by = [&](double Outcome::*field) {
        std::vector<double> values;
        for (const Outcome* outcome : all) values.push_back(outcome->*field);
        return spread(std::move(values));
    };
    CurveLevel result;
    result.name = level + 1 == outcomes.plan.levels() ? "exact" : std::to_string(level);
    result.impacts = static_cast<int>(all.size());
    result.impulse_error = spread_by(&Outcome::impulse_error);
    result.angle_error = spread_by(&Outcome::angle_error);
    result.spin_error = spread_by(&Outcome::spin_error);
    result.gap = spread_by(&Outcome::gap);
    result.delay = spread_by(&Outcome::delay);
    result.tests = spread_by(&Outcome::tests);
    result.microseconds = spread_by(&Outcome::microseconds);
    for (const Outcome* outcome : all) {
        result.most_gap = std::max(result.most_gap, outcome->gap);
        result.bound_violations += outcome->gap > outcome->gap_bound;
        result.missed += outcome->missed;
    }
    return result;
}

/// A row of a table whose cells are parted by commas.
class Row {
  public:
    void add(std::string_view cell) {
        if (!text_.empty()) text_ += ',';
        text_ += cell;
    }
    void add(double number) { add(std::string_view(lod::number_text(number))); }
    void add(int number) { add(std::string_view(std::to_string(number))); }
    [[nodiscard]] std::string line() const { return text_ + '\n'; }

  private:
    std::string text_;
};

}  // namespace

Spread spread(std::vector<double> values) {
    if (values.empty())
        throw lod::Error(lod::ErrorKind::input_refused, "no values to take the median of");
    std::sort(values.begin(), values.end());
    const auto rank = [&](std::size_t tenths) {
        return values[(values.size() * tenths + 9) / 10 - 1];
    };
    return {rank(1), rank(5), rank(9)};
}

bool DegradationCurve::falls_at_every_level() const {
    return std::adjacent_find(levels.begin(), levels.end(),
                              [](const CurveLevel& coarse, const CurveLevel& fine) {
                                  return fine.impulse_error.median >= coarse.impulse_error.median;
                              }) == levels.end();
}

std::vector<DegradationCurve> curves_of(const Outcomes& outcomes) {
    std::vector<DegradationCurve> curves;
    for (const lod::ContactModel model : outcomes.plan.models)
        for (const lod::Response response : outcomes.plan.responses) {
            DegradationCurve curve{model, response, {}};
            for (std::size_t level = 0; level < outcomes.plan.levels(); ++level)
                curve.levels.push_back(level_of(outcomes, curves.size(), level));
            curves.push_back(std::move(curve));
        }
    return curves;
}

std::string curves_csv(const std::vector<DegradationCurve>& curves) {
    std::string text =
        "model,response,level,impacts,impulse_error_median,impulse_error_p90,angle_error_median,"
        "angle_error_p90,spin_error_median,spin_error_p90,gap_median,gap_max,bound_violations,"
        "delay_median,delay_p90,tests,microseconds,missed\n";
    for (const DegradationCurve& curve : curves)
        for (const CurveLevel& level : curve.levels) {
            Row row;
            row.add(lod::name_of(curve.model));
            row.add(lod::name_of(curve.response));
            row.add(std::string_view(level.name));
            row.add(level.impacts);
            for (const Spread& error : {level.impulse_error, level.angle_error, level.spin_error}) {
                row.add(error.median);
                row.add(error.p90);
            }
            row.add(level.gap.median);
            row.add(level.most_gap);
            row.add(level.bound_violations);
            row.add(level.delay.median);
            row.add(level.delay.p90);
            row.add(level.tests.median);
            row.add(level.microseconds.median);
            row.add(level.missed);
            text += row.line();
        }
    return text;
}

}  // namespace measure
