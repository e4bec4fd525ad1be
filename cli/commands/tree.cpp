#include <nlohmann/json.hpp>

#include "cli/arguments/check_outputs.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/stage/staging.hpp"
#include "cli/terminal/dimension.hpp"
#include "cli/terminal/numbers.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/sphere_files.hpp"
#include "lodlab/io/tree_json.hpp"
#include "lodlab/scenes/shapes.hpp"
#include "lodlab/viz/draw/draw_tree.hpp"
#include "lodlab/viz/draw/draw_turntable.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

template <int Dim>
std::string list_text() {
    using Shapes = scenes::Shapes<Dim>;
    std::string text = "Generators (in metres; numbers may be left out from the right):\n";
    for (const scenes::GeneratorNote& one : Shapes::generators())
        text += "  " + one.usage + "  " + one.description + "\n";
    text += "Files: " + std::string(Shapes::words.files) + "\nBuilders of trees: ";
    std::string after = " (the default)";
    for (const std::string_view builder : Shapes::builders()) {
        text += (after.empty() ? ", " : "") + std::string(builder) + after;
        after.clear();
    }
    return text + "\n";
}

void print_list() {
    print("In the plane\n" + list_text<2>() + "Text in a font: text:R\n\nIn space (--dim 3)\n" +
          list_text<3>());
}

Json level_json(const lod::LevelReport& level) {
    return {{"level", level.level},
            {"nodes", level.nodes},
            {"worst_protrusion", level.worst_protrusion},
            {"mean_protrusion", level.mean_protrusion},
            {"worst_protrusion_fraction", level.worst_protrusion_fraction},
            {"mean_protrusion_fraction", level.mean_protrusion_fraction},
            {"measure_ratio", level.measure_ratio},
            {"uncovered", level.uncovered},
            {"certified", level.certified},
            {"hulls_certified", level.hulls_certified}};
}

template <int Dim>
Json result_of(const scenes::Shape<Dim>& shape, const std::string& builder,
               const lod::TreeReport& report) {
    using Shapes = scenes::Shapes<Dim>;
    Json levels = Json::array();
    for (const lod::LevelReport& level : report.levels) levels.push_back(level_json(level));
    return {{"dim", Dim},
            {"shape",
             {{"measure", Shapes::measure(shape)},
              {"centroid", list_of(shape.centroid)},
              {"inertia", moment_of(Shapes::second_moment(shape))},
              {"approximate", Shapes::is_approximate(shape)},
              {"remarks", Shapes::remarks(shape)}}},
            {"builder", builder},
            {"levels", std::move(levels)}};
}

template <int Dim>
std::string report_of(const scenes::Shape<Dim>& shape, const std::string& builder,
                      const lod::TreeReport& report) {
    using Shapes = scenes::Shapes<Dim>;
    const auto& words = Shapes::words;
    const std::string measure(words.measure);
    const lod::Inertia<Dim> moment = Shapes::second_moment(shape);
    std::string text =
        shape.name + ": " + measure + " " + readable(Shapes::measure(shape)) + " " +
        std::string(words.measure_unit) + ", second moment " +
        (moment.size() == 1 ? readable(moment(0, 0)) : in_brackets(moment.diagonal(), 4)) + " " +
        std::string(words.moment_unit) + (Shapes::is_approximate(shape) ? " (approximate)" : "") +
        ", tree by " + builder + "\n";
    text += "  level   nodes   worst [m]     worst    mean [m]" + right(measure + " ratio", 14) +
            "   covers\n";
    for (const lod::LevelReport& level : report.levels)
        text += "  " + right(std::to_string(level.level), 5) +
                right(std::to_string(level.nodes), 8) +
                right(readable(level.worst_protrusion, 3), 12) +
                right(readable(100 * level.worst_protrusion_fraction, 3) + " %", 10) +
                right(readable(level.mean_protrusion, 3), 12) +
                right(readable(level.measure_ratio, 4), 14) +
                (level.certified ? "   yes, proved\n" : "   no\n");
    return text + "worst and mean: how far the " + std::string(words.balls) +
           " stand out of the shape; %: of its bounding diameter\n";
}

/// The level that a file of one level holds.
int exported_level(const lod::SphereTree<3>& tree, const Options& options,
                   const std::string& path) {
    const int last = tree.levels() - 1;
    if (options.level && *options.level > last)
        remark("the tree ends at level " + std::to_string(last) + ", so " + path +
               " holds that; --depth asks for more levels");
    return std::min(options.level.value_or(last), last);
}

/// Spheres for other programs, in the frame of the mesh.
void add_sphere_exports(const lod3d::Solid& solid, const lod::SphereTree<3>& tree,
                        const Options& options, std::vector<Export>& exports) {
    for (const io::SphereFormat& format : io::sphere_formats())
        exports.push_back(
            {std::string(format.ending), [&](const std::string& path) {
                 const int level = format.one_level ? exported_level(tree, options, path) : 0;
                 lod::write_text_file(path, format.text({tree, solid.centroid, level, solid.name}));
             }});
}
void add_sphere_exports(const lod2d::Shape&, const lod::SphereTree<2>&, const Options&,
                        std::vector<Export>&) {}

/// A solid turns while its tree passes; the plane has nothing to turn.
void add_film(const viz::Actor<3>& actor, Drawing& drawing) {
    drawing.animation = [&actor] { return viz::turntable(actor); };
}
void add_film(const viz::Actor<2>&, Drawing&) {}

template <int Dim>
std::shared_ptr<const lod::SphereTree<Dim>> built(const scenes::Shape<Dim>& shape,
                                                  const scenes::TreeChoice& choice,
                                                  const io::TreeCache& cache) {
    auto settings = scenes::Shapes<Dim>::settings(choice);
    ProgressBar bar("Building the tree");
    settings.progress = [&](double share) { bar.show(share); };
    return std::make_shared<const lod::SphereTree<Dim>>(
        scenes::tree_of<Dim>(shape, settings, cache));
}

template <int Dim>
void tree(const Options& options) {
    using Shapes = scenes::Shapes<Dim>;
    const scenes::TreeChoice choice{options.builder, options.branching, options.depth,
                                    options.error,   options.nodes,     options.effort};
    static_cast<void>(Shapes::settings(choice));  // throws for an unknown builder
    const scenes::Shape<Dim> shape =
        Shapes::named(options.shape, {options.size, options.fill, options.raise_limits,
                                      options.strokes, options.strict, options.page});
    for (const std::string& line : Shapes::remarks(shape)) remark(line);
    viz::Actor<Dim> actor{{shape.name, {}}, {}};
    actor.body.tree = built<Dim>(shape, choice, cache_of(options));
    Drawing drawing;
    if (!options.out.empty()) actor.visual = visual_of<Dim>(shape, shape.name);
    drawing.figure = [&] { return viz::tree_levels<Dim>(actor); };
    add_film(actor, drawing);
    add_sphere_exports(shape, *actor.body.tree, options, drawing.exports);
    drawing.exports.push_back(
        {".json", [&](const std::string& path) { io::save_tree(path, *actor.body.tree); }});
    write_outputs(options, drawing);
    const lod::TreeReport report = Shapes::report(shape, *actor.body.tree);
    const std::string builder =
        options.builder.empty() ? std::string(Shapes::builders().front()) : options.builder;
    if (options.json)
        print(result_of<Dim>(shape, builder, report));
    else
        print(report_of<Dim>(shape, builder, report));
}

}  // namespace

void run_tree(const Options& options) {
    if (options.list) return print_list();
    if (options.shape.empty())
        throw lod::Error(lod::ErrorKind::usage,
                         "no shape given; name one, or lodlab tree --list shows what there is");
    const int dim = options.dim.value_or(scenes::dimension_of(options.shape));
    Formats formats{.video = dim == 3, .exports = {".json"}};
    if (dim == 3)
        for (const io::SphereFormat& format : io::sphere_formats())
            formats.exports.emplace_back(format.ending);
    check_outputs(options, formats);
    in_dimension(dim, [&](auto constant) { tree<constant()>(options); });
}

}  // namespace cli
