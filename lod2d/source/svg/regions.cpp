#include "lodlab/lod2d/source/svg/regions.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/source/paths/clean_work.hpp"
#include "lodlab/lod2d/source/paths/regions.hpp"

namespace lod2d {
namespace {

/// Whether a subpath has points beside a line through it.
bool may_enclose(const std::vector<Point>& points) {
    const Point& from = points[0];
    double length = 0;
    Point along = Point::Zero();
    for (const Point& p : points) {
        if ((p - from).norm() <= length) continue;
        length = (p - from).norm();
        along = (p - from) / length;
    }
    double aside = 0;
    for (const Point& p : points)
        aside = std::max(aside, std::abs((p - from).x() * along.y() - (p - from).y() * along.x()));
    return aside > 1e-8 * length;
}

bool may_enclose(const CurvePath& path) {
    return std::ranges::any_of(path.subpaths(), [](const CurvePath::Subpath& sub) {
        return sub.points.size() >= 3 && may_enclose(sub.points);
    });
}

FilledPath path_along(const Outline& outline) {
    FilledPath filled;
    for (const Ring& ring : outline.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            i == 0 ? filled.path.move_to(ring[i]) : filled.path.line_to(ring[i]);
        filled.path.close();
    }
    return filled;
}

class Regions {
  public:
    Regions(const std::string& name, SvgDrawing& drawing, const SvgSettings& settings)
        : name_(name), drawing_(drawing), settings_(settings) {
        Box box;
        for (const SvgFill& fill : drawing.fills) box.hold(fill.region.path.control_box());
        for (const SvgStroke& stroke : drawing.strokes) {
            const Box line = stroke.path.control_box();
            const Point pen = Point::Constant(stroke.style.width / 2);
            CurvePath around = rectangle_path(
                line.low - pen, line.size() + Point::Constant(stroke.style.width), Point::Zero());
            around.transform(stroke.to_page);
            box.hold(around.control_box());
        }
        if (settings.page && drawing.page &&
            !box.is_empty()) {  // what is cut off needs no tolerance
            box.low = box.low.cwiseMax(drawing.page->low);
            box.high = box.high.cwiseMin(drawing.page->high);
        }
        const double diagonal = box.is_empty() ? 1 : box.size().norm();
        tolerance_ = std::max(settings.outline.tolerance * diagonal / 4, 1e-300);
        if (drawing.page) {
            const Point margin = Point::Constant(1e-6 * drawing.page->size().maxCoeff());
            kept_.hold(drawing.page->low - margin);
            kept_.hold(drawing.page->high + margin);
        }
    }

    std::vector<FilledPath> take();

  private:
    void add(FilledPath region, const SvgClips& clips);
    [[nodiscard]] FilledPath covered_by(const SvgStroke& stroke) const;
    [[nodiscard]] Outline flattened(const FilledPath& region) const {
        return {region.path.flatten(tolerance_), region.rule};
    }
    [[nodiscard]] bool on_page(const Box& box) const {
        return !drawing_.page || box.is_empty() ||
               (kept_.low.cwiseMin(box.low) == kept_.low &&
                kept_.high.cwiseMax(box.high) == kept_.high);
    }
    [[noreturn]] void exceed(const std::string& what) const {
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         "cannot use " + name_ + ": " + what + "; simplify it or raise the limit");
    }

    const std::string& name_;
    SvgDrawing& drawing_;
    const SvgSettings& settings_;
    double tolerance_ = 0;
    Box kept_;
    std::size_t outside_ = 0;
    std::vector<FilledPath> regions_;
};

FilledPath Regions::covered_by(const SvgStroke& stroke) const {
    const lod::Matrix<2>& m = stroke.to_page.linear;
    const double largest =
        std::sqrt(m(0, 0) * m(0, 0) + m(0, 1) * m(0, 1) + m(1, 0) * m(1, 0) + m(1, 1) * m(1, 1));
    if (!(largest > 0)) return {};
    const double tolerance = std::max(tolerance_ / largest, 1e-300);
    constexpr std::size_t most_dashes = 100'000;
    if (count_dashes(stroke.path, stroke.style, tolerance, most_dashes) >= most_dashes)
        exceed("a stroke has more than " + std::to_string(most_dashes) + " dashes");
    Outline pieces = stroke_pieces(stroke.path, stroke.style, tolerance);
    const CleanSettings& clean = settings_.outline.clean;
    std::size_t points = 0;
    for (const Ring& ring : pieces.rings) points += ring.size();
    if (points > clean.most_points)
        exceed("a stroke's outline has more than " + std::to_string(clean.most_points) + " points");
    if (count_edge_pairs({pieces.rings}, clean.most_edge_pairs) > clean.most_edge_pairs)
        exceed("a stroke's outline is too intricate: more than " +
               std::to_string(clean.most_edge_pairs) + " pairs of edges that may cross");
    // The pieces of one line cross their neighbours; a scribble crosses all of itself.
    const std::uint64_t most = clean.most_crossings + 20 * pieces.rings.size();
    if (count_crossings({pieces.rings}, most) > most)
        exceed("a stroke is too intricate: more than " + std::to_string(clean.most_crossings) +
               " crossings of its outline");
    // A few pieces at a time: what overlaps still, all the regions' union takes together.
    constexpr std::size_t at_once = 100;
    Outline covering;
    for (std::size_t i = 0; i < pieces.rings.size(); i += at_once) {
        const auto first = pieces.rings.begin() + static_cast<std::ptrdiff_t>(i);
        const std::size_t count = std::min(at_once, pieces.rings.size() - i);
        Outline some = united({{first, first + static_cast<std::ptrdiff_t>(count)}});
        std::ranges::move(some.rings, std::back_inserter(covering.rings));
        lod::check_interrupted();
    }
    FilledPath covered = path_along(covering);
    covered.path.transform(stroke.to_page);
    return covered;
}

void Regions::add(FilledPath region, const SvgClips& clips) {
    lod::check_interrupted();
    bool inside = on_page(region.path.control_box());
    Outline lines;
    if (!inside || !clips.empty()) lines = flattened(region);
    if (!inside) inside = on_page(bounds({lines.rings}));
    if (clips.empty() && (inside || !settings_.page)) {
        outside_ += !inside;
        return regions_.push_back(std::move(region));
    }
    std::vector<Outline> within;
    for (const auto& clip : clips) within.push_back(flattened(*clip));
    Outline seen = within.empty() ? lines : intersected(lines, within);
    if (!on_page(bounds({seen.rings}))) {
        ++outside_;
        if (!settings_.page) return regions_.push_back(path_along(seen));
        const Box& page = *drawing_.page;
        const Outline sheet{
            {{page.low, {page.high.x(), page.low.y()}, page.high, {page.low.x(), page.high.y()}}}};
        seen = intersected(seen, std::span(&sheet, 1));
    }
    if (!seen.rings.empty()) regions_.push_back(path_along(seen));
}

std::vector<FilledPath> Regions::take() {
    SvgNotes& notes = drawing_.notes;
    std::erase_if(drawing_.fills,
                  [](const SvgFill& fill) { return !may_enclose(fill.region.path); });
    for (const SvgFill& fill : drawing_.fills) add(fill.region, fill.clips);
    if (settings_.strokes || drawing_.fills.empty()) {
        for (const SvgStroke& stroke : drawing_.strokes) add(covered_by(stroke), stroke.clips);
    } else {
        const auto around = static_cast<std::size_t>(
            std::ranges::count_if(drawing_.strokes, &SvgStroke::around_fill));
        SvgNotes::count(notes.left_out, "unfilled stroke", "unfilled strokes",
                        drawing_.strokes.size() - around);
        SvgNotes::count(notes.left_out, "stroke around a fill", "strokes around fills", around);
    }
    if (outside_ > 0) {
        const std::string shapes =
            outside_ == 1 ? "1 shape lies" : std::to_string(outside_) + " shapes lie";
        notes.doubt(shapes + " in part outside its page, where a browser cuts " +
                    (settings_.page ? "them off, as was done" : "them off (the option page does)"));
    }
    std::erase_if(regions_, [](const FilledPath& region) { return region.path.empty(); });
    return std::move(regions_);
}

}  // namespace

std::vector<FilledPath> regions_of(const std::string& name, SvgDrawing& drawing,
                                   const SvgSettings& settings) {
    return Regions(name, drawing, settings).take();
}

}  // namespace lod2d
