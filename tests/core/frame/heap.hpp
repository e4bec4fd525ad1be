#pragma once

#include "tests/core/bodies.hpp"

namespace lodtest {

/// A loose heap of boxes that move towards its middle.
template <int Dim>
std::vector<lod::Body<Dim>> heap(std::uint64_t seed, int count = 12) {
    Random random(seed);
    std::vector<lod::Body<Dim>> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(random_body<Dim>(random));
        bodies.back().position *= 0.7;
        bodies.back().velocity = -bodies.back().position;
        bodies.back().tree = random_tree<Dim>(random, 3, 4, random.in(0.4, 1.2));
    }
    lod::make_static(bodies.front());
    return bodies;
}

}  // namespace lodtest
