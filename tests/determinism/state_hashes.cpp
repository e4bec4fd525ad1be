// Runs scenes and prints one hash each: of the bits of every body at the end, or of a tree.
// scripts/check_hashes compares them between compilers and levels.
//
// Usage: state_hashes [FILE]   compares with the hashes in FILE instead of printing, exits 1 on a
// change

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "lodlab/core/frame.hpp"
#include "lodlab/core/state_hash.hpp"
#include "lodlab/lod2d/build_tree.hpp"
#include "lodlab/lod2d/generators.hpp"
#include "lodlab/scenes/places.hpp"
#include "lodlab/scenes/run.hpp"
#include "lodlab/scenes/setup.hpp"

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
std::uint64_t crowd(lod::FrameSettings settings, lod::Budget budget) {
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
    for (int frame = 0; frame < 240; ++frame) {
        lod::Budget of_frame = budget;
        lod::advance<Dim>(bodies, settings, of_frame, storage);
    }
    return lod::state_hash<Dim>(bodies);
}

/// "scene: hash" lines.
class Report {
  public:
    void add(const std::string& scene, std::uint64_t hash) {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
        lines_ += digits + ("  " + scene) + "\n";
    }
    [[nodiscard]] const std::string& lines() const { return lines_; }

  private:
    std::string lines_;
};

template <int Dim>
void add_crowds(const std::string& where, Report& report) {
    lod::FrameSettings settings;
    report.add("tree of balls in " + where, lod::tree_hash(*cluster<Dim>(4)));
    report.add("crowd in " + where, crowd<Dim>(settings, lod::Budget::unlimited()));
    report.add("crowd in " + where + ", 100 node tests a frame",
               crowd<Dim>(settings, lod::Budget::node_tests(100)));
    settings.contact_model = lod::ContactModel::centre_line;
    report.add("crowd in " + where + ", centre line",
               crowd<Dim>(settings, lod::Budget::unlimited()));
    settings.point_model = lod::PointModel::plane_of_intersection;
    settings.response = lod::Response::mean;
    report.add("crowd in " + where + ", plane of intersection, mean of impulses",
               crowd<Dim>(settings, lod::Budget::unlimited()));
}

/// The trees of the plane's builders, over shapes with straight and curved edges and holes.
void add_trees(Report& report) {
    for (const char* name : {"star:5", "gear:5", "blob:7"})
        for (const lod2d::Builder builder : lod2d::builders()) {
            const lod2d::TreeSettings settings{.builder = builder, .depth = 2};
            report.add(std::string(lod2d::builder_name(builder)) + " tree of " + name,
                       lod::tree_hash(lod2d::build_tree(lod2d::generate(name), settings)));
        }
}

/// The state in which a scene ends.
template <int Dim>
std::uint64_t end_of(const scenes::Scene& scene) {
    scenes::RunOptions options;
    options.settings = scenes::frame_settings(scene, scene.limits);
    options.frames = scene.frames();
    options.limits = scene.limits;
    return scenes::run(scenes::set_up<Dim>(scene).bodies, options).state_hash;
}

/// Every scene that comes with lodlab, from its file to its end, with shallow trees: at -O0 they
/// take a hundred times as long as in a release.
void add_scenes(Report& report) {
    for (const std::string& name : scenes::names()) {
        scenes::Scene scene = scenes::load_scene(scenes::scene_file(name));
        for (scenes::BodySpec& body : scene.bodies)
            body.depth = std::min(body.depth.value_or(2), 2);
        const bool from_package = std::any_of(
            scene.bodies.begin(), scene.bodies.end(),
            [](const scenes::BodySpec& body) { return scenes::in_package(body.shape); });
        // Not repeatable without its trace, or not everywhere and of long work.
        if (scene.limits.milliseconds || from_package) continue;
        report.add("scene " + name, scene.dim == 3 ? end_of<3>(scene) : end_of<2>(scene));
    }
}

}  // namespace

int main(int count, char** arguments) {
    Report report;
    add_crowds<2>("the plane", report);
    add_crowds<3>("space", report);
    add_trees(report);
    add_scenes(report);
    if (count < 2) {
        std::fputs(report.lines().c_str(), stdout);
        return 0;
    }
    std::stringstream expected;
    expected << std::ifstream(arguments[1]).rdbuf();
    if (expected.str() == report.lines()) return 0;
    std::printf(
        "%s says\n%sbut this build gives\n%s"
        "Where the change is meant, write these there: state_hashes > "
        "tests/determinism/hashes.txt\n",
        arguments[1], expected.str().c_str(), report.lines().c_str());
    return 1;
}
