#pragma once

#include <vector>

#include "lodlab/viz/paint/canvas/clip.hpp"

namespace viz {

/// Words that want a place beside their anchor. Page units.
struct LabelRequest {
    Point anchor;
    double clearance = 0;  ///< radius round the anchor that must stay free
    Extent extent;
    Point away{0, 0};  ///< preferred side, as a direction; none when zero
};

/// What labels should not cover.
struct Obstacles {
    struct Segment {
        Point p;
        Point q;
        double cost = 1;  ///< per unit of length covered
    };
    std::vector<Rect> boxes;        ///< dots and other words: never, if there is any other place
    std::vector<Segment> segments;  ///< arrows, outlines
    std::vector<Ring> areas;        ///< bodies: rather not
};

struct PlacedLabel {
    Rect box;
    bool leader = false;  ///< a thin line joins words and anchor, as they stand apart
    Point leader_from;    ///< on the box
    Point leader_to;      ///< on the rim of the clearance
};

/// Chooses for each label, in order, the place round its anchor (16 directions, growing distances,
/// then anywhere within the bounds) that covers least. Labels never overlap one another while the
/// bounds have room for them.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                                    const Obstacles& obstacles, const Rect& bounds);

[[nodiscard]] double overlap_area(const Rect& a, const Rect& b);

/// Whether words are the names of many curves that end at the right side of a plot, where they
/// would push each other about.
[[nodiscard]] bool end_in_column(const std::vector<LabelRequest>& requests, double right);
inline constexpr std::size_t fewest_in_column = 3;
inline constexpr double column_room = 14;  ///< from that side to the names

/// Words beside a list of points that lie one above the other, as ends of curves do: all of them
/// right of `x`, in the order of their anchors, each as near to its own as the others leave room;
/// with a leader line where that is not beside it.
[[nodiscard]] std::vector<PlacedLabel> place_in_column(const std::vector<LabelRequest>& requests,
                                                       double x, const Rect& bounds);

}  // namespace viz
