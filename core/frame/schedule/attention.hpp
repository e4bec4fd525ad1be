#pragma once

/// \file
/// How much of an observer's attention a pair of bodies has: what Priority::perceptual goes by.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/core/frame/broad_phase.hpp"
#include "lodlab/core/math/dimension.hpp"

namespace lod {

/// Who looks, and where. What is known (METHOD.md, perception) is that sensitivity falls with the
/// angle from the point of fixation, among distractors and behind others; every number here is
/// ours, none was tested by observers. World frame; the plane lies at z = 0.
struct Viewer {
    /// x, y, z [m].
    using Point = std::array<double, 3>;

    Point fixation{};               ///< the point looked at [m]
    std::optional<Point> eye = {};  ///< nothing: `distance` from the fixation point along z
    double distance = 10;           ///< [m], > 0: a scene of some metres fills the view
    /// Angle from the fixation point, as a tangent, at which sensitivity is half: 6 degrees, about
    /// the width of the part of the eye that sees sharply.
    double half_sensitivity = 0.1;
    double speed = 1;  ///< closing speed that doubles attention [m/s]: a body's length a second
    /// What each other body near by takes: ten of them leave half.
    double distractor = 0.1;
    double behind_another = 0.1;  ///< share of attention that is left to what another body hides
};

/// The attention that each pair has. Bodies are dealt into the cells of a screen; those of a pair's
/// cell distract from it, and the nearest of them may hide it: n bodies and m pairs take n + m
/// steps. Keeps its storage.
template <int Dim>
class Attention {
  public:
    /// Replaces `attention`: of each pair its size on the screen (the smaller ball's tangent),
    /// times what the viewer's settings make of closing speed, angle, distractors and hiding.
    void weigh(const Viewer& viewer, std::span<const Body<Dim>> bodies,
               std::span<const CandidatePair> pairs, std::vector<double>& attention);

  private:
    using Point = Vector<3>;
    /// On the screen, in tangents from the fixation point.
    struct Seen {
        double across = 0;
        double up = 0;
        double depth = 0;   ///< [m]; <= 0: behind the eye
        double radius = 0;  ///< [m]
    };
    struct Cell {
        std::int32_t bodies = 0;
        std::int32_t nearest = -1;
    };
    static constexpr int cells_a_side = 32;

    void look_from(const Viewer& viewer);
    [[nodiscard]] Seen seen(const Vector<Dim>& point, double radius) const;
    [[nodiscard]] std::size_t cell_of(const Seen& seen) const;
    void deal(std::span<const Body<Dim>> bodies);
    [[nodiscard]] double of_pair(const Viewer& viewer, const Body<Dim>& a, const Body<Dim>& b,
                                 const CandidatePair& pair) const;
    [[nodiscard]] bool is_hidden(const Seen& middle, const CandidatePair& pair) const;

    Point eye_ = Point::Zero();
    Point ahead_ = Point::Unit(2);
    Point right_ = Point::Unit(0);
    Point up_ = Point::Unit(1);
    double cell_size_ = 1;
    std::vector<Seen> seen_;  ///< of each body
    std::vector<Cell> cells_;
};

/// Approach of the centres of mass [m/s]; negative when they part.
template <int Dim>
[[nodiscard]] double closing_speed(const Body<Dim>& a, const Body<Dim>& b);

extern template class Attention<2>;
extern template class Attention<3>;

}  // namespace lod
