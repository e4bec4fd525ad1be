#include "lodlab/lod2d/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

Point turned_left(const Point& v) {
    return {-v.y(), v.x()};
}

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A subpath as a chain whose end is repeated only where the pen comes back without closing.
Ring chain_of(Ring ring, const CurvePath::Subpath& path) {
    if (!path.closed && path.points.size() > 1 && path.points.back() == path.points.front())
        ring.push_back(path.points.front());
    return ring;
}

/// Draws the pieces of one pen.
class Pen {
  public:
    Pen(const StrokeStyle& style, double tolerance) : style_(style), r_(style.width / 2) {
        // A chord of n steps to the circle strays by r (1 - cos(pi / n)), about r (pi / n)^2 / 2.
        const double steps = std::numbers::pi / std::sqrt(2 * std::min(1.0, tolerance / r_));
        steps_ = static_cast<int>(std::clamp(std::ceil(steps), 8.0, 2000.0));
    }

    /// `heading`, a unit vector, is what the caps of a dot follow.
    void follow(Ring line, bool closed, const Point& heading = {1, 0});
    Outline take() { return std::move(outline_); }

  private:
    void add(Ring ring) {
        double twice = 0;
        for (std::size_t i = 0; i < ring.size(); ++i)
            twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
        if (twice == 0) return;
        if (twice < 0) std::ranges::reverse(ring);  // so that pieces never cancel
        outline_.rings.push_back(std::move(ring));
    }
    void disc(const Point& at);
    void dot(const Point& at, const Point& along);
    void end(const Point& at, const Point& outwards);
    void arc(const Point& at, const Point& from, const Point& to, Ring& ring) const;
    void join(const Point& at, const Point& before, const Point& after);

    const StrokeStyle& style_;
    double r_;
    int steps_;
    Outline outline_;
};

void Pen::disc(const Point& at) {
    Ring ring;
    for (int i = 0; i < steps_; ++i) {
        const lod::SineCosine of =
            lod::sine_cosine(2 * std::numbers::pi * i / steps_ - std::numbers::pi);
        ring.emplace_back(at.x() + r_ * of.cosine, at.y() + r_ * of.sine);
    }
    add(std::move(ring));
}

/// A cap at the end of a line; `outwards` is a unit vector.
void Pen::end(const Point& at, const Point& outwards) {
    if (style_.cap == StrokeCap::round) return disc(at);
    if (style_.cap == StrokeCap::butt) return;
    const Point side = r_ * turned_left(outwards);
    const Point ahead = r_ * outwards;
    add({at - side, at - side + ahead, at + side + ahead, at + side});
}

/// Appends the shorter arc about `at` between two arms, without its beginning.
void Pen::arc(const Point& at, const Point& from, const Point& to, Ring& ring) const {
    const double chord = 2 * r_ * std::numbers::pi / steps_;
    if ((to - from).norm() > chord) {
        const Point middle = r_ * (from + to).normalized();
        arc(at, from, middle, ring);
        arc(at, middle, to, ring);
    } else {
        ring.push_back(at + to);
    }
}

/// The corner between lines along two unit vectors.
void Pen::join(const Point& at, const Point& before, const Point& after) {
    const double sine = cross(before, after);
    const double cosine = before.dot(after);
    if (sine == 0 && cosine > 0) return;
    const double outer = sine > 0 ? -r_ : r_;  // the outer side is on the right of a left turn
    const Point from = at + outer * turned_left(before);
    const Point to = at + outer * turned_left(after);
    if (style_.join == StrokeJoin::round) {
        // Only the outer side's sector: a whole disc would stand out of an end near by.
        const Point middle = r_ * (before - after).normalized();
        Ring sector{at, from};
        arc(at, from - at, middle, sector);
        arc(at, middle, to - at, sector);
        return add(std::move(sector));
    }
    // The miter reaches r / cos(half the turn); its square, by the half-angle formula:
    const double reach_squared = 2 / (1 + cosine);
    if (style_.join == StrokeJoin::miter && 1 + cosine > 1e-12 &&
        reach_squared <= style_.miter_limit * style_.miter_limit) {
        const Point middle = outer * (turned_left(before) + turned_left(after));
        return add({at, from, at + middle / (1 + cosine), to});
    }
    add({at, from, to});
}

void Pen::dot(const Point& at, const Point& along) {
    end(at, along);
    if (style_.cap == StrokeCap::square) end(at, -along);
}

void Pen::follow(Ring line, bool closed, const Point& heading) {
    const auto repeated = std::unique(line.begin(), line.end());
    line.erase(repeated, line.end());
    if (closed)
        while (line.size() > 1 && line.front() == line.back()) line.pop_back();
    if (line.size() == 1) return dot(line[0], heading);
    const std::size_t n = line.size();
    const std::size_t pieces = closed ? n : n - 1;
    std::vector<Point> along;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Point& a = line[i];
        const Point& b = line[(i + 1) % n];
        along.push_back((b - a) / (b - a).norm());
        const Point side = r_ * turned_left(along.back());
        add({a - side, b - side, b + side, a + side});
    }
    for (std::size_t i = 1; i < pieces; ++i) join(line[i], along[i - 1], along[i]);
    if (closed) return join(line[0], along.back(), along.front());
    end(line.front(), -along.front());
    end(line.back(), along.back());
}

/// Walks along a line and cuts it where a pattern of dashes begins and ends.
class Dashes {
  public:
    explicit Dashes(const StrokeStyle& style) : lengths_(style.dashes) {
        if (lengths_.size() % 2 == 1)
            lengths_.insert(lengths_.end(), style.dashes.begin(), style.dashes.end());
        double period = 0;
        for (const double length : lengths_) period += length;
        double into = std::fmod(style.dash_offset, period);
        if (into < 0) into += period;
        // A first dash without length is a dot.
        while (into > 0 && into >= lengths_[at_]) {
            into -= lengths_[at_];
            step();
        }
        left_ = lengths_[at_] - into;
    }

    /// Calls visit(dash, direction at its end) for each, until it returns false.
    template <typename Visit>
    void cut(const Ring& line, Visit&& visit) {
        Ring dash;
        if (on()) dash.push_back(line[0]);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point& a = line[i - 1];
            const Point& b = line[i];
            const double length = (b - a).norm();
            double done = 0;
            while (length - done > left_) {
                done += left_;
                const Point p = a + (b - a) * (done / length);
                if (on()) {
                    dash.push_back(p);
                    if (!visit(std::move(dash), Point((b - a) / length))) return;
                    dash.clear();
                }
                step();
                left_ = lengths_[at_];
                if (on()) dash.push_back(p);
            }
            left_ -= length - done;
            if (on()) dash.push_back(b);
        }
        if (dash.size() > 1) visit(std::move(dash), Point(1, 0));
    }

    [[nodiscard]] bool on() const { return at_ % 2 == 0; }

  private:
    void step() { at_ = (at_ + 1) % lengths_.size(); }

    std::vector<double> lengths_;
    std::size_t at_ = 0;
    double left_ = 0;
};

bool is_dashed(const StrokeStyle& style) {
    double period = 0;
    for (const double length : style.dashes) period += length;
    return period > 0 && std::isfinite(period);
}

template <typename Visit>
void visit_dashes(const Ring& line, const CurvePath::Subpath& path, const StrokeStyle& style,
                  Visit&& visit) {
    Ring whole = chain_of(line, path);
    if (path.closed) whole.push_back(line[0]);
    Dashes(style).cut(whole, visit);
}

}  // namespace

Outline stroke_pieces(const CurvePath& path, const StrokeStyle& style, double tolerance) {
    Pen pen(style, tolerance);
    const bool dashed = is_dashed(style);
    const std::vector<Ring> lines = path.flatten(tolerance);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const bool closed = path.subpaths()[i].closed;
        if (!closed && path.subpaths()[i].points.size() < 2) continue;  // a move alone
        if (!dashed) {
            pen.follow(chain_of(lines[i], path.subpaths()[i]), closed);
            continue;
        }
        visit_dashes(lines[i], path.subpaths()[i], style, [&](Ring dash, const Point& heading) {
            pen.follow(std::move(dash), false, heading);
            return true;
        });
    }
    return pen.take();
}

std::size_t count_dashes(const CurvePath& path, const StrokeStyle& style, double tolerance,
                         std::size_t most) {
    if (!is_dashed(style)) return 0;
    std::size_t count = 0;
    const std::vector<Ring> lines = path.flatten(tolerance);
    for (std::size_t i = 0; i < lines.size() && count < most; ++i)
        if (!lines[i].empty())
            visit_dashes(lines[i], path.subpaths()[i], style,
                         [&](const Ring&, const Point&) { return ++count < most; });
    return count;
}

}  // namespace lod2d
