#include "lodlab/viz/paint/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace viz {
namespace {

// Lengths in page units. Each number was halved and doubled, the others kept, for 1,248 words at
// the dots, arrows and bodies of 150 random pictures. As they are, 11 % of their area covers
// bodies, a word covers 1.55 units of outline, no dot and no arrow, and stands 13.2 units from what
// it names; "nothing" is less than a twentieth of these.

/// Between the words and what they name: half, words stand 10 units from it in the mean, and one
/// covers a dot; double, 19 instead of 13.
constexpr double gap = 7;
/// Between two words, less than a letter's width; 13.1 and 13.5 instead of 13.2 units from what
/// they name.
constexpr double apart = 4;
/// Words further away, four gaps, get a leader line: 24 % with half, 13 %, 2 % with double.
constexpr double leader_from = 26;
/// In which words are tried: 8 leave a word on a dot, 32 change nothing.
constexpr int directions = 16;
/// How far beyond the gap they are tried, each some half more than the one before: double, a word
/// stands on a dot.
constexpr std::array<double, 7> distances{0, 12, 28, 48, 76, 116, 170};
/// Places a side all over the picture, for where all round is full: 12 cover 1.8 instead of 1.55
/// units of outline a word, 48 cover 1.3 in three times the time.
constexpr int rows = 24;

// Costs: each class outweighs all that a picture can hold of the class below, so that their order
// alone counts: nothing, but a word on a dot with half of the box's.
constexpr double cost_of_label = 1e7;
constexpr double cost_of_border = 1e6;
constexpr double cost_of_anchor = 1e5;
constexpr double cost_of_box = 1e4;
/// Words wholly on a body, against a unit of distance: 11 % of what words cover are bodies, 16 %
/// with half, 3 % with double, which sends them 18 units away and gives 22 % of them a line.
constexpr double cost_of_area = 60;
constexpr double cost_of_distance = 1.5;  ///< half or double: as twice or half that of an area
/// Room about words that lines keep clear of: 1.56 and 1.44 units of outline a word.
constexpr double clear = 2;
/// How near to a plot's right side curves end whose names may stand in a column.
constexpr double column_reach = 30;
/// Between words in a column.
constexpr double column_gap = 1;
/// Half the side of the square about what another word names: nothing.
constexpr double anchor_half = 3;

// Where nothing is covered, words stand on their arrow's own side, else to the right, else above,
// as names do on maps (Imhof 1975).
constexpr double wish_right = 1;    ///< nothing
constexpr double wish_above = 0.5;  ///< nothing
constexpr double wish_side = 12;    ///< 10 % and 13 % on bodies

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
    cost += cost_of_distance * std::max(0.0, distance - free);
    for (const Rect& solid : obstacles.boxes)
        cost += cost_of_box * overlap_area(box, solid) /
                std::max(1.0, std::min(area, solid.width * solid.height));
    const Rect wider = grown(box, clear);
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
    double cost = 2 - wish_right * to.x / length + wish_above * to.y / length;
    if (request.away.x != 0 || request.away.y != 0)
        cost += wish_side * (1 - (to.x * request.away.x + to.y * request.away.y) / length);
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
        all.boxes.push_back(grown({request.anchor.x, request.anchor.y, 0, 0}, anchor_half));
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

bool end_in_column(const std::vector<LabelRequest>& requests, double right) {
    return requests.size() >= fewest_in_column &&
           std::all_of(requests.begin(), requests.end(), [&](const LabelRequest& request) {
               return request.anchor.x > right - column_reach;
           });
}

std::vector<PlacedLabel> place_in_column(const std::vector<LabelRequest>& requests, double x,
                                         const Rect& bounds) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return requests[i].anchor.y < requests[j].anchor.y;
    });
    // Runs of words that touch stand as a block, its middle at the mean of what they wish for.
    struct Block {
        double wish = 0;  ///< sum over its words of the top that it would have for that word
        double height = 0;
        std::size_t words = 0;
        [[nodiscard]] double top() const { return wish / static_cast<double>(words); }
    };
    std::vector<Block> blocks;
    for (const std::size_t i : order) {
        const double height = requests[i].extent.height + column_gap;
        blocks.push_back({requests[i].anchor.y - height / 2, height, 1});
        while (blocks.size() > 1) {
            Block& before = blocks[blocks.size() - 2];
            const Block& last = blocks.back();
            if (before.top() + before.height <= last.top()) break;
            before.wish += last.wish - static_cast<double>(last.words) * before.height;
            before.height += last.height;
            before.words += last.words;
            blocks.pop_back();
        }
    }
    std::vector<PlacedLabel> placed(requests.size());
    std::size_t next = 0;
    for (const Block& block : blocks) {
        double y =
            std::clamp(block.top(), bounds.y, std::max(bounds.y, bounds.bottom() - block.height));
        for (std::size_t k = 0; k < block.words; ++k) {
            const LabelRequest& request = requests[order[next]];
            const Rect box{x, y + column_gap / 2, request.extent.width, request.extent.height};
            placed[order[next++]] = {box, true, {x - 3, middle(box).y}, request.anchor};
            y += request.extent.height + column_gap;
        }
    }
    return placed;
}

}  // namespace viz
