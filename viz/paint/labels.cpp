#include "lodlab/viz/paint/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace viz {
namespace {

constexpr double gap = 7;           ///< between the words and what they name
constexpr double apart = 4;         ///< between two labels
constexpr double leader_from = 26;  ///< a label further away gets a leader line
constexpr int directions = 16;
constexpr std::array<double, 7> distances{0, 12, 28, 48, 76, 116, 170};
// Costs: each class outweighs all that a picture can hold of the class below.
constexpr double cost_of_label = 1e7;
constexpr double cost_of_border = 1e6;
constexpr double cost_of_anchor = 1e5;
constexpr double cost_of_box = 1e4;
constexpr double cost_of_area = 60;

bool inside(const Ring& ring, Point p) {
    bool odd = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point a = ring[i];
        const Point b = ring[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            odd = !odd;
    }
    return odd;
}

Point nearest(const Rect& box, Point p) {
    return {std::clamp(p.x, box.x, box.right()), std::clamp(p.y, box.y, box.bottom())};
}

Point middle(const Rect& box) {
    return {box.x + box.width / 2, box.y + box.height / 2};
}

/// Cost of a place, without the other labels: that of what it covers and how far it lies.
double cost_of_place(const Rect& box, const LabelRequest& request, const Obstacles& obstacles,
                     const Rect& bounds) {
    const double area = box.width * box.height;
    double cost = cost_of_border * (1 - overlap_area(box, bounds) / area);
    const Point near = nearest(box, request.anchor);
    const double distance = std::hypot(near.x - request.anchor.x, near.y - request.anchor.y);
    const double free = request.clearance + gap;
    if (distance < free * 0.99) cost += cost_of_anchor * (1 + (free - distance) / free);
    cost += 1.5 * std::max(0.0, distance - free);
    for (const Rect& solid : obstacles.boxes)
        cost += cost_of_box * overlap_area(box, solid) /
                std::max(1.0, std::min(area, solid.width * solid.height));
    const Rect wider = grown(box, 2);
    for (const Obstacles::Segment& segment : obstacles.segments) {
        double from = 0;
        double until = 1;
        if (!clip_segment(segment.p, segment.q, wider, from, until)) continue;
        cost += segment.cost * (until - from) *
                std::hypot(segment.q.x - segment.p.x, segment.q.y - segment.p.y);
    }
    const std::array<Point, 5> probes{middle(box),
                                      Point{box.x, box.y},
                                      {box.right(), box.y},
                                      {box.x, box.bottom()},
                                      {box.right(), box.bottom()}};
    for (const Ring& ring : obstacles.areas)
        for (const Point& probe : probes)
            if (inside(ring, probe)) cost += cost_of_area / 5;
    return cost;
}

double cost_of_others(const Rect& box, const std::vector<PlacedLabel>& placed) {
    double cost = 0;
    for (const PlacedLabel& other : placed) {
        const double common = overlap_area(grown(box, apart), other.box);
        if (common > 0) cost += cost_of_label * (1 + common);
    }
    return cost;
}

/// The candidates: round the anchor, nearer ones first.
std::vector<Rect> candidates(const LabelRequest& request, const Rect& bounds) {
    std::vector<Rect> boxes;
    const auto [width, height] = request.extent;
    for (const double distance : distances) {
        const double reach = request.clearance + gap + distance;
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            const double dx = std::cos(angle);
            const double dy = -std::sin(angle);
            boxes.push_back({request.anchor.x + dx * (reach + width / 2) - width / 2,
                             request.anchor.y + dy * (reach + height / 2) - height / 2, width,
                             height});
        }
    }
    constexpr int rows = 24;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= rows; ++column)
            boxes.push_back({bounds.x + std::max(0.0, bounds.width - width) * column / rows,
                             bounds.y + std::max(0.0, bounds.height - height) * row / rows, width,
                             height});
    return boxes;
}

/// A mild wish: to the right before the left, above before below, and away from what is named.
double taste(const Rect& box, const LabelRequest& request) {
    const Point to{middle(box).x - request.anchor.x, middle(box).y - request.anchor.y};
    const double length = std::max(1e-9, std::hypot(to.x, to.y));
    double cost = 2 - to.x / length + 0.5 * to.y / length;
    if (request.away.x != 0 || request.away.y != 0)
        cost += 12 * (1 - (to.x * request.away.x + to.y * request.away.y) / length);
    return cost;
}

PlacedLabel with_leader(const Rect& box, const LabelRequest& request) {
    PlacedLabel label{box, false, nearest(box, request.anchor), request.anchor};
    const double dx = label.leader_from.x - request.anchor.x;
    const double dy = label.leader_from.y - request.anchor.y;
    const double distance = std::hypot(dx, dy);
    label.leader = distance - request.clearance > leader_from;
    if (distance > 0) {
        const double rim = (request.clearance + 2) / distance;
        label.leader_to = {request.anchor.x + rim * dx, request.anchor.y + rim * dy};
    }
    return label;
}

}  // namespace

double overlap_area(const Rect& a, const Rect& b) {
    const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
    const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
    return width > 0 && height > 0 ? width * height : 0;
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const Obstacles& obstacles, const Rect& bounds) {
    Obstacles all = obstacles;
    for (const LabelRequest& request : requests)  // the anchors of the others are to be seen too
        all.boxes.push_back({request.anchor.x - 3, request.anchor.y - 3, 6, 6});
    std::vector<PlacedLabel> placed;
    for (const LabelRequest& request : requests) {
        double least = std::numeric_limits<double>::infinity();
        Rect best;
        for (const Rect& box : candidates(request, bounds)) {
            double cost = taste(box, request) + cost_of_others(box, placed);
            if (cost >= least) continue;
            cost += cost_of_place(box, request, all, bounds);
            if (cost >= least) continue;
            least = cost;
            best = box;
        }
        placed.push_back(with_leader(best, request));
    }
    return placed;
}

}  // namespace viz
