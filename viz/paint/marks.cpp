#include "lodlab/viz/paint/marks.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/viz/figure/camera.hpp"
#include "lodlab/viz/paint/canvas/clip.hpp"
#include "lodlab/viz/paint/labels.hpp"

namespace viz {
namespace {

constexpr double beyond = 60;  ///< marks are cut so far outside the frame
constexpr double huge_radius = 8000;
constexpr double dot_radius = 5.5;
constexpr double narrow_panel = 450;  ///< smaller dots below
constexpr double halo = 2.5;
constexpr double head_length = 15;
constexpr double head_half_width = 6;
constexpr int fading_parts = 32;
constexpr double doubled_gap = 4.5;
constexpr std::size_t many_discs = 40;  ///< of one style side by side: thinner lines
constexpr double faint = 0.7;           ///< opacity of what lies behind a surface
constexpr int stretch_steps = 48;       ///< so many places of a line are looked at
constexpr double wide_panel = 800;      ///< larger words from here on

/// Draws one panel's marks and gathers its words and what they must not cover.
class Painter {
  public:
    Painter(const PanelPlace& place, bool plot, const PanelInk& ink, const Hidden& hidden,
            Canvas& canvas)
        : plot_(plot),
          label_size_(!plot && place.frame.width > wide_panel ? 1.25 * label_size : label_size),
          map_(place.mapping),
          frame_(place.frame),
          theme_(ink.theme),
          ground_(ink.ground),
          hidden_(hidden),
          canvas_(canvas),
          reach_(grown(place.frame, beyond)) {}

    void paint(const std::vector<Mark>& marks);
    void keep_words_off(const std::vector<Ring>& outlines);
    void paint_words(const Rect& bounds);

  private:
    struct Words {
        Text text;
        LabelRequest request;
    };

    void paint_discs(const std::vector<Mark>& marks, std::size_t first, std::size_t last);
    void paint_disc_line(const Canvas::Circle& disc, Pen pen, double opacity, bool among_many);
    void paint(const Disc&) {}  // drawn by paint_discs
    void paint(const Dot& dot);
    void paint(const Path& path);
    void paint(const Polyline& line);
    void paint(const Arrow& arrow);
    void paint(const Label& label);
    void paint_in_space(const std::vector<Point>& points, const Polyline& line, const Pen& pen);
    void paint_fading(const std::vector<Point>& points, const Pen& pen, double opacity,
                      double start);
    void add_words(const Style& style, const std::string& words, Point anchor, double clearance,
                   Point away);
    void add_outline(const Ring& ring, bool closed, double cost);
    [[nodiscard]] bool is_hidden(Point at, double depth) const {
        return hidden_ && hidden_(at, depth);
    }
    struct Stretch {
        std::vector<Point> points;
        bool hidden = false;
    };
    [[nodiscard]] std::vector<Stretch> stretches_of(const std::vector<Point>& points,
                                                    const std::vector<double>& depths) const;

    bool plot_;
    double label_size_;
    const Mapping& map_;
    Rect frame_;
    Theme theme_;
    Rgb ground_;
    const Hidden& hidden_;
    Canvas& canvas_;
    Rect reach_;
    std::vector<Words> words_;
    Obstacles obstacles_;
};

const Style& style_of(const Mark& mark) {
    return std::visit([](const auto& held) -> const Style& { return held.style; }, mark);
}

Rgb inside_of(const Pen& pen) {
    return pen.inside.value_or(pen.ink);
}

void Painter::paint(const std::vector<Mark>& marks) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (!std::holds_alternative<Disc>(marks[i])) {
            std::visit([this](const auto& mark) { paint(mark); }, marks[i]);
            continue;
        }
        std::size_t last = i + 1;  // neighbours of one style share one even tone
        while (last < marks.size() && std::holds_alternative<Disc>(marks[last]) &&
               same_pen(style_of(marks[i]), style_of(marks[last])))
            ++last;
        paint_discs(marks, i, last);
        i = last - 1;
    }
}

void Painter::paint_discs(const std::vector<Mark>& marks, std::size_t first, std::size_t last) {
    const Style& style = style_of(marks[first]);
    const Pen pen = viz::pen(theme_, style);
    std::vector<Canvas::Circle> discs;
    for (std::size_t i = first; i < last; ++i) {
        const Disc& disc = std::get<Disc>(marks[i]);
        const Canvas::Circle circle{map_(disc.centre), map_.length(disc.radius)};
        if (circle.radius > huge_radius) {
            const Ring part = clipped_disc(circle.centre, circle.radius, reach_);
            if (part.empty()) continue;
            canvas_.fill(std::vector<Ring>{part}, inside_of(pen), pen.fill * style.opacity);
            canvas_.stroke({part}, true, {pen.ink, pen.width, style.opacity, pen.dashed});
        } else if (contains(grown(reach_, circle.radius), circle.centre)) {
            discs.push_back(circle);
        }
    }
    if (pen.fill > 0) canvas_.fill(discs, inside_of(pen), pen.fill * style.opacity);
    for (const Canvas::Circle& disc : discs)
        paint_disc_line(disc, pen, style.opacity, discs.size() > many_discs);
}

void Painter::paint_disc_line(const Canvas::Circle& disc, Pen pen, double opacity,
                              bool among_many) {
    if (among_many) {
        pen.width *= 0.45;
        pen.doubled = false;
    }
    // A line never fills the disc that it surrounds.
    const double width = std::clamp(0.22 * disc.radius, std::min(0.8, pen.width), pen.width);
    canvas_.stroke(disc, {pen.ink, width, opacity, pen.dashed});
    if (pen.doubled && disc.radius > 2.5 * doubled_gap)
        canvas_.stroke(Canvas::Circle{disc.centre, disc.radius - doubled_gap},
                       {pen.ink, 1.25, opacity, false});
    constexpr int sides = 24;
    Ring rim;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979 * i / sides;
        rim.push_back({disc.centre.x + disc.radius * std::cos(angle),
                       disc.centre.y + disc.radius * std::sin(angle)});
    }
    add_outline(rim, true, pen.width >= 2 ? 0.8 : 0.3);
    if (pen.fill > 0 && !among_many) obstacles_.areas.push_back(rim);
}

void Painter::paint(const Dot& dot) {
    const Point at = map_(dot.at);
    if (!contains(reach_, at)) return;
    const Pen pen = viz::pen(theme_, dot.style);
    const double share =
        frame_.width < narrow_panel || frame_.height < 0.5 * narrow_panel ? 0.7 : 1;
    const double radius = share * dot_radius * dot.size;
    const double room = radius + halo * std::min(1.0, dot.size);
    const double opacity = dot.style.opacity * (is_hidden(at, dot.depth) ? faint : 1);
    canvas_.fill({{at, room}}, ground_, opacity);
    canvas_.fill({{at, radius}}, pen.ink, opacity);
    if (dot.style.role == Role::curve && pen.dashed)
        canvas_.fill({{at, 0.5 * radius}}, ground_, opacity);
    obstacles_.boxes.push_back({at.x - room, at.y - room, 2 * room, 2 * room});
}

void Painter::paint(const Path& path) {
    const Pen pen = viz::pen(theme_, path.style);
    std::vector<Ring> rings;
    for (const Ring& ring : path.rings) {
        Ring mapped;
        for (const Point& p : ring) mapped.push_back(map_(p));
        mapped = clipped_ring(mapped, reach_);
        if (mapped.size() >= 2) rings.push_back(std::move(mapped));
    }
    if (rings.empty()) return;
    if (pen.fill > 0) canvas_.fill(rings, inside_of(pen), pen.fill * path.style.opacity);
    if (pen.width > 0)
        canvas_.stroke(rings, true, {pen.ink, pen.width, path.style.opacity, pen.dashed});
    if (path.style.role == Role::ghost || path.style.role == Role::band) return;
    for (const Ring& ring : rings) add_outline(ring, true, 1.0);
    obstacles_.areas.push_back(rings[0]);
}

void Painter::paint(const Polyline& line) {
    if (line.points.empty()) return;
    const Pen pen = viz::pen(theme_, line.style);
    std::vector<Point> mapped;
    for (const Point& p : line.points) mapped.push_back(map_(p));
    const Point end = mapped.back();
    if (hidden_ && line.depths.size() == line.points.size()) {
        paint_in_space(mapped, line, pen);
    } else if (line.start_opacity < 1) {
        paint_fading(mapped, pen, line.style.opacity, line.start_opacity);
    } else {
        const std::vector<Ring> parts = clipped_line(mapped, reach_);
        canvas_.stroke(parts, false, {pen.ink, pen.width, line.style.opacity, pen.dashed});
    }
    add_outline(mapped, false, 1.5);
    if (!line.end_label.empty() && mapped.size() > 1) {
        const Point before = mapped[mapped.size() - 2];
        const double length = std::max(1e-9, std::hypot(end.x - before.x, end.y - before.y));
        add_words(line.style, line.end_label, end, 0,
                  {(end.x - before.x) / length, (end.y - before.y) / length});
    }
}

/// Points of the line, evenly spaced, in stretches that are seen or hidden by a surface.
std::vector<Painter::Stretch> Painter::stretches_of(const std::vector<Point>& points,
                                                    const std::vector<double>& depths) const {
    std::vector<Stretch> stretches;
    const int each = std::max(1, stretch_steps / static_cast<int>(points.size()));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (int k = 0; k < each; ++k) {
            const auto between = [&](double share) {
                return Point{points[i].x + share * (points[i + 1].x - points[i].x),
                             points[i].y + share * (points[i + 1].y - points[i].y)};
            };
            const double middle = (k + 0.5) / each;
            const double depth = depths[i] + middle * (depths[i + 1] - depths[i]);
            const bool hidden = is_hidden(between(middle), depth);
            if (stretches.empty() || stretches.back().hidden != hidden)
                stretches.push_back({{between(static_cast<double>(k) / each)}, hidden});
            stretches.back().points.push_back(between((k + 1.0) / each));
        }
    }
    return stretches;
}

/// A line over a scene in space: pale where a surface hides it, fading into the past.
void Painter::paint_in_space(const std::vector<Point>& points, const Polyline& line,
                             const Pen& pen) {
    double walked = 0;
    std::vector<Stretch> stretches = stretches_of(points, line.depths);
    double total = 1e-9;
    const auto length_of = [](const std::vector<Point>& way) {
        double length = 0;
        for (std::size_t i = 1; i < way.size(); ++i)
            length += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
        return length;
    };
    for (const Stretch& stretch : stretches) total += length_of(stretch.points);
    for (const Stretch& stretch : stretches) {
        for (std::size_t i = 1; i < stretch.points.size(); ++i) {
            const std::vector<Point> step{stretch.points[i - 1], stretch.points[i]};
            walked += length_of(step);
            const double age = line.start_opacity + (1 - line.start_opacity) * walked / total;
            const double opacity = line.style.opacity * age * (stretch.hidden ? faint : 1);
            if (stretch.hidden && i % 2 == 0) continue;  // dashed
            canvas_.stroke(clipped_line(step, reach_), false,
                           {mixed(ground_, pen.ink, opacity), pen.width, 1, false});
        }
    }
}

/// The line mixes from the ground's ink into its own, in parts of equal length: opaque, so that
/// the parts' ends do not show where they overlap.
void Painter::paint_fading(const std::vector<Point>& points, const Pen& pen, double opacity,
                           double start) {
    double total = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        total += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    if (total <= 0) return;
    std::vector<Point> part{points[0]};
    double walked = 0;
    int number = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        part.push_back(points[i]);
        walked += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
        const bool last = i + 1 == points.size();
        if (!last && walked < total * (number + 1) / fading_parts) continue;
        const double share = opacity * (start + (1 - start) * walked / total);
        canvas_.stroke(clipped_line(part, reach_), false,
                       {mixed(ground_, pen.ink, share), pen.width, 1, pen.dashed});
        part = {points[i]};
        number = static_cast<int>(walked / total * fading_parts);
    }
}

void Painter::paint(const Arrow& arrow) {
    const Pen pen = viz::pen(theme_, arrow.style);
    const Point tail = map_(arrow.tail);
    const Point tip = map_(arrow.tip);
    const double length = std::hypot(tip.x - tail.x, tip.y - tail.y);
    if (!(length > 1) || (!contains(reach_, tail) && !contains(reach_, tip))) return;
    const Point along{(tip.x - tail.x) / length, (tip.y - tail.y) / length};
    const double head = std::min(head_length, 0.5 * length);
    const double half = head * head_half_width / head_length;
    const Point neck{tip.x - head * along.x, tip.y - head * along.y};
    const Ring tri{tip,
                   {neck.x - half * along.y, neck.y + half * along.x},
                   {neck.x + half * along.y, neck.y - half * along.x}};
    const Point end{neck.x + 0.3 * head * along.x, neck.y + 0.3 * head * along.y};
    const double opacity = arrow.style.opacity;
    if (hidden_ && arrow.tip_depth != in_front) {
        for (const Stretch& stretch :
             stretches_of({tail, end}, {arrow.tail_depth, arrow.tip_depth})) {
            const double seen = opacity * (stretch.hidden ? faint : 1);
            const auto part = clipped_line({stretch.points.front(), stretch.points.back()}, reach_);
            canvas_.stroke(part, false, {ground_, pen.width + 2 * halo, seen * seen, false});
            canvas_.stroke(part, false, {pen.ink, pen.width, seen, stretch.hidden});
        }
        const bool behind = is_hidden(neck, arrow.tip_depth);
        const double seen = opacity * (behind ? faint : 1);
        canvas_.stroke({tri}, true, {ground_, 2 * halo, seen * seen, false});
        canvas_.fill(std::vector<Ring>{tri}, pen.ink, seen);
    } else {
        const auto shafts = clipped_line({tail, end}, reach_);
        canvas_.stroke(shafts, false, {ground_, pen.width + 2 * halo, opacity, false});
        canvas_.stroke({tri}, true, {ground_, 2 * halo, opacity, false});
        canvas_.stroke(shafts, false, {pen.ink, pen.width, opacity, pen.dashed});
        canvas_.fill(std::vector<Ring>{tri}, pen.ink, opacity);
    }
    obstacles_.segments.push_back({tail, tip, 25});
    if (!arrow.label.empty()) add_words(arrow.style, arrow.label, tip, 0, along);
}

void Painter::paint(const Label& label) {
    add_words(label.style, label.text, map_(label.anchor),
              label.clearance > 0 ? map_.length(label.clearance) : 0, {0, 0});
}

void Painter::add_words(const Style& style, const std::string& words, Point anchor,
                        double clearance, Point away) {
    if (words.empty() || !contains(grown(frame_, 2), anchor)) return;
    Rgb ink = viz::pen(theme_, style).ink;
    if (style.role == Role::node) ink = page_inks(theme_).muted;
    Text text{.words = words,
              .size = label_size_,
              .weight = Weight::medium,
              .ink = ink,
              .opacity = style.opacity};
    const Extent extent = canvas_.measure(text);
    words_.push_back({text, {anchor, clearance, extent, away}});
}

void Painter::keep_words_off(const std::vector<Ring>& outlines) {
    for (const Ring& outline : outlines) {
        Ring mapped;
        for (const Point& p : outline) mapped.push_back(map_(p));
        add_outline(mapped, true, 1.0);
        obstacles_.areas.push_back(std::move(mapped));
    }
}

void Painter::add_outline(const Ring& ring, bool closed, double cost) {
    for (std::size_t i = 0; i + (closed ? 0 : 1) < ring.size(); ++i) {
        const Point p = ring[i];
        const Point q = ring[(i + 1) % ring.size()];
        if (contains(reach_, p) || contains(reach_, q)) obstacles_.segments.push_back({p, q, cost});
    }
}

void Painter::paint_words(const Rect& bounds) {
    std::vector<LabelRequest> requests;
    for (const Words& words : words_) requests.push_back(words.request);
    const bool in_column = plot_ && end_in_column(requests, frame_.right());
    const std::vector<PlacedLabel> placed =
        in_column ? place_in_column(requests, frame_.right() + column_room, bounds)
                  : place_labels(requests, obstacles_, bounds);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Text& text = words_[i].text;
        if (placed[i].leader)
            canvas_.stroke({{placed[i].leader_from, placed[i].leader_to}}, false,
                           {text.ink, 1, 0.8 * text.opacity, false});
        canvas_.write(text, {placed[i].box.x, placed[i].box.y}, &ground_);
    }
}

}  // namespace

void paint_marks(const Panel& panel, const PanelPlace& place, const PanelInk& ink,
                 const Hidden& hidden, Canvas& canvas) {
    Painter painter(place, panel.axes.has_value(), ink, hidden, canvas);
    canvas.clip(panel.axes ? grown(place.frame, 8) : place.frame);
    if (panel.space) painter.keep_words_off(outlines_of(*panel.space));
    painter.paint(panel.marks);
    canvas.unclip();
    Rect bounds = grown(place.frame, -6);
    if (panel.axes) {  // the names of curves may stand right of the frame
        bounds = place.frame;
        bounds.width = place.title.right() - bounds.x;
    }
    if (place.title.y > place.frame.y && place.title.height > 0) {
        bounds.y += place.title.height;
        bounds.height -= place.title.height;
    }
    painter.paint_words(bounds);
}

}  // namespace viz
