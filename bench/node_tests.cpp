// Node tests per second: the traversal (lod::refine) against a plain loop over the very same pairs
// of spheres, in one run.
//
// bench_node_tests [REPEATS]

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench/timing.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace {

using namespace lod;

/// The classical tree of a square or cube: a ball round each of its 2^Dim parts, and so on.
template <int Dim>
std::shared_ptr<const SphereTree<Dim>> cube_tree(int deep) {
    std::vector<TreeNode<Dim>> nodes;
    const auto add = [&](auto&& self, const Vector<Dim>& middle, double half, int levels) -> int {
        const int number = static_cast<int>(nodes.size());
        nodes.push_back(
            {{middle, half * Vector<Dim>::Constant(1).norm()}, Vector<Dim>::Zero(), {}});
        for (int corner = 0; levels > 0 && corner < (1 << Dim); ++corner) {
            Vector<Dim> step;
            for (int d = 0; d < Dim; ++d) step[d] = corner >> d & 1 ? half / 2 : -half / 2;
            const int child = self(self, middle + step, half / 2, levels - 1);
            nodes[static_cast<std::size_t>(number)].children.push_back(child);
        }
        return number;
    };
    add(add, Vector<Dim>::Zero(), 0.5, deep);
    return std::make_shared<SphereTree<Dim>>(lay_out<Dim>(std::span(nodes)));
}

/// Bodies that touch lightly, and the pairs of nodes that their traversals test.
template <int Dim>
struct Scene {
    std::vector<Body<Dim>> bodies;  ///< 2 i meets 2 i + 1
    struct Tested {
        std::int32_t body, a, b;
    };
    std::vector<Tested> tested;
    std::vector<std::vector<Sphere<Dim>>> spheres;  ///< of each body, world frame

    Scene(int pairs, int deep) {
        const auto tree = cube_tree<Dim>(deep);
        for (int i = 0; i < pairs; ++i) {
            Body<Dim> body;
            body.tree = tree;
            Spin<Dim> turn = Spin<Dim>::Constant(0.1 + 0.37 * i);
            body.orientation = Space<Dim>::turned(body.orientation, turn);
            bodies.push_back(body);
            body.position = Vector<Dim>::Constant(0.02) + 1.1 * Vector<Dim>::Unit(i % Dim);
            turn *= -0.7;
            body.orientation = Space<Dim>::turned(body.orientation, turn);
            bodies.push_back(body);
        }
        carry();
        for (std::int32_t i = 0; i < pairs; ++i) record(2 * i);
    }

    void carry() {
        for (const Body<Dim>& body : bodies) {
            const Matrix<Dim> rotation = Space<Dim>::rotation(body.orientation);
            auto& carried = spheres.emplace_back();
            for (int node = 0; node < body.tree->size(); ++node) {
                Sphere<Dim> sphere = body.tree->sphere(node);
                sphere.centre = body.position + rotation * sphere.centre;
                carried.push_back(sphere);
            }
        }
    }
    void record(std::int32_t body) {
        const auto b = static_cast<std::size_t>(body);
        const SphereTree<Dim>& tree = *bodies[b].tree;
        tested.push_back({body, 0, 0});
        for (const Front& front : traverse_levels(bodies[b], bodies[b + 1])) {
            if (front.finest) break;
            for (const auto& [m, n] : front.pairs)
                for (int i = 0; i < tree.child_count[tree.index(m)]; ++i)
                    for (int k = 0; k < tree.child_count[tree.index(n)]; ++k)
                        tested.push_back({body, tree.first_child[tree.index(m)] + i,
                                          tree.first_child[tree.index(n)] + k});
        }
    }
};

/// One sphere after the other, from arrays of structures that stand in the world frame already.
template <int Dim>
std::size_t plain_loop(const Scene<Dim>& scene, std::vector<NodePair>& found) {
    found.clear();
    for (const auto& [body, a, b] : scene.tested) {
        const auto i = static_cast<std::size_t>(body);
        if (overlap(scene.spheres[i][static_cast<std::size_t>(a)],
                    scene.spheres[i + 1][static_cast<std::size_t>(b)]))
            found.push_back({a, b});
    }
    return found.size();
}

template <int Dim>
class Traverser {
  public:
    explicit Traverser(const Scene<Dim>& scene) : scene_(scene), world_S_(scene.bodies.size()) {}

    /// Poses the bodies and refines every pair to the finest level.
    std::uint64_t run(Budget budget) {
        std::uint64_t tests = 0;
        for (std::size_t i = 0; i < world_S_.size(); ++i) world_S_[i].pose(scene_.bodies[i]);
        for (std::size_t i = 0; i < world_S_.size(); i += 2) {
            list_.clear();
            test_roots(world_S_[i], world_S_[i + 1], front_, list_);
            while (!front_.finest && refine(world_S_[i], world_S_[i + 1], budget, front_, list_) ==
                                         Refinement::finished) {
            }
            tests += front_.tests;
        }
        return tests;
    }

  private:
    const Scene<Dim>& scene_;
    std::vector<PosedTree<Dim>> world_S_;
    ListedFront front_;
    FrontList list_;
};

template <int Dim>
void report(const char* where, int pairs, int deep, int repeats) {
    const Scene<Dim> scene(pairs, deep);
    Traverser<Dim> traverser(scene);
    std::vector<NodePair> found;
    if (traverser.run(Budget::unlimited()) != scene.tested.size()) std::abort();
    std::size_t hits = plain_loop(scene, found);
    const auto time = bench::medians(
        repeats, [&] { hits += plain_loop(scene, found); },
        [&] { hits += traverser.run(Budget::unlimited()); },
        [&] { hits += traverser.run(Budget::node_tests(1u << 30, 1.0)); });
    const double tests = static_cast<double>(scene.tested.size());
    std::printf(
        "%s, %4d pairs, depth %d: %8.0f tests, %4.1f %% overlap: plain loop %6.1f, traversal "
        "%6.1f, "
        "with a quota %6.1f million a second; traversal / loop %.2f\n",
        where, pairs, deep, tests, 100.0 * static_cast<double>(found.size()) / tests,
        tests / time[0] / 1e6, tests / time[1] / 1e6, tests / time[2] / 1e6, time[0] / time[1]);
    if (hits == 0) std::puts("nothing overlapped");  // keeps the work from being left out
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 51;
    report<2>("plane", 100, 4, repeats);
    report<2>("plane", 1000, 4, repeats);
    report<2>("plane", 20, 7, repeats);
    report<3>("space", 100, 3, repeats);
    report<3>("space", 10, 5, repeats);
    std::puts(
        "The traversal also carries nodes to the world frame, lists what overlaps and asks the\n"
        "budget; the loop's spheres stand in the world already and its list of tests is given.\n"
        "Limits: the loop, the branch on the outcome (a hundred small pairs a processor learns by\n"
        "heart); the traversal, what it does once a pose, a level and a family, which few tests\n"
        "share in the plane; both, the memory where large trees leave the cache.");
}
