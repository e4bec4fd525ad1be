// The one file of viz that includes nlohmann-json.
//
// A figure as JSON:
//   {"lodlab": "figure", "version": 1, "title", "caption", "alt", "numbers": [{"name", "value"}],
//    "columns", "panels": [{"title", "view": [low_x, low_y, high_x, high_y],
//    "axes": {"x": {"label", "scale"}, "y": ...} or absent,
//    "marks": [{"mark": "disc|dot|path|polyline|arrow|label", "role", "body", "level", "opacity",
//               ... what the mark holds: "centre" and "radius"; "at", "size"; "rings"; "points",
//               "start_opacity", "end_label"; "tail", "tip", "label"; "anchor", "text",
//               "clearance"}],
//    "entries": [{"role", "body", "level", "words", "value"}] or absent}]}
// What has its usual value is left out: sizes and opacities of 1, clearances of 0.
// A scene in space adds to its panel:
//   "space": {"camera": {"eye", "target", "up", "perspective"},
//    "balls": [{"role", "body", "level", "opacity", "centre", "radius"}],
//    "surfaces": [{"role", "body", "opacity", "mesh", "origin", "axes": [three columns]}],
//    "ground": {"height", "spacing"} or absent}
// and the figure gets "meshes": [{"vertices", "triangles"}], which "mesh" counts from 0.
// Points are [x, y] or [x, y, z]; lengths are metres in scenes and units of the axes in plots.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lodlab/viz/figure/check.hpp"
#include "lodlab/viz/figure/json.hpp"

namespace viz {
namespace {

using nlohmann::ordered_json;

ordered_json data(Point p) {
    return ordered_json::array({p.x, p.y});
}

ordered_json data(const std::vector<Point>& points) {
    ordered_json list = ordered_json::array();
    for (const Point& p : points) list.push_back(data(p));
    return list;
}

void put(ordered_json& mark, const Disc& disc) {
    mark["mark"] = "disc";
    mark["centre"] = data(disc.centre);
    mark["radius"] = disc.radius;
}
void put(ordered_json& mark, const Dot& dot) {
    mark["mark"] = "dot";
    mark["at"] = data(dot.at);
    if (dot.size != 1) mark["size"] = dot.size;
}
void put(ordered_json& mark, const Path& path) {
    mark["mark"] = "path";
    mark["rings"] = ordered_json::array();
    for (const Ring& ring : path.rings) mark["rings"].push_back(data(ring));
}
void put(ordered_json& mark, const Polyline& line) {
    mark["mark"] = "polyline";
    mark["points"] = data(line.points);
    if (line.start_opacity != 1) mark["start_opacity"] = line.start_opacity;
    if (!line.end_label.empty()) mark["end_label"] = plain_text(line.end_label);
}
void put(ordered_json& mark, const Arrow& arrow) {
    mark["mark"] = "arrow";
    mark["tail"] = data(arrow.tail);
    mark["tip"] = data(arrow.tip);
    if (!arrow.label.empty()) mark["label"] = plain_text(arrow.label);
}
void put(ordered_json& mark, const Label& label) {
    mark["mark"] = "label";
    mark["anchor"] = data(label.anchor);
    mark["text"] = plain_text(label.text);
    if (label.clearance > 0) mark["clearance"] = label.clearance;
}

void put(ordered_json& json, const Style& style) {
    json["role"] = role_name(style.role);
    json["body"] = style.body;
    if (style.level >= 0) json["level"] = style.level;
    if (style.opacity != 1) json["opacity"] = style.opacity;
}

ordered_json data(const Mark& mark) {
    ordered_json json;
    std::visit([&](const auto& held) { put(json, held); }, static_cast<const AnyMark&>(mark));
    put(json, std::visit([](const auto& held) -> const Style& { return held.style; }, mark));
    return json;
}

ordered_json data(Point3 p) {
    return ordered_json::array({p.x, p.y, p.z});
}

ordered_json data(const Surface& surface) {
    ordered_json json;
    json["vertices"] = ordered_json::array();
    for (const Point3& v : surface.vertices) json["vertices"].push_back(data(v));
    json["triangles"] = surface.triangles;
    return json;
}

using Meshes = std::vector<std::shared_ptr<const Surface>>;

ordered_json data(const SpaceScene& scene, Meshes& meshes) {
    ordered_json json;
    json["camera"] = {{"eye", data(scene.camera.eye)},
                      {"target", data(scene.camera.target)},
                      {"up", data(scene.camera.up)},
                      {"perspective", scene.camera.perspective}};
    json["balls"] = ordered_json::array();
    for (const Ball& ball : scene.balls) {
        ordered_json one;
        put(one, ball.style);
        one["centre"] = data(ball.centre);
        one["radius"] = ball.radius;
        json["balls"].push_back(std::move(one));
    }
    json["surfaces"] = ordered_json::array();
    for (const Facets& facets : scene.facets) {
        const auto known = std::find(meshes.begin(), meshes.end(), facets.surface);
        ordered_json one;
        put(one, facets.style);
        one["mesh"] = known - meshes.begin();
        if (known == meshes.end()) meshes.push_back(facets.surface);
        one["origin"] = data(facets.origin);
        one["axes"] = {data(facets.axes[0]), data(facets.axes[1]), data(facets.axes[2])};
        json["surfaces"].push_back(std::move(one));
    }
    if (scene.ground)
        json["ground"] = {{"height", scene.ground->height}, {"spacing", scene.ground->spacing}};
    return json;
}

ordered_json data(const Axis& axis) {
    return {{"label", plain_text(axis.label)},
            {"scale", axis.scale == Scale::linear ? "linear" : "logarithmic"}};
}

ordered_json data(const Panel& panel, Meshes& meshes) {
    ordered_json json;
    json["title"] = plain_text(panel.title);
    json["view"] = {panel.view.low.x, panel.view.low.y, panel.view.high.x, panel.view.high.y};
    if (panel.axes) json["axes"] = {{"x", data(panel.axes->x)}, {"y", data(panel.axes->y)}};
    json["marks"] = ordered_json::array();
    for (const Mark& mark : panel.marks) json["marks"].push_back(data(mark));
    for (const Entry& entry : panel.entries) {
        ordered_json one;
        put(one, entry.style);
        one["words"] = plain_text(entry.words);
        one["value"] = plain_text(entry.value);
        json["entries"].push_back(std::move(one));
    }
    if (panel.space) json["space"] = data(*panel.space, meshes);
    return json;
}

}  // namespace

std::string json_text(const Figure& figure, Spacing spacing) {
    check_figure(figure);
    ordered_json json;
    json["lodlab"] = "figure";
    json["version"] = 1;
    json["title"] = plain_text(figure.title);
    json["caption"] = plain_text(figure.caption);
    json["alt"] = figure.alt;
    json["numbers"] = ordered_json::array();
    for (const Quantity& number : figure.numbers)
        json["numbers"].push_back(
            {{"name", plain_text(number.name)}, {"value", plain_text(number.value)}});
    json["columns"] = figure.columns;
    json["panels"] = ordered_json::array();
    Meshes meshes;
    for (const Panel& panel : figure.panels) json["panels"].push_back(data(panel, meshes));
    for (const auto& mesh : meshes) json["meshes"].push_back(data(*mesh));
    const int indent = spacing == Spacing::lines ? 1 : -1;
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace viz
