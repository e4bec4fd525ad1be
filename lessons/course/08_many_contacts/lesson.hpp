#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/response/response.hpp"

namespace lessons::many {

/// Bodies that touch in several places, before or after they are answered.
struct Touching {
    std::vector<lod::Body<2>> bodies;
    std::vector<lod::Impact<2>> impacts;
    std::vector<double> impulses;

    [[nodiscard]] double energy() const { return lod::kinetic_energy<2>(bodies); }
};

/// The answer of a response.
[[nodiscard]] Touching answered(Touching touching, lod::Response response);

/// Many contacts of two bodies (landing.cpp).
void give_landings(Lesson& lesson);

}  // namespace lessons::many
