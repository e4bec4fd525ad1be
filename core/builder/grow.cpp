#include "lodlab/core/builder/grow.hpp"

#include <cmath>

namespace lod {

void check_grow_settings(const GrowSettings& settings) {
    constexpr double most_leaves = 1048576;
    const auto refuse = [](const std::string& what, const std::string& range) {
        throw Error(ErrorKind::limit_exceeded,
                    "cannot build the tree: " + what + " is out of range; choose " + range);
    };
    const std::string branching = std::to_string(settings.branching);
    const std::string depth = std::to_string(settings.depth);
    if (settings.branching < 2 || settings.branching > 64)
        refuse("branching " + branching, "2 to 64 children a node");
    if (settings.depth < 0 || settings.depth > 12)
        refuse("depth " + depth, "0 to 12 levels below the root");
    double leaves = 1;
    for (int level = 0; level < settings.depth; ++level) leaves *= settings.branching;
    if (leaves > most_leaves)
        refuse("branching " + branching + " with depth " + depth,
               "fewer than 1048576 leaves in all, for instance branching 4 with depth 10");
    if (!(settings.least_protrusion >= 0)) refuse("the least protrusion", "a share of 0 or more");
    if (!(settings.normal_weight >= 0 && settings.normal_weight <= 100))
        refuse("the weight of the normals", "0 to 100");
}

int depth_within(int branching, int depth, std::int64_t most_nodes) {
    if (most_nodes <= 0) return depth;
    double level = 1;
    double all = 1;
    for (int reached = 0; reached < depth; ++reached) {
        level *= branching;
        all += level;
        if (all > static_cast<double>(most_nodes)) return reached;
    }
    return depth;
}

}  // namespace lod
