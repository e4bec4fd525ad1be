#pragma once

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lessons/embed/source.hpp"
#include "lessons/engine/lessons.hpp"
#include "lodlab/core/tree/body.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/live/scene.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/convex_parts.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/shape/shape.hpp"
#include "lodlab/lod3d/solid/solid.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"

// Words and marks that lessons share.
namespace lessons {

/// A number as a reader sees it: so many decimals, a true minus sign, no "-0".
[[nodiscard]] std::string shown(double value, int decimals);
/// The number and its unit if it has one, their spaces such that no line breaks there.
[[nodiscard]] std::string with_unit(std::string number, const std::string& unit);
/// Digits with thin spaces between thousands.
[[nodiscard]] std::string grouped(std::string digits);
/// A count, with thin spaces between thousands.
[[nodiscard]] std::string shown_count(std::integral auto count) {
    return grouped(std::to_string(count));
}
/// The number and its words: "0.31 m".
[[nodiscard]] Number number(double value, int decimals, const std::string& unit = "");
[[nodiscard]] Number count(std::integral auto value, const std::string& unit = "") {
    return {static_cast<double>(value), with_unit(shown_count(value), unit), unit};
}

/// A number that may be very small, as a power of ten: "2.2·10⁻¹⁶ m".
[[nodiscard]] Number tiny(double value, const std::string& unit = "");

/// The number in another format than its own.
[[nodiscard]] std::string in_format(const Number& number, const Format& format);

/// What is said in words; `value` for those who compare.
[[nodiscard]] Number words(std::string text, double value = 0);

/// "(0.560, −0.277, 0.000)".
template <int Dim>
[[nodiscard]] std::string vector_text(const lod::Vector<Dim>& v, int decimals = 3) {
    std::string text;
    for (int axis = 0; axis < Dim; ++axis)
        text += (axis == 0 ? "(" : ", ") + shown(v[axis], decimals);
    return text + ")";
}

/// "apart", "possible", "true collision".
[[nodiscard]] std::string in_words(lod::Verdict verdict);

/// The shape at another size.
[[nodiscard]] lod2d::Shape scaled(const lod2d::Shape& shape, double factor);
/// Sides of its outline.
[[nodiscard]] std::size_t edge_count(const lod2d::Polygon& polygon);

/// A body of density 1 with a picture's look; its tree may come later.
[[nodiscard]] viz::Actor<2> actor(const std::string& name, const lod2d::Shape& shape,
                                  std::shared_ptr<const lod::SphereTree<2>> tree = nullptr);
[[nodiscard]] viz::Actor<3> actor(const std::string& name, const lod3d::Solid& solid,
                                  std::shared_ptr<const lod::SphereTree<3>> tree = nullptr);

/// A circle tree of the shape, with four children a node.
[[nodiscard]] std::shared_ptr<const lod::SphereTree<2>> tree_of(
    const lod2d::Shape& shape, int depth, lod2d::Builder builder = lod2d::Builder::pieces);

/// The shape's boundary where the body stands, for exact questions.
[[nodiscard]] lod2d::BoundaryIndex outline_of(const lod2d::Shape& shape, const lod::Body<2>& body);

/// The first corner of the body's outline that lies within another's; 0 where there is none.
[[nodiscard]] lod::Vector<2> corner_within(const viz::Actor<2>& actor,
                                           const lod2d::BoundaryIndex& other);

[[nodiscard]] viz::Point at(const lod::Vector<2>& p);
[[nodiscard]] viz::Style style(viz::Role role, int body = 0, int level = -1);

// Marks in the plane, and in space (add_dot<3>) as the panel's camera sees them: the panel's scene
// must be there, and its camera too.

template <int Dim = 2>
void add_ball(viz::Panel& panel, const lod::Sphere<Dim>& ball, viz::Style style);
template <int Dim = 2>
void add_dot(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& p, int body = 0);
template <int Dim = 2>
void add_line(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& from,
              const lod::Vector<Dim>& to, int body = 0);
template <int Dim = 2>
void add_arrow(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& tail,
               const lod::Vector<Dim>& tip, const std::string& label = "", int body = 0);
/// `clearance` in metres at the anchor.
template <int Dim = 2>
void add_label(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& anchor,
               const std::string& text, int body = 0, double clearance = 0);
/// The centre line of two balls; the centres are o_a and o_b.
template <int Dim = 2>
void add_centres(viz::Panel& panel, const lod::Sphere<Dim>& a, const lod::Sphere<Dim>& b);

/// A contact point with the arrow of its impulse.
void add_push(viz::Panel& panel, const lod::Vector<2>& point, const lod::Vector<2>& arrow);
/// A curve of a plot, without its points.
[[nodiscard]] viz::Polyline curve(int series, const std::string& name);

/// Circles of bodies 0 and 1, bold where they meet.
void add_circles(viz::Panel& panel, const lod::Sphere<2>& a, const lod::Sphere<2>& b, bool meet);
/// The way from a to b, first across, then up, with a word beside each part.
void add_sides(viz::Panel& panel, const lod::Vector<2>& a, const lod::Vector<2>& b,
               const std::string& across, const std::string& up);

/// A piece of a shape, filled in the ink of body `index`.
void add_piece(viz::Panel& panel, const lod2d::ConvexParts& parts, int index);
/// A line from where discs stand out furthest to the outline, with its length, which it gives [m].
double add_whisker(viz::Panel& panel, const lod2d::BoundaryIndex& outline,
                   std::span<const lod::Sphere<2>> discs, int body);

[[nodiscard]] viz::Box box(double left, double bottom, double right, double top);

/// The box round discs.
[[nodiscard]] viz::Box box_round(const std::vector<lod::Sphere<2>>& discs);

/// Width over height of a lesson's picture: words come out larger on a page than at 16 to 9.
constexpr double page_aspect = 4.0 / 3;

/// "1 pair", "4 pairs".
[[nodiscard]] std::string pairs_text(std::size_t pairs);

/// Says above each panel of a traversal, one a level, how many pairs its front has, and beside the
/// title what it cost and found.
void name_levels(viz::Figure& figure, const std::vector<lod::Front>& fronts);

/// A figure of one panel.
[[nodiscard]] viz::Figure figure_of(viz::Panel panel);

/// Bodies for readers to play with, without a budget.
[[nodiscard]] live::Scene to_play_with(std::vector<viz::Actor<2>> actors, const viz::Box& view,
                                       live::Told told = live::Told::answers);

}  // namespace lessons
