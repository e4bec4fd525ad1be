#include "lodlab/core/tree/tree.hpp"

#include <algorithm>

#include "lodlab/core/base/error.hpp"

namespace lod {

template <int Dim>
Sphere<Dim> SphereTree<Dim>::sphere(int node) const {
    Sphere<Dim> s;
    for (int d = 0; d < Dim; ++d) s.centre[d] = centre[index(d)][index(node)];
    s.radius = radius[index(node)];
    return s;
}

template <int Dim>
Vector<Dim> SphereTree<Dim>::mean_normal(int node) const {
    Vector<Dim> n;
    for (int d = 0; d < Dim; ++d) n[d] = normal[index(d)][index(node)];
    return n;
}

template <int Dim>
int SphereTree<Dim>::level_of(int node) const {
    const auto after = std::upper_bound(level_begin.begin(), level_begin.end(), node);
    return static_cast<int>(after - level_begin.begin()) - 1;
}

template <int Dim>
std::vector<int> SphereTree<Dim>::level_nodes(int level) const {
    const int deepest = std::min(level, levels() - 1);
    std::vector<int> nodes;
    for (int node = 0; node < level_begin[index(deepest + 1)]; ++node)
        if (is_leaf(node) || node >= level_begin[index(deepest)]) nodes.push_back(node);
    return nodes;
}

namespace {

/// The numbers of the nodes in breadth-first order, and where each level begins.
struct Order {
    std::vector<int> nodes;
    std::vector<std::int32_t> level_begin{0};
};

template <int Dim>
Order breadth_first(std::span<const TreeNode<Dim>> nodes) {
    if (nodes.empty()) throw Error(ErrorKind::input_refused, "a tree needs at least one node");
    Order order{{0}, {0}};
    std::vector<char> seen(nodes.size(), 0);
    seen[0] = 1;
    std::size_t level_end = 1;
    for (std::size_t i = 0; i < order.nodes.size(); ++i) {
        if (i == level_end) {
            order.level_begin.push_back(static_cast<std::int32_t>(i));
            level_end = order.nodes.size();
        }
        for (int child : nodes[static_cast<std::size_t>(order.nodes[i])].children) {
            const bool known = child >= 0 && static_cast<std::size_t>(child) < nodes.size();
            if (!known || seen[static_cast<std::size_t>(child)])
                throw Error(ErrorKind::input_refused,
                            "not a tree: child " + std::to_string(child) + " of node " +
                                std::to_string(order.nodes[i]) +
                                " does not exist or has a parent already");
            seen[static_cast<std::size_t>(child)] = 1;
            order.nodes.push_back(child);
        }
    }
    if (order.nodes.size() != nodes.size())
        throw Error(ErrorKind::input_refused,
                    "not a tree: some nodes are not reached from the root");
    order.level_begin.push_back(static_cast<std::int32_t>(nodes.size()));
    return order;
}

/// SphereTree::single, of all else.
template <int Dim>
std::vector<float> single_of(const SphereTree<Dim>& tree) {
    std::vector<float> single;
    const auto add_family = [&](std::size_t first, std::size_t count) {
        const auto add = [&](const std::vector<double>& numbers) {
            for (std::size_t i = first; i < first + count; ++i)
                single.push_back(static_cast<float>(numbers[i]));
        };
        for (const std::vector<double>& axis : tree.centre) add(axis);
        add(tree.radius);
    };
    add_family(0, 1);
    for (std::size_t node = 0; node < tree.radius.size(); ++node)
        add_family(static_cast<std::size_t>(tree.first_child[node]),
                   static_cast<std::size_t>(tree.child_count[node]));
    single.resize(single.size() + SphereTree<Dim>::single_room, 0);
    return single;
}

/// Unit vectors to the sides, edges and corners of a cube.
template <int Dim>
std::vector<Vector<Dim>> cube_directions() {
    std::vector<Vector<Dim>> directions;
    int all = 1;
    for (int axis = 0; axis < Dim; ++axis) all *= 3;
    for (int code = 0; code < all; ++code) {
        Vector<Dim> towards;
        int rest = code;
        for (int axis = 0; axis < Dim; ++axis, rest /= 3) towards[axis] = rest % 3 - 1;
        if (!towards.isZero(0)) directions.push_back(towards.normalized());
    }
    return directions;
}

/// How far the node's ball stands out of its children, in some directions.
template <int Dim>
double excess_over_children(const SphereTree<Dim>& tree, int node,
                            std::span<const Vector<Dim>> directions) {
    const Sphere<Dim> ball = tree.sphere(node);
    const std::int32_t first = tree.first_child[SphereTree<Dim>::index(node)];
    const std::int32_t count = tree.child_count[SphereTree<Dim>::index(node)];
    double most = 0;
    for (const Vector<Dim>& direction : directions) {
        const Vector<Dim> point = ball.centre + ball.radius * direction;
        double least = 2 * ball.radius;
        for (std::int32_t child = first; child < first + count; ++child) {
            const Sphere<Dim> part = tree.sphere(child);
            least = std::min(least, (point - part.centre).norm() - part.radius);
        }
        most = std::max(most, least);
    }
    return most;
}

template <int Dim>
std::vector<double> level_errors(const SphereTree<Dim>& tree) {
    const std::vector<Vector<Dim>> directions = cube_directions<Dim>();
    std::vector<double> errors(SphereTree<Dim>::index(tree.levels()), 0.0);
    for (int level = tree.levels() - 2; level >= 0; --level) {
        double worst = 0;
        const auto end = tree.level_begin[SphereTree<Dim>::index(level + 1)];
        for (int node = tree.level_begin[SphereTree<Dim>::index(level)]; node < end; ++node)
            if (!tree.is_leaf(node))
                worst = std::max(worst, excess_over_children<Dim>(tree, node, directions));
        errors[SphereTree<Dim>::index(level)] = worst + errors[SphereTree<Dim>::index(level + 1)];
    }
    return errors;
}

}  // namespace

template <int Dim>
SphereTree<Dim> lay_out(std::span<const TreeNode<Dim>> nodes) {
    const Order order = breadth_first(nodes);
    SphereTree<Dim> tree;
    tree.level_begin = order.level_begin;
    tree.parent.assign(nodes.size(), -1);
    std::int32_t next_child = 1;
    for (std::size_t i = 0; i < order.nodes.size(); ++i) {
        const TreeNode<Dim>& node = nodes[static_cast<std::size_t>(order.nodes[i])];
        for (std::size_t d = 0; d < Dim; ++d) {
            tree.centre[d].push_back(node.sphere.centre[static_cast<int>(d)]);
            tree.normal[d].push_back(node.mean_normal[static_cast<int>(d)]);
        }
        tree.radius.push_back(node.sphere.radius);
        const auto count = static_cast<std::int32_t>(node.children.size());
        tree.first_child.push_back(next_child);
        tree.child_count.push_back(count);
        for (std::int32_t c = 0; c < count; ++c)
            tree.parent[static_cast<std::size_t>(next_child + c)] = static_cast<std::int32_t>(i);
        next_child += count;
    }
    renew(tree);
    return tree;
}

template <int Dim>
void renew(SphereTree<Dim>& tree) {
    tree.extent = 0;
    for (int node = 0; node < tree.size(); ++node) {
        const Sphere<Dim> ball = tree.sphere(node);
        tree.extent = std::max(tree.extent, ball.centre.stableNorm() + ball.radius);
    }
    tree.single = single_of(tree);
    tree.level_error = level_errors(tree);
}

template <int Dim>
SphereTree<Dim> single_sphere(const Sphere<Dim>& sphere) {
    const TreeNode<Dim> root{sphere, Vector<Dim>::Zero(), {}};
    return lay_out<Dim>(std::span(&root, 1));
}

template <int Dim>
SphereTree<Dim> half_space(const Vector<Dim>& normal) {
    if (!normal.allFinite() || normal.isZero(0))
        throw Error(ErrorKind::input_refused,
                    "the normal of a half-space must be finite and not zero");
    SphereTree<Dim> tree = single_sphere<Dim>({Vector<Dim>::Zero(), 0});
    tree.half_space = normal.stableNormalized();
    tree.hulls.add_half_space(*tree.half_space);
    tree.hulls.find_best(tree.parent);
    return tree;
}

template struct SphereTree<2>;
template struct SphereTree<3>;
template SphereTree<2> lay_out(std::span<const TreeNode<2>>);
template SphereTree<3> lay_out(std::span<const TreeNode<3>>);
template void renew(SphereTree<2>&);
template void renew(SphereTree<3>&);
template SphereTree<2> half_space(const Vector<2>&);
template SphereTree<3> half_space(const Vector<3>&);
template SphereTree<2> single_sphere(const Sphere<2>&);
template SphereTree<3> single_sphere(const Sphere<3>&);

}  // namespace lod
