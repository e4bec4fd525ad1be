#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/instant.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/numbers.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/draw/draw_projection.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

template <int Dim>
std::string name_of(const scenes::Setup<Dim>& setup, std::int32_t body) {
    return setup.scene.bodies[static_cast<std::size_t>(body)].name;
}

template <int Dim>
Json contacts_of(const Instant<Dim>& instant, const lod::PairRecord& pair) {
    Json list = Json::array();
    for (std::int32_t k = 0; k < pair.contact_count; ++k) {
        const lod::Contact<Dim>& contact =
            instant.record.impacts[static_cast<std::size_t>(pair.first_contact + k)].contact;
        list.push_back({{"point", list_of(contact.point)},
                        {"normal", list_of(contact.normal)},
                        {"depth", contact.depth}});
    }
    return list;
}

template <int Dim>
Json result_of(const scenes::Setup<Dim>& setup, const Instant<Dim>& instant) {
    Json pairs = Json::array();
    for (const lod::PairRecord& pair : instant.record.pairs) {
        Json levels = Json::array();
        std::uint64_t before = 0;
        for (const lod::Front& front : levels_of(instant, pair)) {
            levels.push_back({{"level", front.level},
                              {"tests", front.tests - before},
                              {"intersecting", front.pairs.size()}});
            before = front.tests;
        }
        if (pair.finest != lod::Finest::leaves)
            levels.push_back({{"level", "exact"},
                              {"tests", pair.tests - before},
                              {"intersecting", pair.contact_count > 0 ? 1 : 0}});
        pairs.push_back({{"a", name_of(setup, pair.bodies.a)},
                         {"b", name_of(setup, pair.bodies.b)},
                         {"verdict", lod::name_of(pair.verdict)},
                         {"levels", std::move(levels)},
                         {"contacts", contacts_of(instant, pair)}});
    }
    return {{"dim", Dim}, {"pairs", std::move(pairs)}};
}

template <int Dim>
std::string report_of(const scenes::Setup<Dim>& setup, const Instant<Dim>& instant) {
    std::string text = setup.scene.name + " at " + readable(instant.time) +
                       " s: " + std::to_string(instant.record.pairs.size()) + " candidate pairs\n";
    for (const lod::PairRecord& pair : instant.record.pairs) {
        text += "  " + name_of(setup, pair.bodies.a) + " and " + name_of(setup, pair.bodies.b) +
                ": " + (pair.verdict == lod::Verdict::apart ? "apart" : "") +
                (pair.verdict == lod::Verdict::possible ? "a possible collision" : "") +
                (pair.verdict == lod::Verdict::true_collision ? "a true collision" : "") + "\n";
        for (const lod::Front& front : levels_of(instant, pair))
            text += "    level " + std::to_string(front.level) + ": " +
                    std::to_string(front.pairs.size()) + " intersecting node pairs after " +
                    std::to_string(front.tests) + " tests\n";
        if (pair.finest != lod::Finest::leaves)
            text += "    exact: " + std::to_string(pair.contact_count) + " contacts\n";
    }
    return text;
}

viz::Figure projected(const viz::Actor<3>& a, const viz::Actor<3>& b,
                      const lod::FrameRecord<3>& record, const lod::PairRecord& pair) {
    if (pair.contact_count == 0)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "no two bodies touch at that instant; choose another by --at");
    return viz::projected_collision(a, b, record, pair);
}
viz::Figure projected(const viz::Actor<2>&, const viz::Actor<2>&, const lod::FrameRecord<2>&,
                      const lod::PairRecord&) {
    throw std::logic_error("the plane has no projection");
}

/// The traversal of the pair that took the most tests, or the projection of the one with the most
/// contacts: the one worth a look.
template <int Dim>
viz::Figure figure_of(const scenes::Setup<Dim>& setup, const Instant<Dim>& instant,
                      bool is_projected) {
    const auto& pairs = instant.record.pairs;
    const auto busiest =
        std::max_element(pairs.begin(), pairs.end(), [&](const auto& x, const auto& y) {
            return is_projected ? x.contact_count < y.contact_count : x.tests < y.tests;
        });
    if (busiest == pairs.end())
        throw lod::Error(
            lod::ErrorKind::input_refused,
            "no two bodies come near each other at " + readable(instant.time) +
                " s, so there is no traversal to draw; choose another instant by --at");
    const viz::Actor<Dim> a = actor_of(setup, instant.bodies, busiest->bodies.a);
    const viz::Actor<Dim> b = actor_of(setup, instant.bodies, busiest->bodies.b);
    const std::vector<lod::Front> fronts = levels_of(instant, *busiest);
    if (is_projected) return projected(a, b, instant.record, *busiest);
    const bool proved_apart =
        busiest->verdict == lod::Verdict::apart && !fronts.back().pairs.empty();
    return viz::traversal<Dim>(a, b, fronts, {{}, proved_apart}, viewpoint_of<Dim>(setup.scene));
}

template <int Dim>
void collide(const scenes::Scene& scene, const Options& options) {
    const scenes::Setup<Dim> setup = stage<Dim>(scene, options);
    const Instant<Dim> instant = instant_of(setup, options);
    Drawing drawing;
    drawing.figure = [&] { return figure_of(setup, instant, options.projected); };
    write_outputs(options, drawing);
    if (options.json)
        print(result_of(setup, instant));
    else
        print(report_of(setup, instant));
}

}  // namespace

void run_collide(const Options& options) {
    const scenes::Scene scene = scene_of(options);
    if (options.projected && scene.dim == 2)
        throw lod::Error(lod::ErrorKind::usage,
                         "the scene lies in a plane already; drop --projected");
    check_outputs(options, {});
    in_dimension(scene.dim, [&](auto dim) { collide<dim()>(scene, options); });
}

}  // namespace cli
