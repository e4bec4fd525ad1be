#pragma once

#include <cstdint>
#include <vector>

#include "lodlab/core/tree/posed_tree.hpp"

namespace measure {

/// How far two posed trees are from having a front at a level: no node pair of that level (or of
/// leaves above it) is reached by a traversal until the bodies have moved at least so far towards
/// each other [m]. A pair is reached when every pair of its ancestors overlaps, so this is the
/// least, over all pairs of the level, of the largest gap on the way down to it. 0 or less: there
/// is a front now.
template <int Dim>
[[nodiscard]] double clearance(lod::PosedTree<Dim>& a, lod::PosedTree<Dim>& b, int level);

/// No point of one body comes nearer to a point of the other than at this speed, however the two
/// turn, for free motion and points within `radius_a` and `radius_b` of their centres of mass
/// [m/s].
template <int Dim>
[[nodiscard]] double fastest_approach(const lod::Body<Dim>& a, double radius_a,
                                      const lod::Body<Dim>& b, double radius_b);

/// Both bodies at a frame.
template <int Dim>
struct Moment {
    std::int64_t frame = 0;
    std::vector<lod::Body<Dim>> bodies;
};

/// Two bodies that fly freely, frame after frame, as lod::integrate moves them. Frames in which
/// nothing can happen are gone through without looking.
template <int Dim>
class FreeFlight {
  public:
    /// From a moment on. `step` is a frame's length [s].
    FreeFlight(Moment<Dim> start, double step);

    /// On to a frame before which the level has no front, and which the first front follows, or
    /// could follow, within two frames. False: not until `end` [s], and the flight stands beyond
    /// it.
    bool to_front(int level, double end);
    /// The same for a touch of the exact shapes, which must be apart now.
    bool to_near(double end);
    void step(std::int64_t frames);

    [[nodiscard]] const Moment<Dim>& now() const { return now_; }
    [[nodiscard]] double time() const { return static_cast<double>(now_.frame) * step_; }

  private:
    [[nodiscard]] std::int64_t clear_frames(double gap) const;

    double step_;
    double speed_;  ///< fastest_approach
    Moment<Dim> now_;
    lod::PosedTree<Dim> world_a_;
    lod::PosedTree<Dim> world_b_;
};

extern template class FreeFlight<2>;
extern template class FreeFlight<3>;

}  // namespace measure
