#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <vector>

#include "core/builder/enclosing_ball.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/sphere.hpp"

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

struct CoverSettings {
    int count = 8;              ///< balls, at least 1
    int starts = 40;            ///< random starts
    int rounds = 300;           ///< of going downhill, for the best of the starts
    int finalists = 3;          ///< starts that are carried to the end
    int foresight_starts = 12;  ///< random starts of each quick cover of the next level
    int foresights = 8;         ///< times that a finalist is changed for the good of the next level
};

namespace detail {

/// A ball about c that just holds p stands out by f(p, c) = |p - c| + s(c) at most, s the signed
/// distance. So `count` balls stand out by E(c) = max over p of min over c of f(p, c). Both the max
/// and the min are softened, so that E has a slope, and sharpened again round by round.
template <int Dim, DistanceFieldOf<Dim> Field>
class CoverSearch {
  public:
    using Centres = std::vector<Vector<Dim>>;

    CoverSearch(const Field& field, std::span<const Vector<Dim>> points, double size)
        : field_(field), points_(points), size_(size) {
        place_.resize(static_cast<Eigen::Index>(points.size()), Dim);
        for (Eigen::Index p = 0; p < place_.rows(); ++p)
            place_.row(p) = points[static_cast<std::size_t>(p)].transpose();
        weight_.setOnes(place_.rows());
    }

    /// Of each point; where it is larger, balls shall stand out less.
    Eigen::ArrayXd& weights() { return weight_; }

    /// The first centre is a random point, each next one a point that the balls so far would have
    /// to stand out furthest for, more or less.
    Centres start(int count, Random& random) const {
        Centres centres{pick(random.next() * static_cast<double>(points_.size()))};
        std::vector<double> least(points_.size(), std::numeric_limits<double>::infinity());
        while (static_cast<int>(centres.size()) < count) {
            std::vector<double> sum;
            double total = 0;
            const double depth = std::min(0.0, field_.at(centres.back()).value);
            for (std::size_t p = 0; p < points_.size(); ++p) {
                const double needs = (points_[p] - centres.back()).norm() + depth;
                least[p] = std::min(least[p], needs);
                double weight = std::max(least[p], 0.0) / size_;
                for (int squaring = 0; squaring < 4; ++squaring) weight *= weight;
                sum.push_back(total += weight);
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
            const Centres slope = slopes(centres, worst, 0.06 * size_ * sharpness);
            double steepest = 0;
            for (const Vector<Dim>& s : slope) steepest = std::max(steepest, s.norm());
            if (steepest == 0) break;
            for (std::size_t i = 0; i < count; ++i) {
                // Between one step length for all and steps in proportion to the slopes.
                const double scale = 0.3 * steepest + 0.7 * slope[i].norm();
                push[i] = 0.8 * push[i] + 0.2 / scale * slope[i];
                centres[i] -= 0.04 * size_ * sharpness * push[i];
            }
        }
        centres = best;
        return least;
    }

    /// The least balls about the centres that hold the points which they hold most cheaply.
    PointCover<Dim> cover(const Centres& centres) {
        static_cast<void>(measure(centres));
        PointCover<Dim> result;
        for (const Vector<Dim>& c : centres) result.balls.push_back({c, 0});
        result.protrusion = std::max(0.0, least_.maxCoeff());
        for (Eigen::Index p = 0; p < place_.rows(); ++p) {
            Eigen::Index own = 0;
            while (needs_(p, own) > least_[p]) ++own;
            double& radius = result.balls[static_cast<std::size_t>(own)].radius;
            radius = std::max(radius, distance_(p, own));
        }
        return result;
    }

  private:
    Vector<Dim> pick(double number) const {
        return points_[std::min(static_cast<std::size_t>(number), points_.size() - 1)];
    }

    /// From 1 to 1/64 over shares 0 to 1; rational, for the same bits from every library.
    static double falling(double share) {
        const double left = (1 - share) * (1 - share);
        return left * left + 1.0 / 64;
    }

    /// 1 at 0, falling like x^-4.
    static auto falling_off(const Eigen::ArrayXd& x) {
        return (1 + 0.25 * x).square().square().inverse().eval();
    }

    /// Keeps f and its least for every point; returns E.
    double measure(const Centres& centres) {
        const auto count = static_cast<Eigen::Index>(centres.size());
        sloped_.clear();
        for (const Vector<Dim>& c : centres) sloped_.push_back(field_.at(c));
        distance_.resize(place_.rows(), count);
        needs_.resize(place_.rows(), count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const Vector<Dim>& c = centres[static_cast<std::size_t>(i)];
            auto squared = distance_.col(i);
            squared = (place_.col(0) - c[0]).square();
            for (int d = 1; d < Dim; ++d) squared += (place_.col(d) - c[d]).square();
            distance_.col(i) = squared.sqrt();
            needs_.col(i) = distance_.col(i) + sloped_[static_cast<std::size_t>(i)].value;
            if (i == 0)
                least_ = needs_.col(0);
            else
                least_ = least_.min(needs_.col(i));
        }
        return (weight_ * least_).maxCoeff();
    }

    /// The slope of the softened E for each centre, from what measure() kept.
    Centres slopes(const Centres& centres, double worst, double softness) {
        const auto count = static_cast<Eigen::Index>(centres.size());
        share_.resize(place_.rows(), count);
        total_.setZero(place_.rows());
        for (Eigen::Index i = 0; i < count; ++i) {
            share_.col(i) = falling_off((needs_.col(i) - least_) / softness).square();
            total_ += share_.col(i);
        }
        matters_ = weight_ * falling_off((worst - weight_ * least_) / softness) / total_;
        Centres slope;
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            pull_ = matters_ * share_.col(i);
            Vector<Dim> sum = pull_.sum() * sloped_[at].gradient;
            pull_ /= distance_.col(i).max(1e-12 * size_);
            for (int d = 0; d < Dim; ++d)
                sum[d] += (pull_ * (centres[at][d] - place_.col(d))).sum();
            slope.push_back(sum);
        }
        return slope;
    }

    const Field& field_;
    std::span<const Vector<Dim>> points_;
    double size_;
    std::vector<SlopedDistance<Dim>> sloped_;          ///< of each centre
    Eigen::Array<double, Eigen::Dynamic, Dim> place_;  ///< the points, one array a coordinate
    Eigen::ArrayXXd distance_;                         ///< of each point from each centre
    Eigen::ArrayXXd needs_;                            ///< f of each point and centre
    Eigen::ArrayXXd share_;  ///< how far each point is each centre's business
    Eigen::ArrayXd least_;   ///< of each point: the least f
    Eigen::ArrayXd weight_;  ///< of each point
    Eigen::ArrayXd total_;
    Eigen::ArrayXd matters_;
    Eigen::ArrayXd pull_;
};

}  // namespace detail

/// Covers points by `count` balls so that the worst stands out little: the best of many random
/// starts, each going downhill on a softened form of what is to be least. The best first, up to
/// `finalists` covers. `size` is a length that the points spread over, such as the radius of their
/// enclosing ball. Deterministic for a seed. Requires at least one point, count >= 1.
template <int Dim, DistanceFieldOf<Dim> Field>
[[nodiscard]] std::vector<PointCover<Dim>> cover_points(const Field& field,
                                                        std::span<const Vector<Dim>> points,
                                                        double size, std::uint64_t seed,
                                                        const CoverSettings& settings) {
    // The starts compete on a few of the points; the finalists have to hold them all.
    constexpr std::size_t most_for_starts = 400;
    const std::size_t stride = 1 + points.size() / most_for_starts;
    std::vector<Vector<Dim>> few;
    for (std::size_t p = 0; p < points.size(); p += stride) few.push_back(points[p]);
    detail::CoverSearch<Dim, Field> rough(field, few, size);
    detail::CoverSearch<Dim, Field> search(field, points, size);
    Random random(seed);
    struct Candidate {
        std::vector<Vector<Dim>> centres;
        double protrusion;
    };
    std::vector<Candidate> candidates;
    const auto better = [](const Candidate& a, const Candidate& b) {
        return a.protrusion < b.protrusion;
    };
    for (int start = 0; start < settings.starts; ++start) {
        check_interrupted();
        Candidate candidate{rough.start(settings.count, random), 0};
        candidate.protrusion = rough.descend(candidate.centres, settings.rounds / 4);
        candidates.push_back(std::move(candidate));
    }
    std::stable_sort(candidates.begin(), candidates.end(), better);
    candidates.resize(std::min(candidates.size(), static_cast<std::size_t>(settings.finalists)));
    for (Candidate& candidate : candidates)
        candidate.protrusion = search.descend(candidate.centres, settings.rounds);
    std::stable_sort(candidates.begin(), candidates.end(), better);
    std::vector<PointCover<Dim>> covers;
    for (const Candidate& candidate : candidates) covers.push_back(search.cover(candidate.centres));
    return covers;
}

/// For each point the ball whose power cell it is in.
template <int Dim>
[[nodiscard]] std::vector<std::size_t> power_owners(std::span<const Vector<Dim>> points,
                                                    std::span<const Sphere<Dim>> balls) {
    std::vector<std::size_t> owners;
    for (const Vector<Dim>& p : points) {
        std::size_t own = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const double power =
                (p - balls[i].centre).squaredNorm() - balls[i].radius * balls[i].radius;
            if (power < least) {
                least = power;
                own = i;
            }
        }
        owners.push_back(own);
    }
    return owners;
}

namespace detail {

/// For each ball of a cover, about what the balls of the next level will stand out by in its power
/// cell: quick covers of the points there.
template <int Dim, DistanceFieldOf<Dim> Field>
std::vector<double> look_ahead(const Field& field, std::span<const Vector<Dim>> points,
                               std::span<const std::size_t> owners, std::size_t balls, int count,
                               int starts, std::uint64_t seed) {
    const CoverSettings quick{.count = count, .starts = starts, .rounds = 100, .finalists = 2};
    std::vector<std::vector<Vector<Dim>>> cells(balls);
    for (std::size_t p = 0; p < points.size(); ++p) cells[owners[p]].push_back(points[p]);
    std::vector<double> next;
    for (const auto& cell : cells) {
        next.push_back(0);
        if (static_cast<int>(cell.size()) <= count) continue;
        const double size = enclosing_ball<Dim>(cell).radius;
        next.back() =
            cover_points<Dim>(field, std::span<const Vector<Dim>>(cell), size, seed, quick)
                .front()
                .protrusion;
    }
    return next;
}

}  // namespace detail

/// As cover_points, but with an eye on the level below: a cover is worth the protrusion of its own
/// worst ball and three times that of the worst ball of the next level, where it is about halved.
/// Where the next level would stand out far, points gain weight, so that balls there become
/// smaller.
template <int Dim, DistanceFieldOf<Dim> Field>
[[nodiscard]] PointCover<Dim> cover_with_foresight(const Field& field,
                                                   std::span<const Vector<Dim>> points, double size,
                                                   std::uint64_t seed,
                                                   const CoverSettings& settings) {
    PointCover<Dim> best;
    double least = std::numeric_limits<double>::infinity();
    for (const PointCover<Dim>& start : cover_points<Dim>(field, points, size, seed, settings)) {
        detail::CoverSearch<Dim, Field> search(field, points, size);
        std::vector<Vector<Dim>> centres;
        for (const Sphere<Dim>& ball : start.balls) centres.push_back(ball.centre);
        PointCover<Dim> cover = start;
        for (int round = 0; round < settings.foresights; ++round) {
            check_interrupted();
            const auto owners = power_owners<Dim>(points, cover.balls);
            const std::vector<double> next =
                detail::look_ahead<Dim>(field, points, owners, cover.balls.size(), settings.count,
                                        settings.foresight_starts, seed);
            const double worst = *std::max_element(next.begin(), next.end());
            const double worth = cover.protrusion + 3 * worst;
            if (worth < least) {
                least = worth;
                best = cover;
            }
            for (std::size_t p = 0; p < points.size(); ++p) {
                const double share = std::max(next[owners[p]] / worst, 0.25);
                double& weight = search.weights()[static_cast<Eigen::Index>(p)];
                weight = std::clamp(1.2 * std::sqrt(share) * weight, 0.25, 4.0);
            }
            search.descend(centres, settings.rounds / 2);
            cover = search.cover(centres);
        }
    }
    return best;
}

}  // namespace lod
