#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/builder/tree_report.hpp"

namespace lessons::spheres {

using Vec = lod::Vector<3>;

/// From where the ring is seen: from a little above, its hole open to the eye.
constexpr viz::Viewpoint from_the_front{.azimuth = 0.5, .elevation = 0.4};

/// A ring in space with its sphere tree, and how well each level fits.
struct Ring {
    lod3d::Solid solid;
    std::shared_ptr<const lod::SphereTree<3>> tree;
    lod::TreeReport report;
    viz::Actor<3> body;
};

[[nodiscard]] Ring make_ring();

/// How far the balls of a level stand out at most, for the reader: "1.47 %" of the diameter.
[[nodiscard]] Number share_of_diameter(double fraction);

// Level by level, and what a level costs in the plane and in space (fit.cpp).
void give_fit(Lesson& lesson, const Ring& ring);

// Two links of a chain: apart, then colliding, then as shadows (links.cpp).
void give_links(Lesson& lesson, const Ring& ring);

}  // namespace lessons::spheres
