// A step of a crowd: a kinetic gas of stars, gears and Ls between four walls.
// Usage: bench_crowd [BODIES [FRAMES [DEPTH]]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "bench/timing.hpp"
#include "lodlab/core/frame.hpp"
#include "lodlab/core/random.hpp"
#include "lodlab/core/state_hash.hpp"
#include "lodlab/lod2d/build_tree.hpp"
#include "lodlab/lod2d/generators.hpp"

namespace {

constexpr double spacing = 1.6;  ///< [m] between bodies of about 1 m

struct Kind {
    lod2d::Shape shape;
    std::shared_ptr<const lod::SphereTree<2>> tree;
};

Kind kind_of(const char* spec, int depth) {
    Kind kind{lod2d::generate(spec), nullptr};
    kind.tree = std::make_shared<const lod::SphereTree<2>>(
        lod2d::build_tree(kind.shape, {.branching = 4, .depth = depth}));
    return kind;
}

/// Four boxes around a square of that half side.
void add_walls(double half, int depth, std::vector<lod::Body<2>>& bodies) {
    const double length = 2 * half + 4;
    const Kind wall = kind_of(("box:" + std::to_string(length) + ",2").c_str(), depth);
    for (int side = 0; side < 4; ++side) {
        lod::Body<2> body;
        lod::make_static(body);
        body.tree = wall.tree;
        body.orientation = side % 2 == 0 ? 0 : std::acos(0.0);
        body.position[side % 2 == 0 ? 1 : 0] = (side < 2 ? 1 : -1) * (half + 1);
        bodies.push_back(body);
    }
}

std::vector<lod::Body<2>> gas(int count, int depth) {
    const std::vector<Kind> kinds{kind_of("star:5", depth), kind_of("gear:9", depth),
                                  kind_of("L", depth)};
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    const double half = 0.5 * spacing * columns;
    lod::Random random(11);
    std::vector<lod::Body<2>> bodies;
    for (int i = 0; i < count; ++i) {
        const Kind& kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
        lod::Body<2> body;
        lod::set_mass(body, kind.shape.area, lod::Inertia<2>::Constant(kind.shape.second_moment));
        body.tree = kind.tree;
        body.position = {(i % columns + 0.5) * spacing - half,
                         (i / columns + 0.5) * spacing - half};
        body.orientation = random.next(0, 6);
        body.velocity = {random.next(-1, 1), random.next(-1, 1)};
        body.spin[0] = random.next(-2, 2);
        bodies.push_back(body);
    }
    add_walls(half, depth, bodies);
    return bodies;
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
    const int depth = argc > 3 ? std::atoi(argv[3]) : 4;
    std::vector<lod::Body<2>> bodies = gas(count, depth);
    lod::FrameStorage<2> storage;
    std::vector<double> taken;
    std::vector<double> contacts_a_pair;
    for (int frame = 0; frame < frames; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        const lod::FrameRecord<2>* record = nullptr;
        taken.push_back(bench::wall_seconds(
            [&] { record = &lod::advance<2>(bodies, {.time_step = 1.0 / 60}, budget, storage); }));
        for (const lod::PairRecord& pair : record->pairs)
            if (pair.contact_count > 0) contacts_a_pair.push_back(pair.contact_count);
    }
    if (contacts_a_pair.empty()) contacts_a_pair.push_back(0);
    std::printf(
        "%d bodies, depth %d: %.3f ms a step, %g contacts a touching pair (medians of %d "
        "frames), end %016llx\n",
        count, depth, 1e3 * bench::median(taken), bench::median(contacts_a_pair), frames,
        static_cast<unsigned long long>(lod::state_hash<2>(bodies)));
}
