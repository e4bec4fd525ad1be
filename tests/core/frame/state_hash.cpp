#include "lodlab/core/frame/state_hash.hpp"

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
std::uint64_t hash_of(const std::vector<Body<Dim>>& bodies) {
    return state_hash<Dim>(bodies);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the state hash sees the last bit of every number of every body",
                       "[state_hash]", ((int Dim), Dim), 2, 3) {
    Random random(61);
    const std::vector<Body<Dim>> bodies{random_body<Dim>(random), random_body<Dim>(random)};
    const std::uint64_t before = hash_of(bodies);
    CHECK(hash_of(std::vector<Body<Dim>>(bodies)) == before);
    const auto nudge = [](double& number) { number = std::nextafter(number, 1e9); };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (int d = 0; d < Dim; ++d) {
            auto moved = bodies;
            nudge(moved[i].position[d]);
            CHECK(hash_of(moved) != before);
            moved = bodies;
            nudge(moved[i].velocity[d]);
            CHECK(hash_of(moved) != before);
        }
        for (int d = 0; d < bodies[i].spin.size(); ++d) {
            auto moved = bodies;
            nudge(moved[i].spin[d]);
            CHECK(hash_of(moved) != before);
        }
        auto turned = bodies;
        turned[i].orientation = Space<Dim>::turned(turned[i].orientation, planar_spin<Dim>(1e-15));
        CHECK(hash_of(turned) != before);
    }
    auto swapped = bodies;
    std::swap(swapped[0], swapped[1]);
    CHECK(hash_of(swapped) != before);
}

TEST_CASE("the state hash is FNV-1a of the bytes, lowest first", "[state_hash]") {
    CHECK(state_hash<2>({}) == 0xcbf29ce484222325ULL);  // the offset: nothing hashed
    // The 48 zero bytes of a body at rest only multiply by the prime.
    std::uint64_t expected = 0xcbf29ce484222325ULL;
    for (int i = 0; i < 48; ++i) expected *= 0x100000001b3ULL;
    const std::vector<Body<2>> resting(1);
    CHECK(hash_of(resting) == expected);
}
