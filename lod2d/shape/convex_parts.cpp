#include "lodlab/lod2d/shape/convex_parts.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "lodlab/core/base/stop.hpp"

namespace lod2d {
namespace {

/// Not vertical, from left to right.
struct Edge {
    Point left;
    Point right;

    [[nodiscard]] double height(double x) const {
        if (x <= left.x()) return left.y();
        if (x >= right.x()) return right.y();
        return left.y() + (x - left.x()) / (right.x() - left.x()) * (right.y() - left.y());
    }
};

/// A convex part whose right end is still open.
struct OpenPart {
    std::size_t lower = 0;  ///< the edges that bound it now
    std::size_t upper = 0;
    std::vector<Point> below{};  ///< its lower and its upper border so far
    std::vector<Point> above{};
};

double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
}

std::vector<Edge> sloping_edges(const Polygon& polygon) {
    std::vector<Edge> edges;
    for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& p = ring[i];
            const Point& q = ring[i + 1 == ring.size() ? 0 : i + 1];
            if (p.x() < q.x()) edges.push_back({p, q});
            if (q.x() < p.x()) edges.push_back({q, p});
        }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return e.left.x() < f.left.x(); });
    return edges;
}

class Sweep {
  public:
    explicit Sweep(const Polygon& polygon) : edges_(sloping_edges(polygon)) {
        for (const Edge& edge : edges_) {
            stops_.push_back(edge.left.x());
            stops_.push_back(edge.right.x());
        }
        std::sort(stops_.begin(), stops_.end());
        stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
    }

    ConvexParts run() {
        for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
            if (i % 1024 == 0) lod::check_interrupted();
            order_edges(stops_[i], stops_[i + 1]);
            step(stops_[i]);
        }
        active_.clear();
        if (!stops_.empty()) step(stops_.back());
        for (OpenPart& part : ended_) finish(part);
        return std::move(parts_);
    }

  private:
    /// The edges over the strip from x to next, from the lowest to the highest.
    void order_edges(double x, double next) {
        std::erase_if(active_, [&](std::size_t e) { return edges_[e].right.x() <= x; });
        while (next_edge_ < edges_.size() && edges_[next_edge_].left.x() <= x)
            active_.push_back(next_edge_++);
        const double middle = x + (next - x) / 2;
        const auto height = [&](std::size_t e) { return edges_[e].height(middle); };
        for (std::size_t i = 1; i < active_.size(); ++i)  // nearly sorted already
            for (std::size_t j = i; j > 0 && height(active_[j]) < height(active_[j - 1]); --j)
                std::swap(active_[j], active_[j - 1]);
    }

    /// Ends the parts whose pair of edges is no more, begins those of new pairs.
    void step(double x) {
        std::map<std::size_t, std::size_t> pairs;  // lower edge to upper edge
        for (std::size_t i = 0; i + 1 < active_.size(); i += 2) pairs[active_[i]] = active_[i + 1];
        std::vector<OpenPart> ending;
        for (auto it = open_.begin(); it != open_.end();) {
            const auto pair = pairs.find(it->first);
            if (pair != pairs.end() && pair->second == it->second.upper) {
                pairs.erase(pair);
                ++it;
            } else {
                ending.push_back(std::move(it->second));
                it = open_.erase(it);
            }
        }
        for (OpenPart& part : ended_) finish(part);
        ended_.clear();
        for (OpenPart& part : ending) {
            extend(part, x);
            ended_.push_back(std::move(part));
        }
        for (const auto& [lower, upper] : pairs) begin(lower, upper, x);
    }

    void begin(std::size_t lower, std::size_t upper, double x) {
        const Point low(x, edges_[lower].height(x));
        const Point high(x, edges_[upper].height(x));
        // An edge that goes on bends nowhere; where the edge is another, the turn must be outward.
        const auto joins = [&](const OpenPart& part) {
            return part.below.back() == low && part.above.back() == high && low != high &&
                   (part.lower == lower ||
                    turn(part.below[part.below.size() - 2], low, edges_[lower].right) >= 0) &&
                   (part.upper == upper ||
                    turn(part.above[part.above.size() - 2], high, edges_[upper].right) <= 0);
        };
        const auto joined = std::find_if(ended_.begin(), ended_.end(), joins);
        OpenPart part;
        if (joined != ended_.end()) {
            part = std::move(*joined);
            ended_.erase(joined);
            if (part.lower == lower) part.below.pop_back();
            if (part.upper == upper) part.above.pop_back();
        } else {
            part.below = {low};
            part.above = {high};
        }
        part.lower = lower;
        part.upper = upper;
        open_[lower] = std::move(part);
    }

    void extend(OpenPart& part, double x) const {
        part.below.emplace_back(x, edges_[part.lower].height(x));
        part.above.emplace_back(x, edges_[part.upper].height(x));
    }

    void finish(const OpenPart& part) {
        std::vector<Point> ring = part.below;
        ring.insert(ring.end(), part.above.rbegin(), part.above.rend());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        if (ring.size() < 3) return;
        parts_.corners.insert(parts_.corners.end(), ring.begin(), ring.end());
        parts_.begin.push_back(static_cast<std::int32_t>(parts_.corners.size()));
    }

    std::vector<Edge> edges_;
    std::vector<double> stops_;
    std::size_t next_edge_ = 0;
    std::vector<std::size_t> active_;
    std::map<std::size_t, OpenPart> open_;  ///< by the lower edge
    std::vector<OpenPart> ended_;           ///< at the present abscissa; may be joined there
    ConvexParts parts_;
};

}  // namespace

ConvexParts convex_parts(const Polygon& polygon) {
    return Sweep(polygon).run();
}

namespace {

void add_halves(std::span<const Point> corners, std::size_t most, ConvexParts& result) {
    if (corners.size() <= most) {
        result.corners.insert(result.corners.end(), corners.begin(), corners.end());
        result.begin.push_back(static_cast<std::int32_t>(result.corners.size()));
        return;
    }
    // From the first corner to the one across: both keep at least 3.
    const std::size_t across = corners.size() / 2;
    add_halves(corners.first(across + 1), most, result);
    std::vector<Point> rest(corners.begin() + static_cast<std::ptrdiff_t>(across), corners.end());
    rest.push_back(corners.front());
    add_halves(rest, most, result);
}

}  // namespace

ConvexParts with_at_most(const ConvexParts& parts, std::size_t most) {
    ConvexParts result;
    for (std::size_t i = 0; i < parts.count(); ++i) add_halves(parts.part(i), most, result);
    return result;
}

}  // namespace lod2d
