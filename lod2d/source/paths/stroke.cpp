#include "lodlab/lod2d/source/paths/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

Point turned_left(const Point& v) {
    return {-v.y(), v.x()};
}

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

using Chain = CurvePath::Chain;

/// Appends point i of another chain.
void append(Chain& chain, const Chain& of, std::size_t i) {
    chain.append(of.points[i], of.smooth[i], of.before[i], of.after[i]);
}

/// A subpath as a chain whose end is repeated only where the pen comes back without closing.
Chain chain_of(Chain chain, const CurvePath::Subpath& path) {
    if (!path.closed && path.points.size() > 1 && path.points.back() == path.points.front())
        chain.append(path.points.front(), false, chain.before.front());
    return chain;
}

/// Without points that repeat the one before.
Chain without_repeats(const Chain& chain, bool closed) {
    Chain result;
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
        if (result.points.empty() || chain.points[i] != result.points.back()) {
            append(result, chain, i);
        } else {
            result.after.back() = chain.after[i];
            result.smooth.back() = chain.smooth[i];
        }
    }
    while (closed && result.points.size() > 1 && result.points.front() == result.points.back()) {
        result.before.front() = result.before.back();
        result.points.pop_back();
    }
    return result;
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
    void follow(const Chain& chain, bool closed, const Point& heading = {1, 0});
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
    void round_join(const Point& at, const Point& before, const Point& after);
    /// The line of a chain from point i, and how it turns at its ends.
    struct Piece {
        Point from, to, along;
        double turn_from, turn_to;  ///< sine of the angle that a curve turns left; 0 at corners
        [[nodiscard]] double turn() const { return (turn_from + turn_to) / 2; }
    };
    [[nodiscard]] bool is_tight(const Piece& piece) const {
        return r_ * std::abs(piece.turn()) > (piece.to - piece.from).norm();
    }
    void corner(const Point& at, const Point& line_before, const Point& before, const Point& after,
                const Point& line_after);
    void straight(const Piece& piece);
    void bent(std::span<const Piece> pieces);

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

/// Only the outer side's sector: a whole disc would stand out of an end near by.
void Pen::round_join(const Point& at, const Point& before, const Point& after) {
    const double outer = cross(before, after) > 0 ? -r_ : r_;
    const Point from = outer * turned_left(before);
    const Point to = outer * turned_left(after);
    const Point middle = r_ * (before - after).normalized();
    Ring sector{at, at + from};
    arc(at, from, middle, sector);
    arc(at, middle, to, sector);
    add(std::move(sector));
}

/// The corner between lines along two unit vectors.
void Pen::join(const Point& at, const Point& before, const Point& after) {
    const double sine = cross(before, after);
    const double cosine = before.dot(after);
    if (sine == 0 && cosine > 0) return;
    const double outer = sine > 0 ? -r_ : r_;  // the outer side is on the right of a left turn
    const Point from = at + outer * turned_left(before);
    const Point to = at + outer * turned_left(after);
    if (style_.join == StrokeJoin::round) return round_join(at, before, after);
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

/// A corner of the path, whose directions are those of its curves, where they are known, and not
/// of the lines along them.
void Pen::corner(const Point& at, const Point& line_before, const Point& before, const Point& after,
                 const Point& line_after) {
    const Point& from = before.isZero() ? line_before : before;
    const Point& to = after.isZero() ? line_after : after;
    if (from != line_before) round_join(at, line_before, from);
    join(at, from, to);
    if (to != line_after) round_join(at, to, line_after);
}

void Pen::straight(const Piece& piece) {
    const Point side = r_ * turned_left(piece.along);
    add({piece.from - side, piece.to - side, piece.to + side, piece.from + side});
}

/// A bend tighter than the pen: the pen's inner half turns about points within it, the centres of
/// the bend, and covers what lies before them and what lies beyond.
void Pen::bent(std::span<const Piece> pieces) {
    const double inner = pieces[0].turn() > 0 ? 1 : -1;
    Ring before, beyond, centres;
    for (const Piece& piece : pieces) {
        const Point left = turned_left(piece.along);
        const auto arm = [&](double turn) {
            return Point((inner * (left - turn / 2 * piece.along)).normalized());
        };
        const Point arm_from = arm(-piece.turn_from);
        const Point arm_to = arm(piece.turn_to);
        const double reach = cross(piece.to - piece.from, arm_to) / cross(arm_from, arm_to);
        centres.push_back(piece.from + reach * arm_from);
        const Point side = r_ * inner * left;
        add({piece.from, piece.to, piece.to - side, piece.from - side});
        before.push_back(piece.from);
        beyond.push_back(piece.from + r_ * arm_from);
        const Point& centre = centres.back();
        const Point last = piece.to + r_ * arm_to;
        const double start = (beyond.back() - centre).norm();
        const double end = (last - centre).norm();
        const int cuts =
            1 + static_cast<int>(std::abs(piece.turn()) * steps_ / (2 * std::numbers::pi));
        for (int i = 1; i <= cuts; ++i) {
            const double share = double(i) / cuts;
            const Point ray = (1 - share) * arm_from + share * arm_to;
            beyond.push_back(centre + ((1 - share) * start + share * end) * ray.normalized());
        }
    }
    before.push_back(pieces.back().to);
    before.insert(before.end(), centres.rbegin(), centres.rend());
    beyond.insert(beyond.end(), centres.rbegin(), centres.rend());
    add(std::move(before));
    add(std::move(beyond));
}

void Pen::follow(const Chain& chain, bool closed, const Point& heading) {
    const auto [line, before, after, smooth] = without_repeats(chain, closed);
    if (line.size() == 1) return dot(line[0], heading);
    const std::size_t n = line.size();
    std::vector<Piece> pieces(closed ? n : n - 1);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieces[i] = {line[i], line[(i + 1) % n], (line[(i + 1) % n] - line[i]).normalized(), 0, 0};
    for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
        Piece& last = pieces[(i + pieces.size() - 1) % pieces.size()];
        if (smooth[i]) last.turn_to = pieces[i].turn_from = cross(last.along, pieces[i].along);
    }
    Piece& first = pieces.front();
    Piece& last = pieces.back();
    if (!closed) {  // the path's ends turn by half as much
        first.turn_from = 2 * cross(after[0], first.along);
        last.turn_to = 2 * cross(last.along, before[n - 1]);
    }
    for (std::size_t i = 0; i < pieces.size();) {
        std::size_t end = i;
        while (end < pieces.size() && is_tight(pieces[end]) &&
               pieces[end].turn() * pieces[i].turn() > 0)
            ++end;
        if (end > i) bent(std::span(pieces).subspan(i, end - i));
        if (end == i) straight(pieces[end++]);
        i = end;
    }
    for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
        const Piece& from = pieces[(i + pieces.size() - 1) % pieces.size()];
        if (!smooth[i])
            corner(line[i], from.along, before[i], after[i], pieces[i].along);
        else if (is_tight(from) && is_tight(pieces[i]))
            round_join(line[i], from.along, pieces[i].along);
        else
            join(line[i], from.along, pieces[i].along);
    }
    if (closed) return;
    if (is_tight(first) && first.turn_from != 0) round_join(line.front(), after[0], first.along);
    if (is_tight(last) && last.turn_to != 0) round_join(line.back(), last.along, before[n - 1]);
    end(line.front(), -first.along);
    end(line.back(), last.along);
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
    void cut(const Chain& line, Visit&& visit) {
        Chain dash;
        if (on()) append(dash, line, 0);
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Point& a = line.points[i - 1];
            const Point& b = line.points[i];
            const double length = (b - a).norm();
            double done = 0;
            while (length - done > left_) {
                done += left_;
                const Point p = a + (b - a) * (done / length);
                if (on()) {
                    dash.append(p);
                    if (!visit(std::move(dash), Point((b - a) / length))) return;
                    dash = {};
                }
                step();
                left_ = lengths_[at_];
                if (on()) dash.append(p);
            }
            left_ -= length - done;
            if (on()) append(dash, line, i);
        }
        if (dash.points.size() > 1) visit(std::move(dash), Point(1, 0));
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

/// A piece of a line, and the direction at its end.
struct Dash {
    Chain chain;
    Point heading = {1, 0};
    bool closed = false;  ///< all of a closed line
};

/// Calls visit(dash) for each until it returns false. On a closed line the dash that the pattern
/// leaves open at the end goes on as the first, over the closing point.
template <typename Visit>
void visit_dashes(const Chain& line, const CurvePath::Subpath& path, const StrokeStyle& style,
                  Visit&& visit) {
    Chain whole = chain_of(line, path);
    if (path.closed) append(whole, line, 0);
    Dashes dashes(style);
    std::optional<Dash> first;
    std::optional<Dash> last;
    bool going = true;
    bool may_join = path.closed && dashes.on();
    dashes.cut(whole, [&](Chain chain, const Point& heading) {
        if (last) going = visit(std::move(*last));
        (may_join ? first : last) = Dash{std::move(chain), heading};
        may_join = false;
        return going;
    });
    if (!going) return;
    if (first && dashes.on()) {
        if (last) {
            for (std::size_t i = 1; i < first->chain.points.size(); ++i)
                append(last->chain, first->chain, i);
            last->heading = first->heading;
            first.reset();
        } else {
            first->closed = true;
        }
    }
    if (first && !visit(std::move(*first))) return;
    if (last) (void)visit(std::move(*last));
}

}  // namespace

Outline stroke_pieces(const CurvePath& path, const StrokeStyle& style, double tolerance) {
    Pen pen(style, tolerance);
    const bool dashed = is_dashed(style);
    const std::vector<Chain> lines = path.chains(tolerance);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const CurvePath::Subpath& sub = path.subpaths()[i];
        if (!sub.closed && sub.points.size() < 2) continue;  // a move alone
        if (!dashed) {
            pen.follow(chain_of(lines[i], sub), sub.closed);
            continue;
        }
        visit_dashes(lines[i], sub, style, [&](const Dash& dash) {
            pen.follow(dash.chain, dash.closed, dash.heading);
            return true;
        });
    }
    return pen.take();
}

std::size_t count_dashes(const CurvePath& path, const StrokeStyle& style, double tolerance,
                         std::size_t most) {
    if (!is_dashed(style)) return 0;
    std::size_t count = 0;
    const std::vector<Chain> lines = path.chains(tolerance);
    for (std::size_t i = 0; i < lines.size() && count < most; ++i)
        visit_dashes(lines[i], path.subpaths()[i], style,
                     [&](const Dash&) { return ++count < most; });
    return count;
}

}  // namespace lod2d
