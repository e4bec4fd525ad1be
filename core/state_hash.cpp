#include "lodlab/core/state_hash.hpp"

#include <bit>

namespace lod {
namespace {

constexpr std::uint64_t fnv_offset = 14695981039346656037ULL;
constexpr std::uint64_t fnv_prime = 1099511628211ULL;

struct Hash {
    std::uint64_t value = fnv_offset;

    template <class Bits>
    void add_bits(Bits bits) {
        for (std::size_t shift = 0; shift < 8 * sizeof bits; shift += 8) {
            value ^= (bits >> shift) & 0xff;
            value *= fnv_prime;
        }
    }
    void add(double number) { add_bits(std::bit_cast<std::uint64_t>(number)); }
    void add(std::int32_t number) { add_bits(std::bit_cast<std::uint32_t>(number)); }
    template <class Number>
    void add(const std::vector<Number>& numbers) {
        for (const Number number : numbers) add(number);
    }
    template <int Rows, int Cols>
    void add(const FixedMatrix<Rows, Cols>& numbers) {
        for (const double number : numbers) add(number);
    }
    void add(const Quaternion& q) { add(q.coeffs()); }
    template <int Dim>
    void add(const HullView<Dim>& hull) {
        for (const Vector<Dim>& corner : hull.corners) add(corner);
        for (std::size_t face = 0; face < hull.normals.size(); ++face) {
            for (const std::int32_t corner : hull.loop(face)) add(corner);
            add(static_cast<std::int32_t>(hull.inner[face]));
            add(hull.normals[face]);
            add(hull.offsets[face]);
        }
    }
};

}  // namespace

template <int Dim>
std::uint64_t state_hash(std::span<const Body<Dim>> bodies) {
    Hash hash;
    for (const Body<Dim>& body : bodies) {
        hash.add(body.position);
        hash.add(body.orientation);
        hash.add(body.velocity);
        hash.add(body.spin);
    }
    return hash.value;
}

template <int Dim>
std::uint64_t tree_hash(const SphereTree<Dim>& tree) {
    Hash hash;
    for (const std::vector<double>& coordinate : tree.centre) hash.add(coordinate);
    hash.add(tree.radius);
    for (const std::vector<double>& coordinate : tree.normal) hash.add(coordinate);
    hash.add(tree.level_begin);
    hash.add(tree.child_count);
    for (int node = 0; node < tree.size(); ++node)
        if (!tree.is_leaf(node)) hash.add(tree.first_child[SphereTree<Dim>::index(node)]);
    if (!tree.has_hulls()) return hash.value;
    hash.add(static_cast<std::int32_t>(tree.hulls.entry_level));
    for (int node = 0; node < tree.size(); ++node) {
        hash.add(static_cast<std::int32_t>(tree.hulls.best(node)));
        hash.add(static_cast<std::int32_t>(tree.hulls.is_round(node)));
        hash.add(tree.hulls.of(node));
    }
    return hash.value;
}

template std::uint64_t state_hash(std::span<const Body<2>>);
template std::uint64_t state_hash(std::span<const Body<3>>);
template std::uint64_t tree_hash(const SphereTree<2>&);
template std::uint64_t tree_hash(const SphereTree<3>&);

}  // namespace lod
