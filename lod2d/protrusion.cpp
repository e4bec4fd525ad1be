#include "lod2d/protrusion.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/error.hpp"

namespace lod2d {
namespace {

/// A square that may hold the point of a disc that is farthest from the shape.
struct Cell {
    double most;  ///< no point of the disc in the cell is farther from the shape
    Point centre;
    double half;  ///< of a side; 0: the whole disc, not looked into so far
    std::size_t disc;

    bool operator<(const Cell& other) const { return most < other.most; }
};

class Search {
  public:
    Search(const BoundaryIndex& shape, std::span<const lod::Sphere<2>> discs)
        : shape_(shape), discs_(discs), depth_(discs.size()) {}

    Protrusion run(double tolerance, int most_queries) {
        for (std::size_t i = 0; i < discs_.size(); ++i) {
            depth_[i] = -shape_.signed_distance(discs_[i].centre);
            cells_.push({std::max(0.0, discs_[i].radius - depth_[i]), discs_[i].centre, 0, i});
        }
        queries_ = 0;
        while (!cells_.empty() && cells_.top().most > found_.least + tolerance &&
               queries_ < most_queries) {
            const Cell cell = cells_.top();
            cells_.pop();
            if (cell.half == 0)
                open(cell.disc);
            else
                quarter(cell);
            if (queries_ % 1024 == 0) lod::check_interrupted();
        }
        found_.most = found_.least;
        if (!cells_.empty()) found_.most = std::max(found_.least, cells_.top().most);
        return found_;
    }

  private:
    /// A disc without pockets in reach stands out most beyond its nearest border point.
    void open(std::size_t disc) {
        const lod::Sphere<2>& d = discs_[disc];
        const Point nearest = shape_.nearest(d.centre).point;
        const Point out = (depth_[disc] >= 0 ? nearest - d.centre : d.centre - nearest);
        if (out.norm() > 0) distance_at(d.centre + d.radius * out.stableNormalized());
        add(d.centre, d.radius, disc, d.radius - depth_[disc]);
    }

    void quarter(const Cell& cell) {
        const double half = cell.half / 2;
        for (const double dx : {-half, half})
            for (const double dy : {-half, half})
                add(cell.centre + Point(dx, dy), half, cell.disc, cell.most);
    }

    void add(const Point& centre, double half, std::size_t disc, double most) {
        const lod::Sphere<2>& d = discs_[disc];
        const double corner = half * std::sqrt(2.0);
        const Point arm = centre - d.centre;
        const double off = arm.norm();
        if (off - corner > d.radius) return;
        most = std::min(most, off + corner - depth_[disc]);
        if (most <= found_.least) return;
        // Projecting on the disc moves no point of the disc away from the cell's centre.
        const Point probe = off <= d.radius ? centre : Point(d.centre + (d.radius / off) * arm);
        most = std::min(most, distance_at(probe) + corner);
        if (most > found_.least) cells_.push({most, centre, half, disc});
    }

    double distance_at(const Point& p) {
        ++queries_;
        const double distance = shape_.distance(p);
        if (distance > found_.least) {
            found_.least = distance;
            found_.at = p;
        }
        return distance;
    }

    const BoundaryIndex& shape_;
    std::span<const lod::Sphere<2>> discs_;
    std::vector<double> depth_;  ///< of each centre in the shape, negative outside
    std::priority_queue<Cell> cells_;
    Protrusion found_;
    int queries_ = 0;
};

}  // namespace

double protrusion_bound(const BoundaryIndex& shape, const lod::Sphere<2>& disc) {
    return std::max(0.0, disc.radius + shape.signed_distance(disc.centre));
}

Protrusion find_protrusion(const BoundaryIndex& shape, std::span<const lod::Sphere<2>> discs,
                           double tolerance, int most_queries) {
    return Search(shape, discs).run(tolerance, most_queries);
}

}  // namespace lod2d
