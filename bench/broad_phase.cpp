// What it takes to find the pairs of bodies that are near, in crowds of every kind, and to sweep
// bodies that are fast.
// Usage: bench_broad_phase [MOST_BODIES]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/timing.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/frame/integrate.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace {

constexpr double time_step = 1.0 / 60;
constexpr int frames = 31;
constexpr double radius = 0.5;  ///< of a body, but where sizes differ [m]

template <int Dim>
std::shared_ptr<const lod::SphereTree<Dim>> ball(double r) {
    return std::make_shared<const lod::SphereTree<Dim>>(
        lod::single_sphere<Dim>({lod::Vector<Dim>::Zero(), r}));
}

template <int Dim>
lod::Vector<Dim> anywhere(lod::Random& random, double size) {
    lod::Vector<Dim> v;
    for (double& number : v) number = random.next(-size, size);
    return v;
}

/// Balls of one size in a lattice, shaken, and half-spaces around it.
template <int Dim>
std::vector<lod::Body<Dim>> in_a_box(int count, double pitch) {
    const auto tree = ball<Dim>(radius);
    const int side = static_cast<int>(std::ceil(std::pow(count, 1.0 / Dim) - 1e-9));
    const double half = 0.5 * pitch * side + 0.1;
    lod::Random random(5);
    std::vector<lod::Body<Dim>> bodies(static_cast<std::size_t>(count));
    int number = 0;
    for (lod::Body<Dim>& body : bodies) {
        int rest = number++;
        for (double& x : body.position) {
            x = (rest % side + 0.5) * pitch - 0.5 * pitch * side;
            rest /= side;
        }
        body.position += anywhere<Dim>(random, 0.475 * (pitch - 1));
        body.velocity = anywhere<Dim>(random, 4);
        body.tree = tree;
        lod::set_mass<Dim>(body, 1, lod::Inertia<Dim>::Identity());
    }
    for (int side_of_box = 0; side_of_box < 2 * Dim; ++side_of_box) {
        const lod::Vector<Dim> outwards =
            (side_of_box % 2 == 0 ? 1 : -1) * lod::Vector<Dim>::Unit(side_of_box / 2);
        lod::Body<Dim>& wall = bodies.emplace_back();
        lod::make_static(wall);
        wall.tree = std::make_shared<const lod::SphereTree<Dim>>(lod::half_space<Dim>(-outwards));
        wall.position = half * outwards;
    }
    return bodies;
}

/// Boxes with trees in place of the half-spaces of in_a_box().
std::vector<lod::Body<2>> between_trees(std::vector<lod::Body<2>> bodies) {
    const double thick = 0.5;
    double half = 0;
    for (const lod::Body<2>& body : bodies)
        if (body.is_static()) half = std::max(half, body.position.norm());
    const lod2d::Shape shape =
        lod2d::generate("box:" + std::to_string(2 * half) + "," + std::to_string(thick));
    const auto tree =
        std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(shape, {.depth = 4}));
    for (lod::Body<2>& body : bodies) {
        if (!body.is_static()) continue;
        body.tree = tree;
        body.orientation = body.position.y() == 0 ? std::acos(0.0) : 0;
        body.position *= 1 + 0.5 * thick / half;
    }
    return bodies;
}

template <int Dim>
std::vector<lod::Body<Dim>> imploding(int count) {
    auto bodies = in_a_box<Dim>(count, 1.6);
    for (lod::Body<Dim>& body : bodies)
        if (!body.is_static())
            body.velocity = 0.075 * body.velocity - 4 * body.position.normalized();
    return bodies;
}

template <int Dim>
using Place = std::function<lod::Vector<Dim>(int, lod::Random&)>;

/// Balls that go through each other.
template <int Dim>
std::vector<lod::Body<Dim>> placed(int count, const Place<Dim>& place,
                                   const std::function<double(lod::Random&)>& size = {}) {
    lod::Random random(7);
    const auto tree = ball<Dim>(radius);
    std::vector<lod::Body<Dim>> bodies(static_cast<std::size_t>(count));
    int number = 0;
    for (lod::Body<Dim>& body : bodies) {
        body.tree = size ? ball<Dim>(size(random)) : tree;
        body.position = place(number++, random);
        body.velocity = anywhere<Dim>(random, 1);
        lod::set_mass<Dim>(body, 1, lod::Inertia<Dim>::Identity());
    }
    return bodies;
}

/// Median time of a search, frame after frame. With impacts, or freely.
template <int Dim>
void measure(const char* name, std::vector<lod::Body<Dim>> bodies, int frames_before,
             bool with_impacts) {
    lod::FrameStorage<Dim> storage;
    lod::BroadPhase<Dim> broad_phase;
    std::vector<lod::PosedTree<Dim>> world_S(bodies.size());
    std::vector<lod::CandidatePair> pairs;
    std::vector<double> taken;
    for (int frame = 0; frame < frames_before + frames; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        if (with_impacts)
            lod::advance<Dim>(bodies, {.time_step = time_step}, budget, storage);
        else
            lod::integrate<Dim>(bodies, time_step);
        if (frame < frames_before) continue;
        for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
        taken.push_back(bench::seconds([&] { broad_phase.find(bodies, world_S, pairs); }));
    }
    const auto count = static_cast<double>(bodies.size());
    std::printf(
        "%-22s %d axes %7zu bodies %8zu pairs %9.3f ms %7.1f ns a body %6.1f steps a body\n", name,
        Dim, bodies.size(), pairs.size(), 1e3 * bench::median(taken),
        1e9 * bench::median(taken) / count, static_cast<double>(broad_phase.steps()) / count);
}

/// One sweep of balls of which most are fast.
template <int Dim>
void measure_sweep(int count) {
    std::vector<lod::Body<Dim>> bodies = in_a_box<Dim>(count, 1.9);
    for (lod::Body<Dim>& body : bodies) body.velocity *= 20;
    lod::Sweeper<Dim> sweeper;
    std::vector<lod::SweptImpact<Dim>> found;
    const double taken =
        bench::seconds([&] { sweeper.advance(bodies, time_step, {.on = true}, {}, found); });
    const auto each = static_cast<double>(bodies.size() + found.size());
    std::printf("%-22s %d axes %7zu bodies %8zu impacts %7.3f ms %7.1f ns and %.1f steps each\n",
                "a sweep of fast balls", Dim, bodies.size(), found.size(), 1e3 * taken,
                1e9 * taken / each, static_cast<double>(sweeper.steps()) / each);
}

template <int Dim>
void measure_odd(int count) {
    const double room = 0.65 * std::pow(count, 1.0 / Dim);
    const Place<Dim> spread = [&](int, lod::Random& random) { return anywhere<Dim>(random, room); };
    measure<Dim>("sizes 1:1000",
                 placed<Dim>(count, spread,
                             [](lod::Random& random) {
                                 const double least = random.next() < 0.9 ? -2 : 0;
                                 return 5 * std::pow(10, random.next(-3, least));
                             }),
                 0, false);
    measure<Dim>("a row",
                 placed<Dim>(count,
                             [](int i, lod::Random& random) {
                                 lod::Vector<Dim> place = lod::Vector<Dim>::Zero();
                                 place[0] = 1.1 * i;
                                 place[1] = random.next(-0.1, 0.1);
                                 return place;
                             }),
                 0, false);
    for (const double far : {1e9, -1e9})
        measure<Dim>(far > 0 ? "one 1e9 m away" : "one -1e9 m away",
                     placed<Dim>(count,
                                 [&](int i, lod::Random& random) {
                                     lod::Vector<Dim> place = spread(i, random);
                                     if (i == 0) place[0] = far;
                                     return place;
                                 }),
                     0, false);
    measure<Dim>(
        "1000 at one place",
        placed<Dim>(1000, [](int, lod::Random& random) { return anywhere<Dim>(random, 0.1); }), 0,
        false);
}

}  // namespace

int main(int argc, char** argv) {
    const int most = argc > 1 ? std::atoi(argv[1]) : 64000;
    for (const int count : {1000, 5000, 50000}) {
        if (count > most) continue;
        measure<2>("gas", in_a_box<2>(count, 1.1), 60, true);
        measure<2>("gas, walls with trees", between_trees(in_a_box<2>(count, 1.1)), 0, false);
        measure<2>("sparse", in_a_box<2>(count, 1.9), 60, true);
        measure<2>("implode", imploding<2>(count), count < 5000 ? 300 : 500, true);
        measure_odd<2>(count);
        measure_sweep<2>(count);
    }
    for (const int count : {1000, 8000, 64000}) {
        if (count > most) continue;
        measure<3>("cube", in_a_box<3>(count, 1.3), 30, true);
        measure_odd<3>(count);
        measure_sweep<3>(count);
    }
}
