#pragma once

#include <vector>

#include "lodlab/lod2d/shape/shape.hpp"

namespace lod2d {

/// p to linear p + offset.
struct Affine {
    lod::Matrix<2> linear = lod::Matrix<2>::Identity();
    Point offset = Point::Zero();

    static Affine translation(const Point& by) { return {lod::Matrix<2>::Identity(), by}; }
    static Affine scaling(double x, double y) { return {{x, 0, 0, y}, Point::Zero()}; }

    friend Point operator*(const Affine& a, const Point& p) { return a.linear * p + a.offset; }
    /// b first, then a.
    friend Affine operator*(const Affine& a, const Affine& b) {
        return {a.linear * b.linear, a * b.offset};
    }
};

/// Which of the arcs between two points.
struct EllipseArc {
    double rx = 0;
    double ry = 0;
    double tilt = 0;     ///< of the ellipse [rad]
    bool large = false;  ///< longer than half of it
    bool sweep = true;   ///< from +x to +y
};

/// Lines and cubic Bezier curves, as drawn by a pen. Other curves become cubics: parabolas exactly,
/// arcs of ellipses within 1e-7 of their radius.
class CurvePath {
  public:
    struct Subpath {
        std::vector<Point> points;  ///< the start, then 1 point a line, 3 a curve
        std::vector<bool> curved;   ///< of each piece
        bool closed = false;
    };

    void move_to(const Point& p);
    /// Drawing needs a place to start: requires a move_to before.
    void line_to(const Point& p);
    void quadratic_to(const Point& control, const Point& p);
    void cubic_to(const Point& control_1, const Point& control_2, const Point& p);
    /// An arc as in SVG, of an ellipse through both ends. Radii too small to reach are scaled up, a
    /// radius of zero draws a line.
    void arc_to(const EllipseArc& arc, const Point& p);
    /// Back to the start of the subpath; what follows without move_to starts there.
    /// Right after a move_to it makes a subpath of that one point, where round and square caps
    /// draw.
    void close();
    /// Removes subpaths of one point, which fill nothing.
    void drop_dots();

    void append(const CurvePath& other);
    void transform(const Affine& affine);

    [[nodiscard]] bool empty() const { return subpaths_.empty(); }
    [[nodiscard]] const Point& current() const { return current_; }
    [[nodiscard]] const std::vector<Subpath>& subpaths() const { return subpaths_; }
    [[nodiscard]] bool finite() const;      ///< every coordinate finite and within 1e60
    [[nodiscard]] Box control_box() const;  ///< of all points, control points too

    /// Every subpath as a chain of points no further than `tolerance` from the curve, at most
    /// most_cuts lines a curve. The start is not repeated at the end.
    [[nodiscard]] std::vector<Ring> flatten(double tolerance) const;

    /// The same, with what tells curves from corners.
    struct Chain {
        Ring points;
        /// Unit vectors along the path before and after each point; zero where that is not known.
        std::vector<Point> before;
        std::vector<Point> after;
        std::vector<bool> smooth;  ///< of each point: the path has no corner there

        void append(const Point& p, bool is_smooth = false, const Point& from = Point::Zero(),
                    const Point& on = Point::Zero());
    };
    [[nodiscard]] std::vector<Chain> chains(double tolerance) const;

    static constexpr int most_cuts = 1000;

  private:
    Subpath& drawing();

    std::vector<Subpath> subpaths_;
    Point current_ = Point::Zero();
    bool restart_ = true;  ///< the next piece begins a subpath
    bool moved_ = false;   ///< by a move_to, and nothing was drawn since
};

/// Shapes of SVG as paths, in its frame (y down). Rounded corners as in SVG.
[[nodiscard]] CurvePath rectangle_path(const Point& corner, const Point& size, const Point& radii);
[[nodiscard]] CurvePath ellipse_path(const Point& centre, double rx, double ry);

}  // namespace lod2d
