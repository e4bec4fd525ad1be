#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lodlab/core/base/lanes.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/math/sphere.hpp"

namespace lod {

/// Signed distance from a shape's surface, negative inside [m], and the way in which it grows.
template <int Dim>
struct SlopedDistance {
    double value = 0;
    Vector<Dim> gradient = Vector<Dim>::Zero();
};

/// A quick, perhaps approximate, signed distance.
template <class Field, int Dim>
concept DistanceFieldOf = requires(const Field field, const Vector<Dim> p) {
    { field.at(p) } -> std::convertible_to<SlopedDistance<Dim>>;
};

/// Balls that cover points and stand out of the shape by no more than `protrusion`, by the bound
/// radius less depth of the centre.
template <int Dim>
struct PointCover {
    std::vector<Sphere<Dim>> balls;
    double protrusion = std::numeric_limits<double>::infinity();
};

namespace detail {

/// How CoverSearch goes downhill; lengths are shares of the size that the points spread over. No
/// number is derived. Each halved and doubled, the others kept, the sphere trees of gear:7, L and
/// blob (depth 2, effort 0.15) have leaves that stand out by so many % of the diameter, where 5.43,
/// 4.50 and 3.14 are those as it is:
///
///     softness            5.40 4.64 3.70   5.37 4.51 3.25
///     alike (0.15, 0.6)   5.41 4.49 3.15   5.32 4.94 4.52
///     kept (0.4, 0.95)    5.30 4.37 3.47   5.39 5.38 3.93
///     stride              5.31 4.79 7.99   5.33 4.68 3.48
///     last sharpness      5.40 4.42 3.62   5.34 4.60 3.05
///     squarings           5.31 4.55 3.49   5.30 5.24 3.81
///
/// Other random starts change them by about as much (lod3d/builder/ball_fit.cpp): only a short
/// stride, steps all alike and much that is kept are worse beyond that.
struct Descent {
    static constexpr double softness = 0.06;  ///< needs less than the worst by so much still count
    static constexpr double alike = 0.3;      ///< weight of one step length for all centres, and
    static constexpr double steep = 0.7;      ///< of steps in proportion to the slopes
    static constexpr double kept = 0.8;       ///< share of the last step that goes on, and
    static constexpr double added = 0.2;      ///< of the new slope
    static constexpr double stride = 0.04;    ///< of the steepest centre, in the first round
    static constexpr double last_sharpness = 1.0 / 64;  ///< of softness and stride at the end
    static constexpr int squarings = 4;  ///< the next start is drawn by what it needs, to the 16th
};

/// A ball about c that just holds p stands out by f(p, c) = |p - c| + s(c) at most, s the signed
/// distance. So `count` balls stand out by E(c) = max over p of min over c of f(p, c). Both the max
/// and the min are softened, so that E has a slope, and sharpened again round by round.
///
/// Works on eight points at a time in single precision, relative to one of the points: the search
/// only proposes, and what comes of it is fitted and certified in double precision.
template <int Dim, DistanceFieldOf<Dim> Field>
class CoverSearch {
  public:
    using Centres = std::vector<Vector<Dim>>;

    /// Requires at least one point, which must outlive this.
    CoverSearch(const Field& field, std::span<const Vector<Dim>> points, double size)
        : field_(field), points_(points), size_(size), blocks_((points.size() + 7) / 8) {
        place_.resize(blocks_ * Dim, Eight::all(0));
        weight_.resize(blocks_, Eight::all(0));  // those behind the last point count nothing
        least_.resize(blocks_);
        for (std::size_t p = 0; p < points.size(); ++p) {
            for (std::size_t d = 0; d < Dim; ++d)
                place_[p / 8 * Dim + d].set(p % 8, relative(points[p], d));
            set_weight(p, 1);
        }
    }

    /// Of a point; where it is larger, balls shall stand out less.
    [[nodiscard]] float weight(std::size_t point) const { return weight_[point / 8][point % 8]; }
    void set_weight(std::size_t point, float weight) { weight_[point / 8].set(point % 8, weight); }

    /// The first centre is a random point, each next one a point that the balls so far would have
    /// to stand out furthest for, more or less.
    Centres start(int count, Random& random) const {
        Centres centres{pick(random.next() * static_cast<double>(points_.size()))};
        std::vector<double> least(points_.size(), std::numeric_limits<double>::infinity());
        std::vector<double> sum(points_.size());
        while (static_cast<int>(centres.size()) < count) {
            double total = 0;
            const double depth = (std::min)(0.0, field_.at(centres.back()).value);
            for (std::size_t p = 0; p < points_.size(); ++p) {
                const double needs = (points_[p] - centres.back()).norm() + depth;
                least[p] = (std::min)(least[p], needs);
                double weight = (std::max)(least[p], 0.0) / size_;
                for (int squaring = 0; squaring < Descent::squarings; ++squaring) weight *= weight;
                sum[p] = total += weight;
            }
            const auto at = std::lower_bound(sum.begin(), sum.end(), random.next() * total);
            centres.push_back(pick(static_cast<double>(at - sum.begin())));
        }
        return centres;
    }

    /// Goes downhill from the centres; returns the least E met and leaves its centres.
    double descend(Centres& centres, int rounds) {
        const std::size_t count = centres.size();
        Centres best = centres;
        Centres push(count, Vector<Dim>::Zero());
        double least = std::numeric_limits<double>::infinity();
        for (int round = 0; round <= rounds; ++round) {
            const double share = static_cast<double>(round) / (rounds + 1);
            const double sharpness = falling(share);
            const double worst = measure(centres);
            if (worst < least) {
                least = worst;
                best = centres;
            }
            const Centres& slope = slopes(centres, worst, Descent::softness * size_ * sharpness);
            double steepest = 0;
            for (const Vector<Dim>& s : slope) steepest = (std::max)(steepest, s.norm());
            if (steepest == 0) break;
            for (std::size_t i = 0; i < count; ++i) {
                const double scale = Descent::alike * steepest + Descent::steep * slope[i].norm();
                push[i] = Descent::kept * push[i] + Descent::added / scale * slope[i];
                centres[i] -= Descent::stride * size_ * sharpness * push[i];
            }
        }
        centres = best;
        return least;
    }

    /// The least balls about the centres that hold the points which they hold most cheaply.
    PointCover<Dim> cover(const Centres& centres) {
        PointCover<Dim> result;
        result.protrusion = (std::max)(0.0, measure(centres));
        for (const Vector<Dim>& c : centres) result.balls.push_back({c, 0});
        for (std::size_t p = 0; p < points_.size(); ++p) {
            const std::size_t lane = p % 8;
            const Eight* needs = &needs_[p / 8 * centres.size()];
            std::size_t own = 0;
            while (needs[own][lane] > least_[p / 8][lane]) ++own;
            Sphere<Dim>& ball = result.balls[own];
            ball.radius = (std::max)(ball.radius, (points_[p] - ball.centre).norm());
        }
        return result;
    }

  private:
    using Eight = Lanes<8>;

    [[nodiscard]] float relative(const Vector<Dim>& p, std::size_t d) const {
        return static_cast<float>(p[d] - points_[0][d]);
    }

    Vector<Dim> pick(double number) const {
        return points_[(std::min)(static_cast<std::size_t>(number), points_.size() - 1)];
    }

    /// From 1 to last_sharpness over shares 0 to 1; rational, for the same bits from every library.
    static double falling(double share) {
        const double left = (1 - share) * (1 - share);
        return left * left + Descent::last_sharpness;
    }

    /// 1 at 0, falling like x^-4.
    static Eight falling_off(const Eight& x) {
        const Eight slow = Eight::all(1) / (Eight::all(1) + Eight::all(0.25f) * x);
        const Eight square = slow * slow;
        return square * square;
    }

    /// Keeps f and its least for every point; returns E.
    double measure(const Centres& centres) {
        const std::size_t count = centres.size();
        sloped_.clear();
        from_.clear();
        for (const Vector<Dim>& c : centres) {
            sloped_.push_back(field_.at(c));
            for (std::size_t d = 0; d < Dim; ++d) from_.push_back(relative(c, d));
        }
        distance_.resize(blocks_ * count);
        needs_.resize(blocks_ * count);
        Eight worst = Eight::all(0);
        for (std::size_t b = 0; b < blocks_; ++b) {
            Eight least = Eight::all(std::numeric_limits<float>::infinity());
            for (std::size_t i = 0; i < count; ++i) {
                Eight squared = Eight::all(0);
                for (std::size_t d = 0; d < Dim; ++d) {
                    const Eight arm = place_[b * Dim + d] - Eight::all(from_[i * Dim + d]);
                    squared += arm * arm;
                }
                const Eight distance = square_root(squared);
                const Eight needs = distance + Eight::all(static_cast<float>(sloped_[i].value));
                distance_[b * count + i] = distance;
                needs_[b * count + i] = needs;
                least = lower(least, needs);
            }
            least_[b] = least;
            worst = upper(worst, weight_[b] * least);
        }
        return worst.most();
    }

    /// The slope of the softened E for each centre, from what measure() kept.
    const Centres& slopes(const Centres& centres, double worst, double softness) {
        const std::size_t count = centres.size();
        const Eight sharp = Eight::all(static_cast<float>(1 / softness));
        const Eight tiny = Eight::all(static_cast<float>(1e-12 * size_));
        share_.resize(count);
        sums_.assign(count * (Dim + 1), Eight::all(0));
        for (std::size_t b = 0; b < blocks_; ++b) {
            const Eight least = least_[b];
            Eight total = Eight::all(0);
            for (std::size_t i = 0; i < count; ++i) {
                const Eight share = falling_off((needs_[b * count + i] - least) * sharp);
                share_[i] = share * share;
                total += share_[i];
            }
            const Eight behind =
                (Eight::all(static_cast<float>(worst)) - weight_[b] * least) * sharp;
            const Eight matters = weight_[b] * falling_off(behind) / total;
            for (std::size_t i = 0; i < count; ++i) {
                Eight* sum = &sums_[i * (Dim + 1)];
                const Eight pull = matters * share_[i];
                sum[Dim] += pull;
                const Eight by_length = pull / upper(distance_[b * count + i], tiny);
                for (std::size_t d = 0; d < Dim; ++d)
                    sum[d] += by_length * (Eight::all(from_[i * Dim + d]) - place_[b * Dim + d]);
            }
        }
        slope_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const Eight* sum = &sums_[i * (Dim + 1)];
            Vector<Dim> slope = static_cast<double>(sum[Dim].sum()) * sloped_[i].gradient;
            for (std::size_t d = 0; d < Dim; ++d) slope[d] += static_cast<double>(sum[d].sum());
            slope_.push_back(slope);
        }
        return slope_;
    }

    const Field& field_;
    std::span<const Vector<Dim>> points_;
    double size_;
    std::size_t blocks_;                       ///< of eight points
    std::vector<Eight> place_;                 ///< of each block, one entry a coordinate
    std::vector<Eight> weight_;                ///< of each block
    std::vector<Eight> least_;                 ///< of each block: the least f
    std::vector<SlopedDistance<Dim>> sloped_;  ///< of each centre
    std::vector<float> from_;                  ///< place of each centre, as place_
    std::vector<Eight> distance_;              ///< of each block and centre
    std::vector<Eight> needs_;                 ///< f of each block and centre
    std::vector<Eight> share_;  ///< of one block: how far its points are each centre's business
    std::vector<Eight> sums_;   ///< of each centre: Dim numbers of its arms, and its pull
    std::vector<Vector<Dim>> slope_;  ///< of each centre
};

}  // namespace detail

}  // namespace lod
