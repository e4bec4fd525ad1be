// Crowds of stars, gears and Ls in lodlab, Box2D 2.4 and Chipmunk 7: what a step takes, and how far
// an impact lies from the exact one. Usage: bench_engines [steps [CROWD ...]]      a step of each
// engine; gas:100 gas:1000 gas:5000
//        bench_engines error [IMPACTS [FILE.png]]   time against error, each engine over its
//        settings
// Times are medians of the thread's own processor time, all engines in one run.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/peers.hpp"
#include "bench/thread_clock.hpp"
#include "bench/timing.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/measure/degrade.hpp"
#include "lodlab/measure/first_impact.hpp"
#include "lodlab/scenes/crowd/crowds.hpp"
#include "lodlab/scenes/setup.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace {

constexpr double time_step = 1.0 / 60;
constexpr int warm_up = 20;  ///< steps that are not counted
constexpr int counted = 60;

/// One engine with its settings: how a world of it is made.
struct Engine {
    std::string name;
    std::string curve;  ///< of the plot; empty: not there
    int steps;          ///< that a frame is cut into
    std::function<std::unique_ptr<bench::Peer>(std::span<const lod::Body<2>>, bench::Shapes)> make;
};

/// lodlab down to a level, or with the true shapes of every pair, as a peer of the others.
class Lodlab final : public bench::Peer {
  public:
    Lodlab(std::span<const lod::Body<2>> bodies, int level, lod::Finest finest)
        : bodies_(bodies.begin(), bodies.end()) {
        settings_.deepest_level = level;
        settings_.finest.level = finest;
        settings_.finest.most_pairs = static_cast<int>(8 * bodies.size());
    }
    void step(double seconds) override {
        settings_.time_step = seconds;
        lod::Budget budget = lod::Budget::unlimited();
        lod::advance<2>(bodies_, settings_, budget, storage_);
    }
    void read(std::span<lod::Body<2>> bodies) const override {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            bodies[i].velocity = bodies_[i].velocity;
            bodies[i].spin = bodies_[i].spin;
        }
    }

  private:
    std::vector<lod::Body<2>> bodies_;
    lod::FrameSettings settings_;
    lod::FrameStorage<2> storage_;
};

std::string in_steps(const std::string& name, int steps) {
    return steps == 1 ? name : name + ", " + std::to_string(steps) + " steps";
}
Engine lodlab(int level, const char* curve = "lodlab", int steps = 1) {
    return {in_steps("lodlab, level " + std::to_string(level), steps), curve, steps,
            [=](auto bodies, auto) {
                return std::make_unique<Lodlab>(bodies, level, lod::Finest::leaves);
            }};
}
Engine exact_lodlab(int level, const char* curve) {
    return {"lodlab, true shapes", curve, 1, [=](auto bodies, auto) {
                return std::make_unique<Lodlab>(bodies, level, lod::Finest::exact);
            }};
}
Engine box2d(int iterations, const char* curve, int steps = 1) {
    return {in_steps("Box2D, " + std::to_string(iterations) + " iterations", steps), curve, steps,
            [=](auto bodies, auto shapes) { return bench::box2d(bodies, shapes, iterations); }};
}
Engine chipmunk(int iterations, const char* curve, int steps = 1) {
    return {in_steps("Chipmunk, " + std::to_string(iterations) + " iterations", steps), curve,
            steps,
            [=](auto bodies, auto shapes) { return bench::chipmunk(bodies, shapes, iterations); }};
}

/// A frame of an engine.
void advance(const Engine& engine, bench::Peer& world) {
    for (int step = 0; step < engine.steps; ++step) world.step(time_step / engine.steps);
}

double thread_seconds() {
    return std::chrono::duration<double>(bench::ThreadClock().now()).count();
}

struct Taken {
    double seconds = 0;  ///< median of a step
    double energy = 0;   ///< at the end over the start
};

struct Crowd {
    std::vector<lod::Body<2>> bodies;
    std::vector<const bench::PiecedShape*> shapes;  ///< of each
};

/// Runs a crowd in every engine, step by step in turn.
std::vector<Taken> run(const Crowd& crowd, const std::vector<Engine>& engines) {
    std::vector<std::unique_ptr<bench::Peer>> worlds;
    for (const Engine& engine : engines) worlds.push_back(engine.make(crowd.bodies, crowd.shapes));
    std::vector<std::vector<double>> times(engines.size());
    for (int step = 0; step < warm_up + counted; ++step)
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            const double start = thread_seconds();
            advance(engines[i], *worlds[i]);
            if (step >= warm_up) times[i].push_back(thread_seconds() - start);
        }
    const double energy = lod::kinetic_energy<2>(crowd.bodies);
    std::vector<Taken> taken;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        std::vector<lod::Body<2>> end = crowd.bodies;
        worlds[i]->read(end);
        taken.push_back({bench::median(times[i]), lod::kinetic_energy<2>(end) / energy});
    }
    return taken;
}

const std::vector<bench::PiecedShape>& shapes() {
    static const std::vector<bench::PiecedShape> all = bench::pieced_shapes();
    return all;
}

/// The bodies of a crowd by name, made of the shapes that every engine can take.
Crowd crowd_of(const std::string& spec, int branching, int depth) {
    std::vector<std::shared_ptr<const lod::SphereTree<2>>> trees;
    std::vector<std::shared_ptr<const lod::ExactShape<2>>> exact;
    for (const bench::PiecedShape& made : shapes()) {
        trees.push_back(std::make_shared<const lod::SphereTree<2>>(
            lod2d::build_tree(made.shape, {.branching = branching, .depth = depth})));
        exact.push_back(scenes::Shapes<2>::exact_of(made.shape));
    }
    Crowd crowd{scenes::set_up<2>(scenes::crowd(spec)).bodies, {}};
    for (std::size_t i = 0; i < crowd.bodies.size(); ++i) {
        lod::Body<2>& body = crowd.bodies[i];
        const std::size_t kind = i % trees.size();
        crowd.shapes.push_back(body.is_static() ? nullptr : &shapes()[kind]);
        if (body.is_static()) continue;
        const lod2d::Shape& shape = shapes()[kind].shape;
        lod::set_mass<2>(body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
        body.tree = trees[kind];
        body.exact = exact[kind];
    }
    return crowd;
}

void measure_steps(const std::vector<std::string>& specs) {
    const std::vector<Engine> peers{box2d(8, ""), chipmunk(10, "")};
    for (const std::string& spec : specs) {
        std::printf("%s\n", spec.c_str());
        for (const auto& [branching, depth] : {std::pair(4, 4), std::pair(8, 3)}) {
            std::vector<Engine> engines = peers;
            engines.push_back(lodlab(depth));
            const std::vector<Taken> taken = run(crowd_of(spec, branching, depth), engines);
            const double faster = std::min(taken[0].seconds, taken[1].seconds);
            for (std::size_t i = 0; i < engines.size(); ++i)
                std::printf("  %-26s %9.4f ms  %6.2f x  energy %.4f%s\n", engines[i].name.c_str(),
                            1e3 * taken[i].seconds, faster / taken[i].seconds, taken[i].energy,
                            i == 2 ? (branching == 4 ? "  (4 children)" : "  (8 children)") : "");
        }
    }
}

using Approach = measure::Approach<2>;

/// How far the impulse that an engine gives to an impact of two bodies lies from the exact one,
/// over that one; 1 where they pass through each other.
double error_of(const Engine& engine, const Approach& approach) {
    const std::vector<lod::Body<2>> start{approach.a, approach.b};
    const bench::PiecedShape* const kinds[] = {
        &shapes()[static_cast<std::size_t>(approach.shape_a)],
        &shapes()[static_cast<std::size_t>(approach.shape_b)]};
    const std::unique_ptr<bench::Peer> world = engine.make(start, kinds);
    std::vector<lod::Body<2>> now = start;
    // To the end of the first frame in which something pushes.
    bool pushed = false;
    for (double time = 0; !pushed && time < approach.time + measure::patience; time += time_step) {
        advance(engine, *world);
        world->read(now);
        pushed = (now[1].velocity - start[1].velocity).norm() > 1e-6;
    }
    std::vector<lod::Body<2>> touch{approach.touch.a, approach.touch.b};
    std::vector<lod::Impact<2>> impacts;
    for (const lod::Contact<2>& contact : approach.touch.contacts)
        impacts.push_back({0, 1, 0, contact});
    std::vector<double> impulses(impacts.size());
    lod::Resolver<2>().resolve(lod::Response::net, impacts, touch, impulses);
    const lod::Vector<2> exact = touch[1].velocity - approach.b.velocity;
    return (now[1].velocity - approach.b.velocity - exact).norm() / exact.norm();
}

/// Impacts of the bodies that crowds are made of, at their speeds.
std::vector<Approach> approaches(int impacts) {
    std::vector<measure::MeasuredShape<2>> measured;
    scenes::TreeChoice tree;
    tree.branching = 4;
    tree.depth = 4;
    for (const bench::PiecedShape& made : shapes())
        measured.push_back(measure::measured_shape<2>(made.shape.name, made.shape, tree, {}));
    measure::EnsembleSettings settings;
    settings.speed = 4;
    settings.spin = 4;
    std::vector<Approach> all;
    for (int i = 0; i < impacts; ++i)
        all.push_back(measure::draw_approach<2>(measured, settings, static_cast<std::uint64_t>(i),
                                                time_step));
    return all;
}

std::vector<Engine> settings_of_all() {
    std::vector<Engine> engines;
    for (int level = 0; level <= 4; ++level) engines.push_back(lodlab(level, "lodlab, by level"));
    engines.push_back(exact_lodlab(4, "lodlab, by level"));
    for (const int steps : {1, 2, 4, 8}) engines.push_back(lodlab(4, "lodlab, by steps", steps));
    for (const int iterations : {1, 20}) engines.push_back(box2d(iterations, ""));
    for (const int steps : {1, 2, 4, 8}) engines.push_back(box2d(8, "Box2D", steps));
    for (const int iterations : {1, 30}) engines.push_back(chipmunk(iterations, ""));
    for (const int steps : {1, 2, 4, 8}) engines.push_back(chipmunk(10, "Chipmunk", steps));
    return engines;
}

void draw(const std::vector<viz::Curve>& curves, int impacts, const char* picture) {
    const viz::Axes axes{{"time of a frame [ms]", viz::Scale::logarithmic, {}, false},
                         {"error of an impulse, median [%]", viz::Scale::logarithmic, {}, false}};
    viz::write_png(
        picture,
        viz::plot(
            "What an engine's time buys: a crowd of 1,000 in the plane", axes, curves,
            "Time: a frame of 1/60 s of a dense gas. Error: of impacts of two of its bodies, "
            "against the exact one. lodlab from level 0 to 4 and the true shapes; at level 4, "
            "as Box2D 2.4 and Chipmunk 7, with frames in 1 to 8 steps.",
            impacts),
        {});
}

void measure_errors(int impacts, const char* picture) {
    const std::vector<Engine> engines = settings_of_all();
    const std::vector<Taken> taken = run(crowd_of("gas:1000", 4, 4), engines);
    const std::vector<Approach> all = approaches(impacts);
    std::vector<viz::Curve> curves;
    for (std::size_t i = 0; i < engines.size(); ++i) {
        std::vector<double> errors;
        for (const Approach& approach : all) errors.push_back(error_of(engines[i], approach));
        std::sort(errors.begin(), errors.end());
        const auto at = [&](double share) {
            return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
        };
        std::printf("%-34s %9.4f ms a frame, error %.4f (median) %.4f (90 %%), energy %.4f\n",
                    engines[i].name.c_str(), 1e3 * taken[i].seconds, at(0.5), at(0.9),
                    taken[i].energy);
        if (engines[i].curve.empty()) continue;
        if (curves.empty() || curves.back().name != engines[i].curve) {
            const bool is_ours = engines[i].curve.starts_with("lodlab");
            curves.push_back(
                {engines[i].curve, {}, {}, {}, static_cast<int>(curves.size()), !is_ours, true});
        }
        curves.back().points.push_back({1e3 * taken[i].seconds, 100 * at(0.5)});
    }
    if (picture != nullptr) draw(curves, impacts, picture);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "error") == 0) {
        measure_errors(argc > 2 ? std::atoi(argv[2]) : 1000, argc > 3 ? argv[3] : nullptr);
        return 0;
    }
    std::vector<std::string> specs(argv + std::min(argc, 2), argv + argc);
    if (specs.empty()) specs = {"gas:100", "gas:1000", "gas:5000"};
    measure_steps(specs);
}
