#include "lodlab/lod2d/source/paths/regions.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

namespace lod2d {
namespace {

using ClipperLib::Paths;

/// Integer coordinates about the middle of an outline.
class LocalGrid {
  public:
    explicit LocalGrid(const Outline& outline) {
        const Box box = bounds({outline.rings});
        if (box.is_empty()) return;
        middle_ = box.centre();
        const double extent = box.size().maxCoeff();
        if (extent > 0) step_ = extent / 0x1p29;
    }

    [[nodiscard]] Paths to_grid(const std::vector<Ring>& rings) const {
        constexpr double reach = 0x1p44;  // further out nothing that is clipped can be told apart
        Paths paths;
        for (const Ring& ring : rings) {
            ClipperLib::Path& path = paths.emplace_back();
            for (const Point& p : ring) {
                const Point q = (p - middle_) / step_;
                path.emplace_back(std::llround(std::clamp(q.x(), -reach, reach)),
                                  std::llround(std::clamp(q.y(), -reach, reach)));
            }
        }
        return paths;
    }

    [[nodiscard]] Outline from_grid(const Paths& paths) const {
        Outline outline;
        for (const ClipperLib::Path& path : paths) {
            Ring& ring = outline.rings.emplace_back();
            for (const ClipperLib::IntPoint& p : path)
                ring.push_back(middle_ +
                               step_ * Point(static_cast<double>(p.X), static_cast<double>(p.Y)));
        }
        return outline;
    }

  private:
    Point middle_ = Point::Zero();
    double step_ = 1;
};

ClipperLib::PolyFillType fill_type(FillRule rule) {
    return rule == FillRule::nonzero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd;
}

Paths combined(ClipperLib::ClipType how, const Paths& a, FillRule rule_a, const Paths& b,
               FillRule rule_b) {
    ClipperLib::Clipper clipper;
    Paths result;
    const bool any = clipper.AddPaths(a, ClipperLib::ptSubject, true);
    const bool other = clipper.AddPaths(b, ClipperLib::ptClip, true);
    if (any && (other || how == ClipperLib::ctUnion))
        clipper.Execute(how, result, fill_type(rule_a), fill_type(rule_b));
    return result;
}

}  // namespace

Outline united(const Outline& outline) {
    const LocalGrid grid(outline);
    return grid.from_grid(combined(ClipperLib::ctUnion, grid.to_grid(outline.rings), outline.rule,
                                   {}, FillRule::nonzero));
}

Outline intersected(const Outline& outline, std::span<const Outline> clips) {
    const LocalGrid grid(outline);
    Paths paths = grid.to_grid(outline.rings);
    FillRule rule = outline.rule;
    for (const Outline& clip : clips) {
        paths =
            combined(ClipperLib::ctIntersection, paths, rule, grid.to_grid(clip.rings), clip.rule);
        rule = FillRule::nonzero;
    }
    return grid.from_grid(paths);
}

}  // namespace lod2d
