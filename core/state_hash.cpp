#include "core/state_hash.hpp"

#include <bit>

namespace lod {
namespace {

constexpr std::uint64_t fnv_offset = 14695981039346656037ULL;
constexpr std::uint64_t fnv_prime = 1099511628211ULL;

struct Hash {
    std::uint64_t value = fnv_offset;

    void add(double number) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (int shift = 0; shift < 64; shift += 8) {
            value ^= (bits >> shift) & 0xff;
            value *= fnv_prime;
        }
    }
    template <class Derived>
    void add(const Eigen::MatrixBase<Derived>& numbers) {
        for (Eigen::Index i = 0; i < numbers.size(); ++i) add(numbers[i]);
    }
    void add(const Eigen::Quaterniond& q) { add(q.coeffs()); }
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

template std::uint64_t state_hash(std::span<const Body<2>>);
template std::uint64_t state_hash(std::span<const Body<3>>);

}  // namespace lod
