#pragma once

#include "lodlab/core/builder/grow.hpp"
#include "lodlab/lod3d/builder/distance_field.hpp"
#include "lodlab/lod3d/builder/piece.hpp"

namespace lod3d {

/// No number is derived. Halved and doubled, as in lod::detail::Descent: rounds 5.49 5.28 4.54 and
/// 5.25 4.62 3.69 %, starts 5.29 4.60 4.03 and 5.17 4.50 3.14 % (gear:7 took 0.7 s instead of 0.4),
/// spacing 5.21 4.23 4.27 % (three times as long) and 5.28 4.69 3.51 %; easy_share made next to no
/// difference there.
struct BallFitSettings {
    /// The search for a cover of a piece that is easy to divide; its count is the branching.
    lod::CoverSettings quick{.starts = 24, .rounds = 300, .finalists = 1};
    /// The search where the quick cover stands out by more than easy_share of what the parent's
    /// ball stands out by.
    lod::CoverSettings thorough{.starts = 160, .rounds = 300, .finalists = 6, .foresights = 6};
    double easy_share = 0.42;
    double spacing = 0.08;  ///< of the points that stand for a piece, share of its radius
};

/// Divides pieces of a solid, and fits balls to them, so that the balls stand out little: what
/// lod::grow_tree asks of a kind of shape.
class BallFit {
  public:
    /// All must outlive this. A ball holds its piece with `spare` left [m].
    BallFit(const MeshDistance& distance, const DistanceField& field, double spare,
            const BallFitSettings& settings)
        : distance_(distance), field_(field), spare_(spare), settings_(settings) {}

    /// A cover of points spread over the piece, its surface and its interior (lod::cover_points).
    /// Where levels follow, it is of the best few the one that leaves most to gain there.
    [[nodiscard]] std::vector<std::vector<lod::Sphere<3>>> starts(const MeshPiece& piece,
                                                                  const lod::Sphere<3>& ball,
                                                                  int count,
                                                                  int levels_after) const;

    [[nodiscard]] std::vector<std::vector<lod::Sphere<3>>> starts(const MeshPiece& piece,
                                                                  const lod::Sphere<3>& ball,
                                                                  int count) const {
        return starts(piece, ball, count, 0);
    }

    /// Covers of the same points from other random starts.
    [[nodiscard]] std::vector<std::vector<lod::Sphere<3>>> more_starts(const MeshPiece& piece,
                                                                       const lod::Sphere<3>& ball,
                                                                       int count,
                                                                       int attempt) const;

    /// A ball that holds the piece's vertices. Of the starting ball's centre and the centre of the
    /// least enclosing ball it takes the better and walks downhill: about a centre x the ball needs
    /// the radius R(x), the farthest vertex, and stands out by R(x) - depth(x) at most.
    [[nodiscard]] lod::Sphere<3> fit(const MeshPiece& piece, const lod::Sphere<3>& start) const;

    /// How far a ball stands out, from above, within a twentieth.
    [[nodiscard]] double protrusion(const lod::Sphere<3>& ball) const;

  private:
    const MeshDistance& distance_;
    const DistanceField& field_;
    double spare_;
    BallFitSettings settings_;
};

/// Points spread over a piece no wider than about the spacing [m]: over its surface, its interior
/// and all its corners that stand out in some direction.
[[nodiscard]] std::vector<Point> spread_points(const MeshPiece& piece, const MeshDistance& distance,
                                               double spacing);

}  // namespace lod3d
