#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "io/tree_json.hpp"
#include "lod2d/generators.hpp"
#include "lod2d/tree_report.hpp"
#include "viz/draw_tree.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

void print_list() {
    std::string text = "Generators (in metres; numbers may be left out from the right):\n";
    for (const lod2d::Generator& generator : lod2d::generators())
        text += "  " + lod2d::usage(generator) + "  " + std::string(generator.description) + "\n";
    text += "Files: NAME.svg\nText in a font: text:R\nBuilders of trees:\n";
    for (const lod2d::Builder builder : lod2d::builders())
        text += "  " + std::string(lod2d::builder_name(builder)) +
                (builder == lod2d::TreeSettings{}.builder ? " (the default)\n" : "\n");
    print(text);
}

Json level_json(const lod2d::LevelReport& level) {
    return {{"level", level.level},
            {"nodes", level.nodes},
            {"worst_protrusion", level.worst_protrusion},
            {"mean_protrusion", level.mean_protrusion},
            {"worst_protrusion_fraction", level.worst_protrusion_fraction},
            {"mean_protrusion_fraction", level.mean_protrusion_fraction},
            {"measure_ratio", level.measure_ratio},
            {"uncovered", level.uncovered},
            {"certified", level.certified}};
}

Json result_of(const lod2d::Shape& shape, lod2d::Builder builder, const lod2d::TreeReport& report) {
    Json levels = Json::array();
    for (const lod2d::LevelReport& level : report.levels) levels.push_back(level_json(level));
    return {{"dim", 2},
            {"shape",
             {{"measure", shape.area},
              {"centroid", {shape.centroid.x(), shape.centroid.y()}},
              {"inertia", shape.second_moment}}},
            {"builder", lod2d::builder_name(builder)},
            {"levels", std::move(levels)}};
}

std::string report_of(const lod2d::Shape& shape, lod2d::Builder builder,
                      const lod2d::TreeReport& report) {
    std::string text = shape.name + ": area " + readable(shape.area) + " m^2, second moment " +
                       readable(shape.second_moment) + " m^4, tree by " +
                       std::string(lod2d::builder_name(builder)) + "\n";
    text += "  level   nodes   worst [m]    mean [m]   area ratio   covers\n";
    for (const lod2d::LevelReport& level : report.levels)
        text += "  " + right(std::to_string(level.level), 5) +
                right(std::to_string(level.nodes), 8) +
                right(readable(level.worst_protrusion, 3), 12) +
                right(readable(level.mean_protrusion, 3), 12) +
                right(readable(level.measure_ratio, 4), 13) +
                (level.certified ? "   yes, proved\n" : "   no\n");
    text += "worst and mean: how far the circles stand out of the shape\n";
    return text;
}

}  // namespace

void run_tree(const Options& options) {
    if (options.list) return print_list();
    if (options.shape.empty())
        throw lod::Error(lod::ErrorKind::usage,
                         "no shape given; name one, or lodlab tree --list shows what there is");
    check_outputs(options, false);
    const lod2d::Shape shape =
        scenes::shape_named(options.shape, options.size, options.raise_limits);
    lod2d::TreeSettings settings =
        scenes::tree_settings(options.builder, options.branching, options.depth);
    lod::Body<2> body;
    {
        ProgressBar bar("Building the tree");
        settings.progress = [&](double share) { bar.show(share); };
        body.tree = std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
    }
    Drawing drawing;
    drawing.figure = [&] { return viz::tree_levels<2>({look_of(shape, shape.name), body}); };
    drawing.json = [&](const std::string& path) { io::save_tree(path, *body.tree); };
    write_outputs(options, drawing);
    const lod2d::TreeReport report = lod2d::report_tree(shape, *body.tree);
    if (options.json)
        print(result_of(shape, settings.builder, report));
    else
        print(report_of(shape, settings.builder, report));
}

}  // namespace cli
