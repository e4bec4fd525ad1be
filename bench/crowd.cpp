// A step of a crowd: a kinetic gas of stars, gears and Ls between four half-spaces.
// Usage: bench_crowd [BODIES [FRAMES [DEPTH]]]   a step, and what modelling a contact costs
//        bench_crowd claims [FILE.png]           what answering a contact costs, by their number

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/timing.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/frame/frame.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace {

constexpr double sparse = 1.6;  ///< [m] between bodies of about 1 m
constexpr double dense = 0.95;
constexpr double time_step = 1.0 / 60;

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

/// Four half-spaces around a square of that half side.
void add_walls(double half, std::vector<lod::Body<2>>& bodies) {
    for (const lod::Vector<2>& outwards : {lod::Vector<2>(1, 0), lod::Vector<2>(-1, 0),
                                           lod::Vector<2>(0, 1), lod::Vector<2>(0, -1)}) {
        lod::Body<2> body;
        lod::make_static(body);
        body.tree = std::make_shared<const lod::SphereTree<2>>(lod::half_space<2>(-outwards));
        body.position = half * outwards;
        bodies.push_back(body);
    }
}

std::vector<lod::Body<2>> gas(int count, int depth, double spacing) {
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
    add_walls(half, bodies);
    return bodies;
}

/// What modelling the fronts of an instant costs, in all models, and how many contacts come of it.
struct Modelling {
    double seconds = 0;
    double contacts = 0;
    double pairs = 0;  ///< that touch
};

constexpr lod::ContactModel models[] = {lod::ContactModel::centre_line,
                                        lod::ContactModel::node_normal, lod::ContactModel::hull};
constexpr const char* model_names[] = {"centre_line", "node_normal", "hull"};

/// The front of every pair once more, by one model. Requires: a frame that detect went through.
Modelling model_all(std::span<const lod::Body<2>> bodies, lod::ContactModel model,
                    lod::FrameStorage<2>& storage) {
    static lod::FrontContacts<2> front_contacts;
    static lod::FrontModel<2> front;
    Modelling sum;
    sum.seconds = bench::wall_seconds([&] {
        for (std::size_t p = 0; p < storage.candidates.size(); ++p) {
            const auto a = static_cast<std::size_t>(storage.candidates[p].a);
            const auto b = static_cast<std::size_t>(storage.candidates[p].b);
            if (storage.fronts.pairs(p).empty()) continue;
            front_contacts.model({storage.world_S[a], storage.world_S[b], storage.fronts.pairs(p)},
                                 {model}, lod::pair_motion(bodies[a], bodies[b], time_step), front);
            sum.contacts += static_cast<double>(front.contacts.size());
            sum.pairs += front.contacts.empty() ? 0 : 1;
        }
    });
    return sum;
}

/// What a step of the crowd takes, and what of it the contacts do.
void measure_steps(int count, int frames, int depth) {
    std::vector<lod::Body<2>> bodies = gas(count, depth, sparse);
    lod::FrameStorage<2> storage;
    std::vector<double> taken;
    std::vector<double> contacts_a_pair;
    std::vector<double> row_visits;  ///< of a frame, for each of its contacts
    Modelling all[3];
    for (int frame = 0; frame < frames; ++frame) {
        lod::Budget budget = lod::Budget::unlimited();
        const lod::FrameRecord<2>* record = nullptr;
        taken.push_back(bench::wall_seconds(
            [&] { record = &lod::advance<2>(bodies, {.time_step = time_step}, budget, storage); }));
        for (const lod::PairRecord& pair : record->pairs)
            if (pair.contact_count > 0) contacts_a_pair.push_back(pair.contact_count);
        if (!record->impacts.empty())
            row_visits.push_back(static_cast<double>(record->response.row_visits) /
                                 static_cast<double>(record->impacts.size()));
        lod::detect<2>(bodies, {.time_step = time_step}, budget, storage);
        for (std::size_t m = 0; m < 3; ++m) {
            const Modelling one = model_all(bodies, models[m], storage);
            all[m].seconds += one.seconds;
            all[m].contacts += one.contacts;
            all[m].pairs += one.pairs;
        }
    }
    if (contacts_a_pair.empty()) contacts_a_pair.push_back(0);
    std::printf(
        "%d bodies, depth %d: %.3f ms a step, %g contacts a touching pair (medians of %d "
        "frames), end %016llx\n",
        count, depth, 1e3 * bench::median(taken), bench::median(contacts_a_pair), frames,
        static_cast<unsigned long long>(lod::state_hash<2>(bodies)));
    for (std::size_t m = 0; m < 3; ++m)
        std::printf("%s: %.3f us a touching pair to model, %.1f contacts each, %.3f us a contact\n",
                    model_names[m], 1e6 * all[m].seconds / all[m].pairs,
                    all[m].contacts / all[m].pairs, 1e6 * all[m].seconds / all[m].contacts);
    if (!row_visits.empty())
        std::printf("response: %.1f row visits a contact (median of frames), at most %.1f\n",
                    bench::median(row_visits),
                    *std::max_element(row_visits.begin(), row_visits.end()));
}

/// Nanoseconds that a response takes for each contact of an instant, the median of some repeats.
double cost(const std::vector<lod::Body<2>>& bodies, const std::vector<lod::Impact<2>>& impacts,
            lod::Response response, double& row_visits) {
    lod::Resolver<2> resolver;
    std::vector<double> impulses;
    std::vector<double> seconds;
    for (int repeat = 0; repeat < 21; ++repeat) {
        std::vector<lod::Body<2>> moved = bodies;
        lod::ResponseReport report;
        seconds.push_back(bench::wall_seconds(
            [&] { report = resolver.resolve(response, impacts, moved, impulses); }));
        row_visits = static_cast<double>(report.row_visits);
    }
    return 1e9 * bench::median(seconds) / static_cast<double>(impacts.size());
}

/// The claims of section 5.1 in crowds so dense that all touch: an impulse takes a constant time,
/// and the response depends on the number of intersections alone.
void measure_claims(const char* picture) {
    std::vector<viz::Curve> curves{{"net", {}, {}, {}, 0, false, true},
                                   {"sequential", {}, {}, {}, 1, false, true}};
    std::printf(
        "bodies contacts  net [ns a contact]  row visits a contact  sequential [ns a contact]\n");
    for (int count = 64; count <= 16384; count *= 2) {
        std::vector<lod::Body<2>> bodies = gas(count, 3, dense);
        lod::FrameStorage<2> storage;
        lod::Budget budget = lod::Budget::unlimited();
        for (int frame = 0; frame < 30; ++frame)
            lod::advance<2>(bodies, {.time_step = time_step}, budget, storage);
        const std::vector<lod::Impact<2>> impacts =
            lod::detect<2>(bodies, {.time_step = time_step}, budget, storage).impacts;
        double visits = 0;
        double none = 0;
        const double net = cost(bodies, impacts, lod::Response::net, visits);
        const double sequential = cost(bodies, impacts, lod::Response::sequential, none);
        const auto contacts = static_cast<double>(impacts.size());
        curves[0].points.push_back({contacts, net});
        curves[1].points.push_back({contacts, sequential});
        std::printf("%6d %8zu %18.0f %21.2f %26.0f\n", count, impacts.size(), net,
                    visits / contacts, sequential);
    }
    if (picture == nullptr) return;
    const viz::Axes axes{{"contacts of the crowd", viz::Scale::logarithmic, {}, false},
                         {"time of a contact [ns]", viz::Scale::logarithmic, {}, false}};
    viz::write_png(
        picture,
        viz::plot("In a crowd, too, a contact costs the same however many there are", axes, curves,
                  "A dense gas of stars, gears and Ls, 64 to 16,384 bodies. The last two "
                  "crowds outgrow the processor's cache. The sequential response is a "
                  "reference."),
        {});
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "claims") {
        measure_claims(argc > 2 ? argv[2] : nullptr);
        return 0;
    }
    measure_steps(argc > 1 ? std::atoi(argv[1]) : 1000, argc > 2 ? std::atoi(argv[2]) : 60,
                  argc > 3 ? std::atoi(argv[3]) : 4);
}
