#pragma once

/// \file
/// What separates pictures of the plane from pictures of space: viewpoints, views, outlines.

#include <optional>
#include <string>

#include "lodlab/core/tree/body.hpp"
#include "lodlab/viz/figure/camera.hpp"

namespace viz {

/// All that separates pictures of the plane from pictures of space, as a table for each: how a
/// body's outline is kept, what panels show of the world and from where, and how outlines and balls
/// are put into a panel. Drawings are written once over it.
template <int Dim>
struct DrawTraits;

/// From where space is seen.
struct Viewpoint {
    std::optional<double> azimuth;  ///< see orbit [rad]; nothing: what moves, moves across
    double elevation = 0.42;        ///< above the ground [rad]
    bool perspective = false;       ///< for showing; orthographic for comparing
};

/// The plane has one viewpoint only.
struct FlatViewpoint {};

/// The part of the plane that panels show.
class FlatView {
  public:
    /// Shows nothing yet.
    explicit FlatView(const FlatViewpoint& = {}, const lod::Vector<2>& = lod::Vector<2>::Zero()) {}
    /// Widens the view until it shows all that is no further from a point [m].
    void take_in(const lod::Vector<2>& point, double reach);
    /// Widens the view until it shows what another shows.
    void unite(const FlatView& other);
    /// What is to be seen.
    [[nodiscard]] Box box() const { return box_; }

  private:
    Box box_ = empty_box();
    static Box empty_box();
};

/// The part of space that panels show, and the camera that shows all of it.
class SpaceView {
  public:
    /// `along`: which way things move or lie; the view is taken across it unless the viewpoint has
    /// an azimuth. Zero: no such way.
    explicit SpaceView(const Viewpoint& viewpoint = {},
                       const lod::Vector<3>& along = lod::Vector<3>::Zero());
    /// Widens the view until it shows all that is no further from a point [m].
    void take_in(const lod::Vector<3>& point, double reach);
    /// Requires: the same viewpoint and way.
    void unite(const SpaceView& other);
    /// The camera that shows all of it.
    [[nodiscard]] Camera camera() const;
    /// What is to be seen, on the camera's panel.
    [[nodiscard]] Box box() const;
    /// A ground a little below all that was taken in.
    [[nodiscard]] Ground ground() const;

  private:
    [[nodiscard]] lod::Vector<3> place(const lod::Vector<3>& seen) const;
    [[nodiscard]] double size() const;

    Camera direction_;  ///< looks the right way, at the origin
    CameraAxes axes_;
    lod::Vector<3> low_;  ///< along the camera's axes [m]
    lod::Vector<3> high_;
    double lowest_;  ///< y [m]
};

/// Pictures of the plane.
template <>
struct DrawTraits<2> {
    using Outline = std::vector<Ring>;  ///< with holes, body frame [m]; empty: leaves are drawn
    using Viewpoint = FlatViewpoint;    ///< from where
    using View = FlatView;              ///< of what
    static constexpr const char* ball_word = "circle";
    static constexpr const char* solid_word = "shape";
    static constexpr const char* outline_word = "outline";
    static constexpr double see_through = 1;  ///< opacity of a body whose inside matters

    /// Whether there is an outline to draw.
    [[nodiscard]] static bool shown(const Outline& outline) { return !outline.empty(); }
    /// An empty panel that shows a view.
    [[nodiscard]] static Panel panel(const View& view);
    /// Where a point of the world lies on a panel.
    [[nodiscard]] static Point on(const Panel&, const lod::Vector<2>& v) { return {v.x(), v.y()}; }
    /// How far in front of the eye [m].
    [[nodiscard]] static double depth(const Panel&, const lod::Vector<2>&) { return in_front; }
    /// How much larger a metre shows there than at the camera's target.
    [[nodiscard]] static double magnification(const Panel&, const lod::Vector<2>&) { return 1; }
    /// Draws an outline where its body stands.
    static void add_outline(Panel& panel, const Style& style, const Outline& outline,
                            const lod::Body<2>& body);
    /// Its outline, as far as the panel reaches.
    static void add_half_space(Panel& panel, const Style& style, const Outline& outline,
                               const lod::Body<2>& body);
    /// Draws a ball of the world.
    static void add_ball(Panel& panel, const Style& style, const lod::Sphere<2>& ball);
    /// What casts its shadow on the ground.
    static void add_shadow(Panel&, const lod::Body<2>&) {}
    /// Points of the body frame that reach furthest out.
    [[nodiscard]] static std::vector<lod::Vector<2>> points_of(const Outline& outline);
    /// The distance between two outlines where the bodies stand [m]: 0 where they overlap, negative
    /// where it is not known.
    [[nodiscard]] static double gap(const Outline& a, const lod::Body<2>& body_a, const Outline& b,
                                    const lod::Body<2>& body_b);
    /// The orientation that share of the way from one to the next.
    [[nodiscard]] static double between(double from, double to, double share);
    /// A spin as one number [rad/s].
    [[nodiscard]] static double amount(const lod::Spin<2>& spin) { return spin[0]; }
};

/// Pictures of space.
template <>
struct DrawTraits<3> {
    using Outline = std::shared_ptr<const Surface>;  ///< body frame [m]; null: leaves are drawn
    /// As in DrawTraits<2>.
    /// @{
    using Viewpoint = viz::Viewpoint;
    using View = SpaceView;
    /// @}
    static constexpr const char* ball_word = "sphere";
    static constexpr const char* solid_word = "solid";
    static constexpr const char* outline_word = "surface";
    static constexpr double see_through = 0.35;

    /// As in DrawTraits<2>.
    /// @{
    [[nodiscard]] static bool shown(const Outline& outline) { return outline != nullptr; }
    [[nodiscard]] static Panel panel(const View& view);
    [[nodiscard]] static Point on(const Panel& panel, const lod::Vector<3>& v);
    [[nodiscard]] static double depth(const Panel& panel, const lod::Vector<3>& v);
    [[nodiscard]] static double magnification(const Panel& panel, const lod::Vector<3>& v);
    static void add_outline(Panel& panel, const Style& style, const Outline& outline,
                            const lod::Body<3>& body);
    /// A level floor is where the ground lies; other walls are not drawn: they would hide the
    /// scene.
    static void add_half_space(Panel& panel, const Style& style, const Outline& outline,
                               const lod::Body<3>& body);
    static void add_ball(Panel& panel, const Style& style, const lod::Sphere<3>& ball);
    static void add_shadow(Panel& panel, const lod::Body<3>& body);
    [[nodiscard]] static std::vector<lod::Vector<3>> points_of(const Outline& outline);
    [[nodiscard]] static double gap(const Outline& a, const lod::Body<3>& body_a, const Outline& b,
                                    const lod::Body<3>& body_b);
    [[nodiscard]] static lod::Quaternion between(const lod::Quaternion& from,
                                                 const lod::Quaternion& to, double share);
    [[nodiscard]] static double amount(const lod::Spin<3>& spin) { return spin.norm(); }
    /// @}
};

/// What panels show of so many dimensions.
template <int Dim>
using View = typename DrawTraits<Dim>::View;

}  // namespace viz
