#include "lodlab/lod2d/builder/medial_cover.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lod2d {
namespace {

using Disc = lod::Sphere<2>;

class Cover {
  public:
    Cover(std::span<const FacingPoint> points, std::span<const FacingDisc> discs,
          double normal_weight)
        : points_(points.size()), discs_(discs.size()), words_((points.size() + 63) / 64) {
        need_.reserve(points_ * discs_);
        for (const FacingDisc& d : discs)
            for (const FacingPoint& p : points) {
                const double gap = (p.at - d.disc.centre).norm() - d.disc.radius;
                const bool facing = !p.normal.isZero(0) && !d.normal.isZero(0);
                const double turned = facing ? (1 - d.normal.dot(p.normal)) / 2 : 0;
                need_.push_back(std::max(0.0, gap) + normal_weight * d.disc.radius * turned);
            }
    }

    /// What disc d must grow by to hold point p.
    [[nodiscard]] double need(std::size_t d, std::size_t p) const { return need_[d * points_ + p]; }

    /// Takes the disc that holds the most points not yet held, again and again; fewer than all
    /// points may be held at the end.
    [[nodiscard]] std::vector<std::size_t> greedy(double allowance, int count, bool& all) const {
        const std::vector<std::uint64_t> holds = held_by_each(allowance);
        std::vector<std::uint64_t> open(words_, ~std::uint64_t{0});
        std::size_t left = points_;
        std::vector<std::size_t> chosen;
        while (left > 0 && static_cast<int>(chosen.size()) < count) {
            std::size_t best = 0;
            std::size_t best_gain = 0;
            for (std::size_t d = 0; d < discs_; ++d) {
                std::size_t gain = 0;
                for (std::size_t w = 0; w < words_; ++w)
                    gain +=
                        static_cast<std::size_t>(std::popcount(holds[d * words_ + w] & open[w]));
                if (gain > best_gain) {
                    best = d;
                    best_gain = gain;
                }
            }
            if (best_gain == 0) break;
            chosen.push_back(best);
            for (std::size_t w = 0; w < words_; ++w) open[w] &= ~holds[best * words_ + w];
            left -= best_gain;
        }
        all = left == 0;
        return chosen;
    }

    /// An allowance with which any one disc holds every point.
    [[nodiscard]] double enough() const {
        return need_.empty() ? 0 : *std::max_element(need_.begin(), need_.end());
    }

  private:
    /// The points that each disc holds, one bit each, words_ words a disc.
    [[nodiscard]] std::vector<std::uint64_t> held_by_each(double allowance) const {
        std::vector<std::uint64_t> holds(discs_ * words_, 0);
        for (std::size_t d = 0; d < discs_; ++d)
            for (std::size_t p = 0; p < points_; ++p)
                holds[d * words_ + p / 64] |= std::uint64_t{need(d, p) <= allowance} << p % 64;
        return holds;
    }

    std::size_t points_;
    std::size_t discs_;
    std::size_t words_;
    std::vector<double> need_;
};

}  // namespace

std::vector<Disc> least_growth_cover(std::span<const FacingPoint> points,
                                     std::span<const FacingDisc> discs, int count,
                                     double normal_weight) {
    if (points.empty() || discs.empty()) return {};
    const Cover cover(points, discs, normal_weight);
    double high = cover.enough();
    double low = 0;
    bool all = false;
    std::vector<std::size_t> chosen = cover.greedy(high, count, all);
    constexpr int halvings = 24;
    for (int i = 0; i < halvings && high > 0; ++i) {
        // Protrusions span decades: bisect by the geometric mean where that is possible.
        const double middle = low > 0 ? std::sqrt(low * high) : high / 4;
        if (low > 0 && high < low * 1.02) break;
        const auto attempt = cover.greedy(middle, count, all);
        if (all) {
            chosen = attempt;
            high = middle;
        } else {
            low = middle;
        }
    }
    std::vector<Disc> grown;
    for (const std::size_t d : chosen) grown.push_back(discs[d].disc);
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::size_t least = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (cover.need(chosen[i], p) < cover.need(chosen[least], p)) least = i;
        Disc& disc = grown[least];
        disc.radius = std::max(disc.radius, (points[p].at - disc.centre).norm());
    }
    return grown;
}

}  // namespace lod2d
