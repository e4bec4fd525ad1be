// Node tests per second: the traversal (lod::refine), by each way of computing that the machine
// has, against two plain loops over the very same pairs of spheres, in one run.
//
// bench_node_tests [REPEATS]

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>

#include "bench/timing.hpp"
#include "lodlab/core/tree/family_tests.hpp"

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
    /// Of two families that are tested all against all: each coordinate of all, then all radii.
    struct Block {
        static constexpr int width = 1 << Dim;
        float a[Dim + 1][width];
        float b[Dim + 1][width];
    };
    std::vector<Block> blocks;
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
            for (const auto& [m, n] : front.pairs) {
                blocks.push_back(
                    block_of(b, tree.first_child[tree.index(m)], tree.first_child[tree.index(n)]));
                for (int i = 0; i < tree.child_count[tree.index(m)]; ++i)
                    for (int k = 0; k < tree.child_count[tree.index(n)]; ++k)
                        tested.push_back({body, tree.first_child[tree.index(m)] + i,
                                          tree.first_child[tree.index(n)] + k});
            }
        }
    }
    /// Seen from the first body, as a loop would have it that needs no tree.
    Block block_of(std::size_t body, std::int32_t first_a, std::int32_t first_b) const {
        Block block;
        const auto copy = [&](const Sphere<Dim>& sphere, int i, float(&to)[Dim + 1][Block::width]) {
            const Vector<Dim> centre = sphere.centre - bodies[body].position;
            for (int d = 0; d < Dim; ++d) to[d][i] = static_cast<float>(centre[d]);
            to[Dim][i] = static_cast<float>(sphere.radius);
        };
        for (int i = 0; i < Block::width; ++i) {
            copy(spheres[body][static_cast<std::size_t>(first_a + i)], i, block.a);
            copy(spheres[body + 1][static_cast<std::size_t>(first_b + i)], i, block.b);
        }
        return block;
    }
};

/// Families against families, laid out one after the other, no tree, no pose, no list: only
/// counted. What the compiler makes of it for the newest instructions that the machine has.
template <int Dim>
[[gnu::always_inline]] inline std::size_t count_meeting(const typename Scene<Dim>::Block* block,
                                                        std::size_t count) {
    constexpr int width = Scene<Dim>::Block::width;
    std::size_t met = 0;
    for (const auto* const end = block + count; block != end; ++block) {
        std::int32_t here = 0;
        for (int i = 0; i < width; ++i)
            for (int k = 0; k < width; ++k) {
                float squared = 0;
                for (int d = 0; d < Dim; ++d)
                    squared +=
                        (block->b[d][k] - block->a[d][i]) * (block->b[d][k] - block->a[d][i]);
                const float reach = block->b[Dim][k] + block->a[Dim][i];
                here += squared <= reach * reach;
            }
        met += static_cast<std::size_t>(here);
    }
    return met;
}
#if defined(__x86_64__) && !defined(__clang__)
#define BEST_INSTRUCTIONS [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define BEST_INSTRUCTIONS
#endif
BEST_INSTRUCTIONS std::size_t loop_over_blocks(const Scene<2>::Block* block, std::size_t count) {
    return count_meeting<2>(block, count);
}
BEST_INSTRUCTIONS std::size_t loop_over_blocks(const Scene<3>::Block* block, std::size_t count) {
    return count_meeting<3>(block, count);
}

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
    const auto times = static_cast<int>(20'000'000 / scene.tested.size()) + 1;
    std::vector<std::function<void()>> works;
    const auto add = [&](const auto& work) {
        works.emplace_back([&hits, times, work] {
            for (int i = 0; i < times; ++i) hits += work();
        });
    };
    add([&] { return plain_loop(scene, found); });
    add([&] { return loop_over_blocks(scene.blocks.data(), scene.blocks.size()); });
    for (const detail::TestPath& path : detail::test_paths())
        for (const bool quota : {false, true})
            add([&, quota] {
                detail::take_path(path);
                return traverser.run(quota ? Budget::node_tests(1u << 30, 1.0)
                                           : Budget::unlimited());
            });
    const auto taken = bench::medians_of(repeats, works);
    const double tests = static_cast<double>(scene.tested.size());
    const auto a_ns = [&](std::size_t i) { return 1e-9 * tests * times / taken[i]; };
    std::printf(
        "%s, %d pairs, depth %d: %.0f tests, %.1f %% overlap; tests a ns: loop %.2f, loop over "
        "blocks %.2f",
        where, pairs, deep, tests, 100.0 * static_cast<double>(found.size()) / tests, a_ns(0),
        a_ns(1));
    for (std::size_t i = 0; i < detail::test_paths().size(); ++i)
        std::printf("; %s %.2f, with a quota %.2f", detail::test_paths()[i].name.data(),
                    a_ns(2 + 2 * i), a_ns(3 + 2 * i));
    std::printf("\n");
    if (hits == 0) std::puts("nothing overlapped");  // keeps the work from being left out
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 11;
    report<2>("plane", 100, 4, repeats);
    report<2>("plane", 1000, 4, repeats);
    report<2>("plane", 20, 7, repeats);
    report<3>("space", 100, 3, repeats);
    report<3>("space", 10, 5, repeats);
    std::puts(
        "The traversal also poses the bodies, finds the families, lists what overlaps and asks "
        "the\n"
        "budget. The loop goes from sphere to sphere in the world frame, with the list of tests "
        "given;\n"
        "the loop over blocks has families laid out one after the other and only counts.");
}
