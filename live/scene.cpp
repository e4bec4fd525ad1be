#include "lodlab/live/scene.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/tree_json.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"

namespace live {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "live scene";
constexpr int format_version = 1;

Json json_of(const lod::Vector<2>& v) {
    return Json::array({v.x(), v.y()});
}

lod::Vector<2> vector_from(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>()};
}

Json shape_json(const viz::Actor<2>& actor) {
    Json json{{"rings", Json::array()}};
    for (const viz::Ring& ring : actor.visual.outline) {
        Json numbers = Json::array();
        for (const viz::Point& p : ring) {
            numbers.push_back(p.x);
            numbers.push_back(p.y);
        }
        json["rings"].push_back(std::move(numbers));
    }
    const lod::SphereTree<2>& tree = *actor.body.tree;
    if (tree.is_half_space())
        json["half_space"] = json_of(*tree.half_space);
    else
        json["tree"] = Json::parse(io::tree_to_json(tree));
    return json;
}

Json body_json(const viz::Actor<2>& actor, int shape) {
    const lod::Body<2>& body = actor.body;
    return {{"name", actor.visual.name},
            {"shape", shape},
            {"inverse_mass", body.inverse_mass},
            {"inertia", body.inertia[0]},
            {"inverse_inertia", body.inverse_inertia[0]},
            {"restitution", body.restitution},
            {"position", json_of(body.position)},
            {"angle", body.orientation},
            {"velocity", json_of(body.velocity)},
            {"spin", body.spin[0]}};
}

/// What bodies of one shape share.
struct Shared {
    std::vector<viz::Ring> outline;
    std::shared_ptr<const lod::SphereTree<2>> tree;
    std::shared_ptr<const lod::ExactShape<2>> exact;
};

Shared shared_from(const Json& json) {
    Shared shared;
    lod2d::Shape shape;
    for (const Json& numbers : json.at("rings")) {
        shared.outline.emplace_back();
        shape.polygon.rings.emplace_back();
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
            const lod2d::Point p(numbers[i].get<double>(), numbers[i + 1].get<double>());
            shared.outline.back().push_back({p.x(), p.y()});
            shape.polygon.rings.back().push_back(p);
        }
    }
    if (json.contains("half_space"))
        shared.tree = std::make_shared<const lod::SphereTree<2>>(
            lod::half_space<2>(vector_from(json.at("half_space"))));
    else
        shared.tree = std::make_shared<const lod::SphereTree<2>>(
            io::tree_from_json<2>(json.at("tree").dump(), "the scene's tree"));
    if (!shape.polygon.rings.empty()) shared.exact = std::make_shared<lod2d::ExactOutline>(shape);
    return shared;
}

viz::Actor<2> actor_from(const Json& json, const std::vector<Shared>& shapes) {
    const Shared& shared = shapes.at(json.at("shape").get<std::size_t>());
    viz::Actor<2> actor{{json.at("name").get<std::string>(), shared.outline}, {}};
    lod::Body<2>& body = actor.body;
    body.inverse_mass = json.at("inverse_mass").get<double>();
    body.inertia[0] = json.at("inertia").get<double>();
    body.inverse_inertia[0] = json.at("inverse_inertia").get<double>();
    body.restitution = json.at("restitution").get<double>();
    body.position = vector_from(json.at("position"));
    body.orientation = json.at("angle").get<double>();
    body.velocity = vector_from(json.at("velocity"));
    body.spin[0] = json.at("spin").get<double>();
    body.tree = shared.tree;
    body.exact = shared.exact;
    lod::check_body(body, actor.visual.name);
    return actor;
}

Scene read(const Json& json) {
    if (json.at("lodlab") != format_name || json.at("version") != format_version)
        throw std::invalid_argument("it is of another format or version");
    Scene scene;
    scene.name = json.at("name").get<std::string>();
    scene.title = json.at("title").get<std::string>();
    const auto view = json.at("view").get<std::array<double, 4>>();
    scene.view = {{view[0], view[1]}, {view[2], view[3]}};
    if (!(view[0] < view[2] && view[1] < view[3])) throw std::invalid_argument("it shows nothing");
    scene.settings = scenes::settings_from(json.at("settings"));
    scene.settings.viewer.fixation = json.at("fixation").get<lod::Viewer::Point>();
    if (!json.at("budget").is_null()) scene.budget = json.at("budget").get<std::uint64_t>();
    scene.pair_cost = json.at("pair_cost").get<double>();
    scene.told = lod::chosen<Told>(json.at("told").get<std::string>(), "kind of what is told");
    std::vector<Shared> shapes;
    for (const Json& shape : json.at("shapes")) shapes.push_back(shared_from(shape));
    for (const Json& body : json.at("bodies")) scene.actors.push_back(actor_from(body, shapes));
    return scene;
}

}  // namespace

std::string scene_text(const Scene& scene) {
    Json json{{"lodlab", format_name},
              {"version", format_version},
              {"name", scene.name},
              {"title", scene.title},
              {"view", {scene.view.low.x, scene.view.low.y, scene.view.high.x, scene.view.high.y}},
              {"settings", scenes::json_of(scene.settings)},
              {"fixation", scene.settings.viewer.fixation},
              {"budget", scene.budget ? Json(*scene.budget) : Json()},
              {"pair_cost", scene.pair_cost},
              {"told", lod::name_of(scene.told)},
              {"shapes", Json::array()},
              {"bodies", Json::array()}};
    std::map<const lod::SphereTree<2>*, int> places;
    for (const viz::Actor<2>& actor : scene.actors) {
        const auto [place, is_new] =
            places.emplace(actor.body.tree.get(), static_cast<int>(places.size()));
        if (is_new) json["shapes"].push_back(shape_json(actor));
        json["bodies"].push_back(body_json(actor, place->second));
    }
    return json.dump();
}

Scene scene_from(std::string_view text) {
    try {
        return read(Json::parse(text));
    } catch (const lod::Error&) {
        throw;
    } catch (const std::exception& error) {
        throw lod::Error(lod::ErrorKind::input_refused,
                         std::string("this is no scene that a page can hold: ") + error.what() +
                             "; write the page again");
    }
}

}  // namespace live
