#include "lodlab/lod3d/mesh/merge_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/stop.hpp"

namespace lod3d {
namespace {

constexpr std::int32_t none = -1;
constexpr std::size_t points_between_checks = 4096;

/// By x, then y, z and number.
std::vector<std::int32_t> ordered(std::span<const Point> points) {
    std::vector<std::int32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
        const Point& p = points[lod::at(i)];
        const Point& q = points[lod::at(j)];
        return std::tie(p.x(), p.y(), p.z(), i) < std::tie(q.x(), q.y(), q.z(), j);
    });
    return order;
}

/// The number of a cell along each axis, a whole one. Doubles, since coordinates go to 1e100.
using Cell = std::array<double, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        std::size_t hash = 0;
        for (const double number : cell) hash = 31 * hash + std::hash<double>()(number);
        return hash;
    }
};

/// Calls visit(number) for all whole numbers of [low, high], or for all doubles of it where those
/// lie further apart.
template <class Visit>
void each_whole(double low, double high, const Visit& visit) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (double number = low;; number = std::max(number + 1, std::nextafter(number, infinity))) {
        visit(number);
        if (!(number < high)) return;
    }
}

/// The points that stand for themselves, in cells twice as wide as the tolerance. They are further
/// apart than that, so a cell holds at most 8, and all within reach of a point lie in 8 cells.
class Leaders {
  public:
    Leaders(std::span<const Point> points, double tolerance)
        : points_(points),
          tolerance_(tolerance),
          reach_(tolerance * (1 + 1e-15)),  // holds differences that were rounded down to it
          next_(points.size(), none),
          rank_(points.size(), none) {}

    /// The one that was added first of those within the tolerance of a point, or none.
    [[nodiscard]] std::int32_t first_near(const Point& p) {
        const Cell low = cell_of(p - Point::Constant(reach_));
        const Cell high = cell_of(p + Point::Constant(reach_));
        std::int32_t first = none;
        each_whole(low[0], high[0], [&](double x) {
            each_whole(low[1], high[1], [&](double y) {
                each_whole(low[2], high[2], [&](double z) {
                    ++steps_;
                    const auto found = head_.find({x, y, z});
                    if (found != head_.end()) first = first_of_list(found->second, p, first);
                });
            });
        });
        return first;
    }

    void add(std::int32_t i) {
        rank_[lod::at(i)] = count_++;
        const auto [place, is_new] = head_.try_emplace(cell_of(points_[lod::at(i)]), i);
        if (is_new) return;
        next_[lod::at(i)] = place->second;
        place->second = i;
    }

    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    [[nodiscard]] Cell cell_of(const Point& p) const {
        const double width = 2 * tolerance_;
        return {std::floor(p.x() / width), std::floor(p.y() / width), std::floor(p.z() / width)};
    }
    [[nodiscard]] std::int32_t first_of_list(std::int32_t i, const Point& p, std::int32_t first) {
        for (; i != none; i = next_[lod::at(i)]) {
            ++steps_;
            if ((p - points_[lod::at(i)]).cwiseAbs().maxCoeff() > tolerance_) continue;
            if (first == none || rank_[lod::at(i)] < rank_[lod::at(first)]) first = i;
        }
        return first;
    }

    std::span<const Point> points_;
    double tolerance_;
    double reach_;
    std::unordered_map<Cell, std::int32_t, CellHash> head_;  ///< of each cell's list
    std::vector<std::int32_t> next_;
    std::vector<std::int32_t> rank_;  ///< how many were added before
    std::int32_t count_ = 0;
    std::uint64_t steps_ = 0;
};

/// Equal points stand side by side.
MergedPoints merge_equal(std::span<const Point> points, std::span<const std::int32_t> order) {
    MergedPoints merged;
    merged.into.resize(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        merged.steps += i > 0;
        const bool again = i > 0 && points[lod::at(order[i])] == points[lod::at(order[i - 1])];
        merged.into[lod::at(order[i])] = again ? merged.into[lod::at(order[i - 1])] : order[i];
    }
    return merged;
}

}  // namespace

MergedPoints merge_points(std::span<const Point> points, double tolerance) {
    const std::vector<std::int32_t> order = ordered(points);
    if (tolerance == 0) return merge_equal(points, order);
    Leaders leaders(points, tolerance);
    MergedPoints merged;
    merged.into.resize(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % points_between_checks == 0) lod::check_interrupted();
        const std::int32_t point = order[i];
        const std::int32_t leader = leaders.first_near(points[lod::at(point)]);
        if (leader == none) leaders.add(point);
        merged.into[lod::at(point)] = leader == none ? point : leader;
    }
    merged.steps = leaders.steps();
    return merged;
}

}  // namespace lod3d
