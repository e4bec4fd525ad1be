// What a contact costs in each response, by the number of contacts of one collision: a box that
// falls on a face, its contacts along the face. The claims (i) and (ii) of section 5.1: an impulse
// takes a constant time, and the response is linear in the intersections.
//
// bench_responses [REPEATS] [PICTURE.png]

#include <cstdio>
#include <cstdlib>

#include "bench/timing.hpp"
#include "lodlab/core/response/response.hpp"
#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace {

using namespace lod;

/// A box that falls flat, and so many contacts along its lower face.
struct Landing {
    std::vector<Body<2>> bodies{2};
    std::vector<Impact<2>> impacts;

    explicit Landing(int contacts) {
        make_static(bodies[0]);
        set_mass<2>(bodies[1], 1, Inertia<2>::Constant(5.0 / 12));
        bodies[1].position = {0, 0.5};
        bodies[1].velocity = {0.3, -1};
        bodies[1].spin[0] = 0.2;
        for (int k = 0; k < contacts; ++k) {
            const double x = contacts == 1 ? 0.3 : 2.0 * k / (contacts - 1) - 1;
            impacts.push_back({0, 1, 0, {{x, 0}, {0, 1}, 0}});
        }
    }
};

struct Named {
    const char* name;
    Response response;
    int most;  ///< contacts: beyond, the reference takes seconds
};
constexpr Named responses[] = {
    {"net", Response::net, 4096},   {"sum", Response::sum, 4096},
    {"mean", Response::mean, 4096}, {"sequential", Response::sequential, 4096},
    {"lcp", Response::lcp, 64},     {"reflections", Response::reflections, 64}};

/// Median nanoseconds a contact.
double cost(const Landing& landing, Response response, int repeats) {
    Resolver<2> resolver;
    std::vector<double> impulses;
    std::vector<Body<2>> bodies = landing.bodies;
    const auto contacts = static_cast<double>(landing.impacts.size());
    const int calls = std::max(1, static_cast<int>(20000 / contacts));
    std::vector<double> times;
    for (int repeat = 0; repeat < repeats; ++repeat)
        times.push_back(bench::seconds([&] {
            for (int call = 0; call < calls; ++call) {
                bodies = landing.bodies;
                resolver.resolve(response, landing.impacts, bodies, impulses);
            }
        }));
    return 1e9 * bench::median(times) / calls / contacts;
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 15;
    std::vector<viz::Curve> curves;
    for (const Named& named : responses) {
        curves.push_back({named.name, {}, {}, {}, static_cast<int>(curves.size()), false, true});
    }
    std::printf("ns a contact\n%9s", "contacts");
    for (const Named& named : responses) std::printf(" %12s", named.name);
    std::printf("   net / net at 64\n");
    double net_at_64 = cost(Landing(64), Response::net, repeats);
    for (int contacts = 1; contacts <= 4096; contacts *= 4) {
        const Landing landing(contacts);
        std::printf("%9d", contacts);
        double net = 0;
        for (std::size_t k = 0; k < std::size(responses); ++k) {
            if (contacts > responses[k].most) {
                std::printf(" %12s", "");
                continue;
            }
            const double nanoseconds = cost(landing, responses[k].response, repeats);
            if (responses[k].response == Response::net) net = nanoseconds;
            curves[k].points.push_back({static_cast<double>(contacts), nanoseconds});
            std::printf(" %12.1f", nanoseconds);
        }
        std::printf("   %.2f\n", net / net_at_64);
    }
    if (argc <= 2) return 0;
    const viz::Axes axes{{"contacts of one collision", viz::Scale::logarithmic, {}, false},
                         {"time of a contact [ns]", viz::Scale::logarithmic, {}, false}};
    viz::write_png(argv[2],
                   viz::plot("The net impulse costs each contact the same, however many there are",
                             axes, curves,
                             "A box that falls on a face; both axes are logarithmic. The LCP and "
                             "reflections are references."),
                   {});
}
