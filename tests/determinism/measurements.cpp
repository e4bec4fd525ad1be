// How collisions degrade, as the text that `lodlab degrade` writes.

#include "lodlab/measure/curves.hpp"
#include "tests/determinism/report.hpp"

namespace {

template <int Dim>
void add_curves(const std::string& where, std::vector<std::string> names,
                const std::string& builder, int impacts, Report& report) {
    measure::Plan plan;
    plan.dim = Dim;
    plan.shapes = std::move(names);
    plan.builder = builder;
    plan.depth = 2;
    plan.impacts = impacts;
    plan.ensemble.seed = 7;
    plan.models = {lod::ContactModel::centre_line, lod::ContactModel::node_normal,
                   lod::ContactModel::hull};
    plan.responses = {lod::Response::net};
    std::vector<measure::MeasuredShape<Dim>> shapes;
    for (const std::string& shape : plan.shapes)
        shapes.push_back(measure::measured_shape<Dim>(shape, scenes::Shapes<Dim>::named(shape, {}),
                                                      {builder, {}, plan.depth, {}, {}, {}}, {}));
    const measure::Outcomes outcomes = measure::degrade<Dim>(plan, shapes);
    report.add_text("degradation in " + where + ", every outcome",
                    measure::outcomes_json(outcomes));
    report.add_text("degradation in " + where + ", its curves",
                    measure::curves_csv(measure::curves_of(outcomes)));
}

}  // namespace

void add_measurements(Report& report) {
    add_curves<2>("the plane", {"box", "L", "star:5"}, "medial", 12, report);
    add_curves<3>("space", {"box", "L"}, "octree", 3, report);
}
