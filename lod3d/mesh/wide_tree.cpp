#include "lodlab/lod3d/mesh/wide_tree.hpp"

#include <limits>

namespace lod3d {
namespace {

double half_area(const TriangleTree::Node& node) {
    const Point e = node.high - node.low;
    return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

/// Up to four nodes that together hold what the node holds: the largest is opened again and again.
std::vector<std::int32_t> opened(const TriangleTree& tree, std::int32_t root) {
    std::vector<std::int32_t> parts{root};
    while (parts.size() < WideTree::width) {
        std::size_t largest = parts.size();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (tree.node(parts[i]).is_leaf()) continue;
            if (largest < parts.size() &&
                half_area(tree.node(parts[i])) <= half_area(tree.node(parts[largest])))
                continue;
            largest = i;
        }
        if (largest == parts.size()) break;
        const std::int32_t second = tree.node(parts[largest]).first;
        ++parts[largest];  // the first child follows its parent
        parts.push_back(second);
    }
    return parts;
}

}  // namespace

WideTree::WideTree(const TriangleTree& tree) {
    const TriangleTree::Node& whole = tree.node(0);
    centre_ = 0.5 * whole.low + 0.5 * whole.high;
    const double size = (whole.high - whole.low).maxCoeff();
    if (size > 0) per_unit_ = 1 / size;
    add(tree, 0);
}

std::int32_t WideTree::add(const TriangleTree& tree, std::int32_t root) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float room = 1e-6f;  // units: more than single precision rounds off
    const auto here = static_cast<std::int32_t>(nodes_.size());
    Node fresh;
    fresh.low.fill(Four::all(infinity));
    fresh.high.fill(Four::all(-infinity));
    nodes_.push_back(fresh);
    const std::vector<std::int32_t> parts = opened(tree, root);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const TriangleTree::Node& part = tree.node(parts[i]);
        const std::array<float, 3> low = place(part.low);
        const std::array<float, 3> high = place(part.high);
        // An inner node is added first: it may move the nodes.
        const std::int32_t first = part.is_leaf() ? part.first : add(tree, parts[i]);
        Node& node = nodes_[static_cast<std::size_t>(here)];
        for (std::size_t d = 0; d < 3; ++d) {
            node.low[d].set(i, low[d] - room);
            node.high[d].set(i, high[d] + room);
        }
        node.first[i] = first;
        node.count[i] = part.count;
    }
    return here;
}

}  // namespace lod3d
