#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lodlab/core/tree/body.hpp"
#include "lodlab/lod2d/shape/shape.hpp"

namespace bench {

/// A body as the other engines want it: convex pieces of at most 8 corners, anticlockwise, about
/// the centre of mass.
struct PiecedShape {
    lod2d::Shape shape;  ///< their union
    std::vector<lod2d::Ring> pieces;
};
/// A star of 5 points in 6 pieces, a gear of 8 teeth in 9, an L in 2, each within a circle of half
/// a metre.
[[nodiscard]] std::vector<PiecedShape> pieced_shapes();

/// Another engine of the plane with the bodies of a scene: no gravity, no friction, no damping, no
/// sleep, restitution 1 at any speed; else as it comes.
class Peer {
  public:
    virtual ~Peer() = default;
    virtual void step(double seconds) = 0;
    /// Velocities and spins as they are now, into bodies of the same numbers.
    virtual void read(std::span<lod::Body<2>> bodies) const = 0;
};

/// Of each body; null for a half-space.
using Shapes = std::span<const PiecedShape* const>;

/// Box2D 2.4 with so many iterations of its velocities (8 is usual) and 3 of its positions.
[[nodiscard]] std::unique_ptr<Peer> box2d(std::span<const lod::Body<2>> bodies, Shapes shapes,
                                          int iterations);
/// Chipmunk 7 with so many iterations (10 is usual).
[[nodiscard]] std::unique_ptr<Peer> chipmunk(std::span<const lod::Body<2>> bodies, Shapes shapes,
                                             int iterations);

}  // namespace bench
