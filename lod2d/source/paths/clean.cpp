#include "lodlab/lod2d/source/paths/clean.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>
#include <unordered_map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/source/paths/clean_work.hpp"

namespace lod2d {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double largest_coordinate = 1e60;
constexpr int grid_bits = 29;  // Clipper multiplies in 64 bits up to 2^30

[[noreturn]] void refuse(lod::ErrorKind kind, const std::string& name, const std::string& why) {
    throw lod::Error(kind, "cannot use the outline of '" + name + "': " + why);
}

void check_points(const std::string& name, std::span<const Outline> outlines,
                  const CleanSettings& settings) {
    std::size_t points = 0;
    for (const Outline& outline : outlines)
        for (const Ring& ring : outline.rings) {
            points += ring.size();
            for (std::size_t i = 0; i < ring.size(); ++i)
                if (!ring[i].allFinite() || ring[i].cwiseAbs().maxCoeff() > largest_coordinate)
                    refuse(lod::ErrorKind::input_refused, name,
                           "point " + std::to_string(i + 1) +
                               " has a coordinate that is not finite or beyond 1e60; check the "
                               "numbers");
        }
    if (points > settings.most_points)
        refuse(lod::ErrorKind::limit_exceeded, name,
               "it has " + std::to_string(points) + " points, the limit is " +
                   std::to_string(settings.most_points) + "; simplify it or raise the limit");
    if (points < 3)
        refuse(lod::ErrorKind::input_refused, name,
               points == 0 ? "it is empty; give at least one closed outline"
                           : "it has " + std::to_string(points) +
                                 " points; a closed outline needs at least 3");
}

/// Integer coordinates whose step is a power of two, so that going back to metres is exact. The
/// axes may be swapped, where the sweep (along the grid's Y) is shorter that way.
struct Grid {
    Point origin = Point::Zero();
    double step = 1;
    bool swapped = false;

    [[nodiscard]] IntPoint to_grid(const Point& p) const {
        const Point q = (p - origin) / step;
        const auto x = static_cast<ClipperLib::cInt>(std::llround(q.x()));
        const auto y = static_cast<ClipperLib::cInt>(std::llround(q.y()));
        return swapped ? IntPoint(y, x) : IntPoint(x, y);
    }
    [[nodiscard]] Point from_grid(const IntPoint& q) const {
        const double x = static_cast<double>(swapped ? q.Y : q.X);
        const double y = static_cast<double>(swapped ? q.X : q.Y);
        return origin + step * Point(x, y);
    }
};

Grid make_grid(const Box& box) {
    Grid grid;
    const double half_extent = box.size().maxCoeff() / 2;
    int exponent = 0;
    std::frexp(half_extent, &exponent);
    grid.step = std::ldexp(1.0, exponent - grid_bits);
    grid.origin = grid.step * (box.centre() / grid.step).cwiseRound();
    return grid;
}

/// Refuses what would take too long, and picks the axis of the shorter sweep.
void check_work(const std::string& name, const Polygon& all, const CleanSettings& settings,
                Grid& grid) {
    const std::uint64_t along_x = count_sweep_steps(all, 0);
    const std::uint64_t along_y = count_sweep_steps(all, 1);
    grid.swapped = along_x < along_y;
    const auto check = [&](std::uint64_t count, std::uint64_t most, const char* what) {
        if (count > most)
            refuse(lod::ErrorKind::limit_exceeded, name,
                   std::string("it is too intricate: more than ") + std::to_string(most) + " " +
                       what + "; simplify it or raise the limit");
    };
    check(std::min(along_x, along_y), settings.most_sweep_steps, "edges to sweep over");
    check(count_edge_pairs(all, settings.most_edge_pairs), settings.most_edge_pairs,
          "pairs of edges that may cross");
    check(count_crossings(all, settings.most_crossings), settings.most_crossings,
          "crossings of its lines");
}

Paths unite(const std::string& name, const Paths& paths, ClipperLib::PolyFillType rule) {
    ClipperLib::Clipper clipper;
    Paths result;
    if (!clipper.AddPaths(paths, ClipperLib::ptSubject, true)) return result;  // no area at all
    if (!clipper.Execute(ClipperLib::ctUnion, result, rule, rule))
        refuse(lod::ErrorKind::input_refused, name, "the union of its regions failed; simplify it");
    return result;
}

std::uint64_t key_of(const IntPoint& p) {
    return static_cast<std::uint64_t>(p.X) << 32 ^ static_cast<std::uint32_t>(p.Y);
}

/// Cuts a ring that passes a point more than once into rings that do not.
void split_at_repeated_points(const Path& path, Paths& result) {
    Path open;
    std::unordered_map<std::uint64_t, std::size_t> place;
    for (const IntPoint& p : path) {
        const auto known = place.find(key_of(p));
        if (known != place.end()) {
            const auto loop = open.begin() + static_cast<std::ptrdiff_t>(known->second);
            result.emplace_back(loop, open.end());
            for (auto it = loop + 1; it != open.end(); ++it) place.erase(key_of(*it));
            open.erase(loop + 1, open.end());
        } else {
            place.emplace(key_of(p), open.size());
            open.push_back(p);
        }
    }
    result.push_back(std::move(open));
}

/// Three points in line keep their outer two. Exact: differences have at most 31 bits.
Path without_straight_points(const Path& path) {
    const auto straight = [](const IntPoint& a, const IntPoint& b, const IntPoint& c) {
        return (b.X - a.X) * (c.Y - b.Y) == (b.Y - a.Y) * (c.X - b.X);
    };
    Path kept;
    for (const IntPoint& p : path) {
        while (kept.size() >= 2 && straight(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
        if (kept.empty() || kept.back() != p) kept.push_back(p);
    }
    std::size_t first = 0;
    for (bool changed = true; changed && kept.size() >= first + 3;) {
        changed = straight(kept[kept.size() - 2], kept.back(), kept[first]);
        if (changed) {
            kept.pop_back();
        } else if (straight(kept.back(), kept[first], kept[first + 1])) {
            ++first;
            changed = true;
        }
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
    return kept;
}

Paths simple_loops(const Paths& united, double least_area) {
    Paths loops;
    for (const Path& path : united) split_at_repeated_points(path, loops);
    for (Path& loop : loops) loop = without_straight_points(loop);
    std::erase_if(loops, [&](const Path& loop) {
        return loop.size() < 3 || std::abs(ClipperLib::Area(loop)) < least_area;
    });
    return loops;
}

Polygon in_grid_steps(const Paths& paths) {
    Polygon polygon;
    for (const Path& path : paths) {
        Ring& ring = polygon.rings.emplace_back();
        for (const IntPoint& p : path)
            ring.emplace_back(static_cast<double>(p.X), static_cast<double>(p.Y));
    }
    return polygon;
}

/// Bends every edge through the points that it passes within a step, as snap rounding does, so
/// that the next union meets them exactly.
Paths bent_through_near_points(const Paths& paths) {
    const Polygon polygon = in_grid_steps(paths);
    const BoundaryIndex index(polygon);
    std::vector<std::vector<Point>> on_edge;  // by edge number
    for (const Ring& ring : polygon.rings)
        for (const Point& p : ring)
            visit_edges_near(index, p, 1.0, [&](std::int32_t edge) {
                if (p == index.edge_start(edge) || p == index.edge_end(edge)) return;
                const auto e = static_cast<std::size_t>(edge);
                if (on_edge.size() <= e) on_edge.resize(e + 1);
                on_edge[e].push_back(p);
            });
    Paths bent;
    for (std::int32_t start : index.ring_starts()) {
        Path& path = bent.emplace_back();
        const std::size_t edges = polygon.rings[bent.size() - 1].size();
        for (auto e = static_cast<std::size_t>(start); e < static_cast<std::size_t>(start) + edges;
             ++e) {
            const Point& from = index.edge_start(static_cast<std::int32_t>(e));
            path.emplace_back(std::llround(from.x()), std::llround(from.y()));
            if (e >= on_edge.size()) continue;
            std::ranges::sort(on_edge[e], {},
                              [&](const Point& p) { return (p - from).squaredNorm(); });
            for (const Point& p : on_edge[e])
                path.emplace_back(std::llround(p.x()), std::llround(p.y()));
        }
    }
    return bent;
}

/// Points on every so many grid lines.
Paths on_coarse_grid(Paths paths, ClipperLib::cInt lines) {
    const auto rounded = [lines](ClipperLib::cInt x) {
        const ClipperLib::cInt up = x + lines / 2;
        return up - (up % lines + lines) % lines;
    };
    for (Path& path : paths)
        for (IntPoint& p : path) p = {rounded(p.X), rounded(p.Y)};
    return paths;
}

/// A union rounds its crossings to the grid, by which edges may come to cross anew within a step:
/// such edges are bent and united again until none cross. Where that does not end, because edges
/// run side by side within a few steps, the points are first put on coarser grids, one after
/// another.
Paths settle(const std::string& name, Paths united, double least_area) {
    constexpr int most_rounds = 30;
    for (const ClipperLib::cInt lines : {1, 16, 128, 1024}) {
        if (lines > 1) united = unite(name, on_coarse_grid(united, lines), ClipperLib::pftNonZero);
        for (int round = 0; round < most_rounds; ++round) {
            Paths simple = simple_loops(united, least_area);
            if (!crosses_itself(in_grid_steps(simple))) return simple;
            united = unite(name, bent_through_near_points(simple), ClipperLib::pftNonZero);
        }
    }
    refuse(lod::ErrorKind::input_refused, name,
           "its crossings lie too close together; simplify it");
}

Polygon from_grid(const Paths& paths, const Grid& grid) {
    Polygon polygon;
    for (const Path& path : paths) {
        Ring& ring = polygon.rings.emplace_back();
        for (const IntPoint& p : path) ring.push_back(grid.from_grid(p));
        if (grid.swapped) std::ranges::reverse(ring);
    }
    return polygon;
}

}  // namespace

Polygon clean(const std::string& name, std::span<const Outline> outlines,
              const CleanSettings& settings) {
    check_points(name, outlines, settings);
    Polygon all;
    for (const Outline& outline : outlines)
        for (const Ring& ring : outline.rings)
            if (ring.size() >= 3) all.rings.push_back(ring);
    const Box box = bounds(all);
    const double extent = all.rings.empty() ? 0 : box.size().maxCoeff();
    if (extent < 1 / largest_coordinate)
        refuse(lod::ErrorKind::input_refused, name,
               "all its points are in one place; give an outline that encloses something");
    Grid grid = make_grid(box);
    check_work(name, all, settings, grid);

    Paths united;
    for (const Outline& outline : outlines) {
        Paths paths;
        for (const Ring& ring : outline.rings) {
            paths.emplace_back();
            for (const Point& p : ring) paths.back().push_back(grid.to_grid(p));
        }
        const bool nonzero = outline.rule == FillRule::nonzero;
        const Paths filled =
            unite(name, paths, nonzero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd);
        united.insert(united.end(), filled.begin(), filled.end());
        lod::check_interrupted();
    }
    if (outlines.size() > 1) united = unite(name, united, ClipperLib::pftNonZero);

    const double smallest = settings.smallest_part * extent / grid.step;
    const Paths simple = settle(name, std::move(united), smallest * smallest);
    Polygon polygon = from_grid(simple, grid);
    if (polygon.rings.empty())
        refuse(lod::ErrorKind::input_refused, name,
               "its area is zero; give a closed outline that encloses something");
    return polygon;
}

Polygon clean(const std::string& name, const Outline& outline, const CleanSettings& settings) {
    return clean(name, std::span(&outline, 1), settings);
}

}  // namespace lod2d
