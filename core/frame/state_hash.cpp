#include "lodlab/core/frame/state_hash.hpp"

#include "lodlab/core/math/bit_hash.hpp"

namespace lod {
namespace {

template <int Dim>
void add_hull(const HullView<Dim>& hull, BitHash& hash) {
    hash.add_all(hull.corners);
    for (const char cut : hull.cut) hash.add(static_cast<std::int32_t>(cut));
    for (std::size_t face = 0; face < hull.normals.size(); ++face) {
        hash.add_all(hull.loop(face));
        hash.add(static_cast<std::int32_t>(hull.inner[face]));
        hash.add(hull.normals[face]);
        hash.add(hull.offsets[face]);
    }
}

}  // namespace

template <int Dim>
std::uint64_t state_hash(std::span<const Body<Dim>> bodies) {
    BitHash hash;
    for (const Body<Dim>& body : bodies) {
        hash.add(body.position);
        hash.add(body.orientation);
        hash.add(body.velocity);
        hash.add(body.spin);
    }
    return hash.value();
}

template <int Dim>
std::uint64_t tree_hash(const SphereTree<Dim>& tree) {
    BitHash hash;
    for (const std::vector<double>& coordinate : tree.centre) hash.add_all(coordinate);
    hash.add_all(tree.radius);
    for (const std::vector<double>& coordinate : tree.normal) hash.add_all(coordinate);
    hash.add_all(tree.level_begin);
    hash.add_all(tree.child_count);
    for (int node = 0; node < tree.size(); ++node)
        if (!tree.is_leaf(node)) hash.add(tree.first_child[SphereTree<Dim>::index(node)]);
    if (!tree.has_hulls()) return hash.value();
    hash.add(static_cast<std::int32_t>(tree.hulls.entry_level));
    for (int node = 0; node < tree.size(); ++node) {
        hash.add(static_cast<std::int32_t>(tree.hulls.best(node)));
        hash.add(static_cast<std::int32_t>(tree.hulls.is_round(node)));
        add_hull(tree.hulls.of(node), hash);
    }
    return hash.value();
}

template std::uint64_t state_hash(std::span<const Body<2>>);
template std::uint64_t state_hash(std::span<const Body<3>>);
template std::uint64_t tree_hash(const SphereTree<2>&);
template std::uint64_t tree_hash(const SphereTree<3>&);

}  // namespace lod
