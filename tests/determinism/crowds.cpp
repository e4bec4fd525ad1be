// Balls of balls that fly at each other: core alone, without shapes or files.

#include <memory>
#include <utility>

#include "lodlab/core/frame/frame.hpp"
#include "tests/determinism/report.hpp"

namespace {

using lod::Body;
using lod::Sphere;
using lod::Vector;

/// Numbers in [-1, 1), the same everywhere.
class Numbers {
  public:
    double next() {
        state_ = 6364136223846793005ULL * state_ + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
    }
    template <class V>
    V vector() {
        V v;
        for (double& number : v) number = next();
        return v;
    }

  private:
    std::uint64_t state_ = 2000;
};

/// A ball of 2^Dim smaller balls towards the corners, and so on.
template <int Dim>
void grow(std::vector<lod::TreeNode<Dim>>& nodes, std::size_t node, int levels) {
    if (levels == 0) return;
    const Sphere<Dim> parent = nodes[node].sphere;
    for (int corner = 0; corner < (1 << Dim); ++corner) {
        Vector<Dim> towards;
        for (int axis = 0; axis < Dim; ++axis) towards[axis] = corner >> axis & 1 ? 1 : -1;
        const double radius = 0.55 * parent.radius;
        nodes[node].children.push_back(static_cast<int>(nodes.size()));
        nodes.push_back({{parent.centre + 0.45 * parent.radius * towards.normalized(), radius},
                         0.5 * towards.normalized(),
                         {}});
        grow(nodes, nodes.size() - 1, levels - 1);
    }
}

template <int Dim>
std::shared_ptr<const lod::SphereTree<Dim>> cluster(int levels) {
    std::vector<lod::TreeNode<Dim>> nodes(1);
    nodes[0].sphere.radius = 1;
    grow<Dim>(nodes, 0, levels);
    return std::make_shared<lod::SphereTree<Dim>>(lod::lay_out<Dim>(nodes));
}

/// Spinning clusters that all fly towards the origin, under a budget of node tests.
template <int Dim>
std::uint64_t crowd(const lod::FrameSettings& settings, const lod::Budget& budget) {
    Numbers numbers;
    const auto tree = cluster<Dim>(2);
    std::vector<Body<Dim>> bodies(10);
    for (Body<Dim>& body : bodies) {
        lod::Inertia<Dim> inertia = lod::Inertia<Dim>::Identity();
        for (int axis = 0; axis < inertia.rows(); ++axis) inertia(axis, axis) += 0.3 * axis;
        lod::set_mass<Dim>(body, 2 + numbers.next(), inertia);
        body.restitution = 0.9;
        body.position = 7 * numbers.vector<Vector<Dim>>();
        body.velocity = -body.position + numbers.vector<Vector<Dim>>();
        body.spin = 3 * numbers.vector<lod::Spin<Dim>>();
        body.tree = tree;
    }
    lod::FrameStorage<Dim> storage;
    for (int frame = 0; frame < 180; ++frame) {
        lod::Budget of_frame = budget;
        lod::advance<Dim>(bodies, settings, of_frame, storage);
    }
    return lod::state_hash<Dim>(bodies);
}

/// Every response with every contact model, and the other point, each over the same crowd.
template <int Dim>
void add_models(const std::string& where, Report& report) {
    constexpr std::pair<lod::Response, const char*> responses[] = {
        {lod::Response::net, "net"},   {lod::Response::sum, "sum"},
        {lod::Response::mean, "mean"}, {lod::Response::sequential, "sequential"},
        {lod::Response::lcp, "lcp"},   {lod::Response::reflections, "reflections"}};
    constexpr std::pair<lod::ContactModel, const char*> models[] = {
        {lod::ContactModel::centre_line, "centre line"},
        {lod::ContactModel::node_normal, "node normal"}};
    for (const auto& [response, response_name] : responses)
        for (const auto& [model, model_name] : models) {
            lod::FrameSettings settings;
            settings.response = response;
            settings.contact_model = model;
            report.add("crowd in " + where + ", " + response_name + ", " + model_name,
                       crowd<Dim>(settings, lod::Budget::unlimited()));
        }
    lod::FrameSettings settings;
    settings.contact_model = lod::ContactModel::centre_line;
    settings.point_model = lod::PointModel::plane_of_intersection;
    report.add("crowd in " + where + ", plane of intersection",
               crowd<Dim>(settings, lod::Budget::unlimited()));
}

/// What differs in how the pairs of nodes are found.
template <int Dim>
void add_traversals_of(const std::string& where, Report& report) {
    report.add("tree of balls in " + where, lod::tree_hash(*cluster<Dim>(4)));
    report.add("crowd in " + where + ", 100 node tests a frame",
               crowd<Dim>({}, lod::Budget::node_tests(100)));
    lod::FrameSettings in_order;
    in_order.priority = lod::Priority::level_order;
    report.add("crowd in " + where + ", 100 node tests a frame, in order",
               crowd<Dim>(in_order, lod::Budget::node_tests(100)));
    for (const lod::Priority priority : {lod::Priority::first_come, lod::Priority::perceptual,
                                         lod::Priority::best_gain, lod::Priority::trade})
        report.add("crowd in " + where + ", 100 node tests a frame, " +
                       std::string(lod::name_of(priority)),
                   crowd<Dim>({.priority = priority}, lod::Budget::node_tests(100)));
    lod::FrameSettings swept;  // at steps in which the clusters move further than their leaves are
    swept.time_step = 0.1;
    swept.sweep.on = true;
    report.add("crowd in " + where + ", swept at a tenth of a second a frame",
               crowd<Dim>(swept, lod::Budget::unlimited()));
}

}  // namespace

void add_traversals(Report& report) {
    add_traversals_of<2>("the plane", report);
    add_traversals_of<3>("space", report);
}

void add_crowds(Report& report) {
    add_traversals_of<2>("the plane", report);
    add_models<2>("the plane", report);
    add_traversals_of<3>("space", report);
    add_models<3>("space", report);
}
