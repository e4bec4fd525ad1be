#include "lodlab/lod2d/shape/disc_union.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lodlab/core/math/box_tree.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

using Disc = lod::Sphere<2>;

struct Interval {
    double from;
    double to;
};

/// Adds the angles of `own` that the other disc covers, within [0, lod::full_turn]; true if that is
/// all.
bool cover(const Disc& own, const Disc& other, bool other_first, std::vector<Interval>& covered) {
    const Point line = other.centre - own.centre;
    const double d = line.norm();
    const bool equal = d == 0 && own.radius == other.radius;
    if (equal ? other_first : d + own.radius <= other.radius) return true;
    if (equal || d + other.radius <= own.radius || d >= own.radius + other.radius) return false;
    const double cosine =
        (own.radius * own.radius + d * d - other.radius * other.radius) / (2 * own.radius * d);
    const double half = lod::angle_of_cosine(std::clamp(cosine, -1.0, 1.0));
    double from = lod::direction_angle(line.y(), line.x()) - half;
    if (from < 0) from += lod::full_turn;
    const double to = from + 2 * half;
    covered.push_back({from, std::min(to, lod::full_turn)});
    if (to > lod::full_turn) covered.push_back({0, to - lod::full_turn});
    return false;
}

void add_gaps(std::size_t disc, std::vector<Interval>& covered, std::vector<Arc>& arcs) {
    std::sort(covered.begin(), covered.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    double reached = 0;
    for (const Interval& interval : covered) {
        if (interval.from > reached) arcs.push_back({disc, reached, interval.from});
        reached = std::max(reached, interval.to);
    }
    if (reached < lod::full_turn) arcs.push_back({disc, reached, lod::full_turn});
}

}  // namespace

Point Arc::at(const Disc& of, double angle) const {
    const lod::SineCosine turned = lod::sine_cosine(angle);
    return of.centre + of.radius * Point(turned.cosine, turned.sine);
}

std::vector<Arc> exposed_arcs(std::span<const Disc> discs) {
    const std::vector<lod::Box<2>> boxes = lod::boxes_of<2>(discs);
    lod::BoxTree<2> tree(boxes);
    std::vector<Arc> arcs;
    std::vector<Interval> covered;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        if (discs[i].radius <= 0) continue;
        covered.clear();
        bool hidden = false;
        tree.each_meeting(boxes[i], [&](std::size_t j) {
            if (j != i && !hidden) hidden = cover(discs[i], discs[j], j < i, covered);
        });
        if (!hidden) add_gaps(i, covered, arcs);
    }
    return arcs;
}

double union_area(std::span<const Disc> discs, std::span<const Arc> arcs) {
    double twice = 0;
    for (const Arc& arc : arcs) {
        const Disc& disc = discs[arc.disc];
        const Point across = arc.at(disc, arc.to) - arc.at(disc, arc.from);
        twice += disc.radius * disc.radius * (arc.to - arc.from) + disc.centre.x() * across.y() -
                 disc.centre.y() * across.x();
    }
    return twice / 2;
}

}  // namespace lod2d
