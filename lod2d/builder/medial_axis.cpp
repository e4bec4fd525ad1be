#include "lodlab/lod2d/builder/medial_axis.hpp"

#include <algorithm>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/shape/orientation.hpp"

namespace lod2d {
namespace {

namespace bp = boost::polygon;
using GridPoint = bp::point_data<int>;
using GridSegment = bp::segment_data<int>;
using Diagram = bp::voronoi_diagram<double>;

constexpr double grid_extent = 0x1p28;

Point as_point(const GridPoint& p) {
    return {double(p.x()), double(p.y())};
}

/// Whether two segments share more than an end that is an end of both.
bool cross(const GridSegment& a, const GridSegment& b) {
    const Point a0 = as_point(a.low()), a1 = as_point(a.high());
    const Point b0 = as_point(b.low()), b1 = as_point(b.high());
    if (!segments_meet(a0, a1, b0, b1)) return false;
    const bool joined = a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1;
    if (!joined) return true;
    const Point shared = a0 == b0 || a0 == b1 ? a0 : a1;
    const Point a_end = shared == a0 ? a1 : a0;
    const Point b_end = shared == b0 ? b1 : b0;
    return on_segment(a0, a1, b_end) || on_segment(b0, b1, a_end);
}

/// The segments without those of no length and those that cross an earlier one.
std::vector<std::size_t> sound_segments(const std::vector<GridSegment>& segments) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (segments[i].low() != segments[i].high()) order.push_back(i);
    const auto left = [&](std::size_t i) {
        return std::min(segments[i].low().x(), segments[i].high().x());
    };
    const auto right = [&](std::size_t i) {
        return std::max(segments[i].low().x(), segments[i].high().x());
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
    std::vector<char> sound(segments.size(), 0);
    std::vector<std::size_t> active;
    for (const std::size_t i : order) {
        std::erase_if(active, [&](std::size_t j) { return right(j) < left(i); });
        sound[i] = std::none_of(active.begin(), active.end(),
                                [&](std::size_t j) { return cross(segments[i], segments[j]); });
        if (sound[i]) active.push_back(i);
    }
    std::erase_if(order, [&](std::size_t i) { return !sound[i]; });
    std::sort(order.begin(), order.end());
    return order;
}

}  // namespace

/// Reads the Voronoi diagram into spans and corner discs.
class MedialAxis::Reading {
  public:
    Reading(MedialAxis& axis, const Polygon& polygon) : axis_(axis) {
        double extent = 0;
        for (const Ring& ring : polygon.rings) {
            const auto first = static_cast<std::int32_t>(axis.edges_.size());
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point& from = ring[i];
                const Point& to = ring[i + 1 == ring.size() ? 0 : i + 1];
                const Point along = (to - from).stableNormalized();
                axis.edges_.push_back({from, to, Point(-along.y(), along.x())});
                next_.push_back(static_cast<std::int32_t>(axis.edges_.size()));
                extent = std::max(extent, from.cwiseAbs().maxCoeff());
            }
            if (!ring.empty()) next_.back() = first;
        }
        scale_ = extent > 0 ? grid_extent / extent : 1;
        axis.spans_.resize(axis.edges_.size());
        axis.at_corner_.resize(axis.edges_.size());
    }

    void run() {
        std::vector<GridSegment> all;
        for (const Edge& edge : axis_.edges_)
            all.emplace_back(on_grid(edge.from), on_grid(edge.to));
        std::vector<GridSegment> segments;
        for (const std::size_t i : sound_segments(all)) {
            segments.push_back(all[i]);
            number_.push_back(static_cast<std::int32_t>(i));
        }
        Diagram diagram;
        bp::construct_voronoi(segments.begin(), segments.end(), &diagram);
        lod::check_interrupted();
        for (const auto& edge : diagram.edges())
            if (edge.is_primary() && edge.is_finite()) read(edge);
        for (auto& spans : axis_.spans_)
            std::sort(spans.begin(), spans.end(),
                      [](const Span& a, const Span& b) { return a.begin < b.begin; });
    }

  private:
    [[nodiscard]] GridPoint on_grid(const Point& p) const {
        return {static_cast<int>(std::lround(p.x() * scale_)),
                static_cast<int>(std::lround(p.y() * scale_))};
    }
    [[nodiscard]] Point off_grid(const Diagram::vertex_type& v) const {
        return Point(v.x(), v.y()) / scale_;
    }

    /// The edge of the polygon that starts at the cell's point.
    [[nodiscard]] std::int32_t corner_of(const Diagram::cell_type& cell) const {
        const std::int32_t edge = number_[cell.source_index()];
        const bool at_start = cell.source_category() == bp::SOURCE_CATEGORY_SEGMENT_START_POINT;
        return at_start ? edge : next_[static_cast<std::size_t>(edge)];
    }

    void read(const Diagram::edge_type& edge) {
        const Diagram::cell_type& own = *edge.cell();
        const Diagram::cell_type& other = *edge.twin()->cell();
        const Point first = off_grid(*edge.vertex0());
        const Point second = off_grid(*edge.vertex1());
        if (own.contains_segment()) {
            add_span(number_[own.source_index()], other, first, second);
        } else {
            add_corner_discs(corner_of(own), first, second);
        }
    }

    void add_span(std::int32_t number, const Diagram::cell_type& other, const Point& first,
                  const Point& second) {
        const Edge& edge = axis_.edges_[static_cast<std::size_t>(number)];
        if (((first + second) / 2 - edge.from).dot(edge.inward) <= 0) return;
        const Point along = edge.to - edge.from;
        const auto place = [&](const Point& p) {
            return std::clamp((p - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        };
        Span span{place(first), place(second), -1, Point(0, 0)};
        if (span.begin > span.end) std::swap(span.begin, span.end);
        if (other.contains_segment())
            span.other_edge = number_[other.source_index()];
        else
            span.point = axis_.edges_[static_cast<std::size_t>(corner_of(other))].from;
        axis_.spans_[static_cast<std::size_t>(number)].push_back(span);
    }

    void add_corner_discs(std::int32_t corner, const Point& first, const Point& second) {
        const Edge& after = axis_.edges_[static_cast<std::size_t>(corner)];
        auto& discs = axis_.at_corner_[static_cast<std::size_t>(corner)];
        for (const Point& centre : {first, Point((first + second) / 2)}) {
            const Point arm = centre - after.from;
            // The fan of inward directions at a reflex corner: the edge after lies behind.
            if (arm.dot(after.to - after.from) <=
                1e-9 * arm.norm() * (after.to - after.from).norm())
                discs.push_back({centre, arm.norm()});
        }
    }

    MedialAxis& axis_;
    double scale_ = 1;
    std::vector<std::int32_t> next_;    ///< the edge after each edge of the polygon
    std::vector<std::int32_t> number_;  ///< of each segment in the diagram
};

MedialAxis::MedialAxis(const Polygon& polygon) {
    Reading(*this, polygon).run();
}

std::optional<lod::Sphere<2>> MedialAxis::touching(std::int32_t edge, double t) const {
    const Edge& own = edges_[static_cast<std::size_t>(edge)];
    const auto& spans = spans_[static_cast<std::size_t>(edge)];
    auto span = std::upper_bound(spans.begin(), spans.end(), t,
                                 [](double at, const Span& s) { return at < s.begin; });
    if (span == spans.begin()) return std::nullopt;
    --span;
    while (span->end < t && span != spans.begin() && (span - 1)->end > span->end)
        --span;                    // past spans that rounding has left without length
    constexpr double hair = 1e-6;  // the grid's rounding, as a share of a short edge
    if (t > span->end + hair) return std::nullopt;

    const Point p = own.from + t * (own.to - own.from);
    double radius = 0;
    if (span->other_edge >= 0) {  // equally far from the lines of both edges
        const Edge& other = edges_[static_cast<std::size_t>(span->other_edge)];
        radius = (p - other.from).dot(other.inward) / (1 - own.inward.dot(other.inward));
    } else {  // as far from the point as from p
        const Point arm = span->point - p;
        radius = arm.squaredNorm() / (2 * arm.dot(own.inward));
    }
    if (!std::isfinite(radius) || radius <= 0) return std::nullopt;
    return lod::Sphere<2>{p + radius * own.inward, radius};
}

std::string_view medial_axis_release() {
    return BOOST_LIB_VERSION;
}

}  // namespace lod2d
