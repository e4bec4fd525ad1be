#pragma once

/// \file
/// The collisions of a run as an observer sees them, and which of two runs' belong together.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "lodlab/core/tree/body.hpp"
#include "lodlab/measure/reference/box2d_reference.hpp"
#include "lodlab/scenes/run.hpp"

namespace measure {

/// What is asked of the true shapes of a scene's bodies.
template <int Dim>
class BodyShapes {
  public:
    virtual ~BodyShapes() = default;
    /// Diameter of the ball about the centre of mass that holds the shape of a body [m], > 0.
    [[nodiscard]] virtual double size(int body) const = 0;
    /// Between the shapes of bodies a and b where these states bring them [m]; where they overlap,
    /// minus how deep the deepest corner of one lies within the other.
    [[nodiscard]] virtual double separation(int a, const lod::Body<Dim>& state_a, int b,
                                            const lod::Body<Dim>& state_b) const = 0;
};

/// A collision as an observer sees it: two bodies are pushed apart, in one frame or in several that
/// follow each other closely.
template <int Dim>
struct Collision {
    int a = 0;         ///< index of body A
    int b = 0;         ///< index of body B, above a
    double time = 0;   ///< of the first push [s]
    double until = 0;  ///< of the last push [s]
    double gap = 0;    ///< between the shapes at the first push, 0 where they touch [m]
    /// How deep the shapes lie in each other at the worst of its pushes [m], >= 0.
    double penetration = 0;
    std::array<lod::Body<Dim>, 2> before;  ///< A and B at the first push, before it
    std::array<lod::Body<Dim>, 2> after;   ///< A and B where the last push found them, after it
};

/// Pushes of one pair that follow each other within so long are one collision [s]: three pictures
/// of a 60 Hz screen, which an observer does not take apart. Ours, not a published value.
inline constexpr double one_collision = 0.05;

/// Puts the pushes of a run together to collisions.
template <int Dim>
class CollisionLog {
  public:
    /// `shapes` must outlive the log. Requires pause >= 0.
    explicit CollisionLog(const BodyShapes<Dim>& shapes, double pause = one_collision)
        : shapes_(shapes), pause_(pause) {}

    /// One push, of its pair none before an earlier one; states of all bodies at that instant.
    /// Requires a != b.
    void add(double time, int a, int b, std::span<const lod::Body<Dim>> before,
             std::span<const lod::Body<Dim>> after);
    /// In the order in which their first pushes came.
    [[nodiscard]] const std::vector<Collision<Dim>>& collisions() const { return collisions_; }
    /// How many collisions `add` has looked at, in all.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    const BodyShapes<Dim>& shapes_;
    double pause_;
    std::vector<Collision<Dim>> collisions_;
    std::map<std::pair<int, int>, std::size_t> latest_;  ///< of each pair, into collisions_
    std::uint64_t steps_ = 0;
};

/// The collisions of a run by lodlab in order of time, the bodies as they were at its start (for
/// their masses). A backtracked pair is pushed at its time of impact; gap and penetration are those
/// that the frame shows. In space the velocity after a push is that of the next frame's beginning,
/// which for a tumbling body differs by the free motion of one frame.
template <int Dim>
[[nodiscard]] std::vector<Collision<Dim>> collisions_of(const scenes::Run<Dim>& run,
                                                        std::span<const lod::Body<Dim>> bodies,
                                                        const BodyShapes<Dim>& shapes,
                                                        double pause = one_collision);

/// The same of a run by Box2D.
[[nodiscard]] std::vector<Collision<2>> collisions_of(const lod2d::Box2dRun& run,
                                                      const BodyShapes<2>& shapes,
                                                      double pause = one_collision);

/// Which collisions of two runs are the same event.
struct Matching {
    /// Two that are the same event.
    struct Pair {
        int reference = 0;  ///< index into the reference's collisions
        int seen = 0;       ///< index into the other's
    };
    std::vector<Pair> pairs;   ///< by reference
    std::vector<int> missing;  ///< only in the reference
    std::vector<int> extra;    ///< only in the other
};

/// For each two bodies, the pairing of their collisions in both runs that keeps their order and
/// costs least: a pair costs the time between the two, a collision left alone half the window. So
/// nothing is paired that lies further apart than the window [s], and swapping the runs swaps
/// missing and extra. Both lists in order of time.
template <int Dim>
[[nodiscard]] Matching match(std::span<const Collision<Dim>> reference,
                             std::span<const Collision<Dim>> seen, double window);

}  // namespace measure
