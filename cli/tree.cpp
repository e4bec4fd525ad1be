#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "lod2d/generators.hpp"
#include "scenes/setup.hpp"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

void print_list() {
    std::string text = "Generators (sizes in metres; parameters may be left out from the right):\n";
    for (const lod2d::Generator& generator : lod2d::generators())
        text += "  " + lod2d::usage(generator) + "  " + std::string(generator.description) + "\n";
    text += "Files: svg. Text in a font: text:R\n";
    print(text);
}

}  // namespace

void run_tree(const Options& options) {
    if (options.list) return print_list();
    if (options.shape.empty())
        throw lod::Error(lod::ErrorKind::usage,
                         "no shape given; name one, or lodlab tree --list shows what there is");
    const lod2d::Shape shape = scenes::shape_named(options.shape, options.size);
    print(Json{{"dim", 2},
               {"shape",
                {{"measure", shape.area},
                 {"centroid", {shape.centroid.x(), shape.centroid.y()}},
                 {"inertia", shape.second_moment}}}});
}

}  // namespace cli
