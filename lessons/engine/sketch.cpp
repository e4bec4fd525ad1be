#include "lessons/engine/sketch.hpp"

#include <array>
#include <charconv>
#include <limits>

#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/core/builder/protrusion.hpp"
#include "lodlab/viz/figure/number_text.hpp"

namespace lessons {

std::string shown(double value, int decimals) {
    std::string text = lod::number_text(value, std::chars_format::fixed, decimals);
    if (text.front() != '-') return text;
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    return (zero ? "" : "−") + text.substr(1);
}

std::string grouped(std::string digits) {
    constexpr std::size_t group = 3;
    constexpr std::size_t shortest = 5;  // 1000 reads well as it is
    if (digits.size() < shortest) return digits;
    for (std::size_t place = digits.size(); place > group; place -= group)
        digits.insert(place - group, "\u202f");
    return digits;
}

std::string with_unit(std::string number, const std::string& unit) {
    for (const char c : unit.empty() ? unit : " " + unit)
        if (c == ' ')
            number += "\u00a0";
        else
            number += c;
    return number;
}

Number number(double value, int decimals, const std::string& unit) {
    return {value, with_unit(shown(value, decimals), unit), unit};
}

Number tiny(double value, const std::string& unit) {
    if (value == 0) return number(value, 0, unit);
    const std::string text =
        lod::number_text(value, std::chars_format::scientific, 1);  // "2.2e-16"
    const std::size_t e = text.find('e');
    const std::string power = viz::superscript(std::stoi(text.substr(e + 1)));
    return {value, with_unit(text.substr(0, e) + "·10" + power, unit), unit};
}

std::string in_format(const Number& number, const Format& format) {
    const std::string& text = number.text;
    const std::string digits = format.digits < 0
                                   ? text.substr(0, text.size() - with_unit("", number.unit).size())
                                   : shown(number.value, format.digits);
    return with_unit(digits, format.unit ? number.unit : "");
}

Number words(std::string text, double value) {
    return {value, std::move(text), {}, false};
}

std::string in_words(lod::Verdict verdict) {
    if (verdict == lod::Verdict::apart) return "apart";
    return verdict == lod::Verdict::possible ? "possible" : "true collision";
}

lod2d::Shape scaled(const lod2d::Shape& shape, double factor) {
    lod2d::Polygon polygon = shape.polygon;
    for (lod2d::Ring& ring : polygon.rings)
        for (lod2d::Point& p : ring) p *= factor;
    return lod2d::make_shape(shape.name, polygon);
}

std::size_t edge_count(const lod2d::Polygon& polygon) {
    std::size_t edges = 0;
    for (const lod2d::Ring& ring : polygon.rings) edges += ring.size();
    return edges;
}

namespace {

template <int Dim>
viz::Actor<Dim> dressed(const std::string& name, viz::Visual<Dim> visual, double measure,
                        const lod::Inertia<Dim>& second_moment,
                        std::shared_ptr<const lod::SphereTree<Dim>> tree) {
    viz::Actor<Dim> result;
    result.visual = std::move(visual);
    result.visual.name = name;
    lod::set_mass<Dim>(result.body, measure, second_moment);
    result.body.tree = std::move(tree);
    return result;
}

}  // namespace

viz::Actor<2> actor(const std::string& name, const lod2d::Shape& shape,
                    std::shared_ptr<const lod::SphereTree<2>> tree) {
    const lod::Inertia<2> second_moment = lod::Inertia<2>::Constant(shape.second_moment);
    return dressed<2>(name, viz::visual_of(shape), shape.area, second_moment, std::move(tree));
}

viz::Actor<3> actor(const std::string& name, const lod3d::Solid& solid,
                    std::shared_ptr<const lod::SphereTree<3>> tree) {
    return dressed<3>(name, viz::visual_of(solid), solid.volume, solid.second_moment,
                      std::move(tree));
}

std::shared_ptr<const lod::SphereTree<2>> tree_of(const lod2d::Shape& shape, int depth,
                                                  lod2d::Builder builder) {
    lod2d::TreeSettings settings;
    settings.builder = builder;
    settings.depth = depth;
    return std::make_shared<const lod::SphereTree<2>>(lod2d::build_tree(shape, settings));
}

lod2d::BoundaryIndex outline_of(const lod2d::Shape& shape, const lod::Body<2>& body) {
    return lod2d::BoundaryIndex(shape.polygon).carried({body.position, body.orientation});
}

lod::Vector<2> corner_within(const viz::Actor<2>& actor, const lod2d::BoundaryIndex& other) {
    for (const viz::Ring& ring : viz::carried(actor.body, actor.visual.outline))
        for (const viz::Point& p : ring)
            if (other.inside({p.x, p.y})) return {p.x, p.y};
    return lod::Vector<2>::Zero();
}

viz::Point at(const lod::Vector<2>& p) {
    return {p.x(), p.y()};
}

viz::Style style(viz::Role role, int body, int level) {
    return {role, body, level, 1};
}

template <int Dim>
void add_ball(viz::Panel& panel, const lod::Sphere<Dim>& ball, viz::Style style) {
    viz::DrawTraits<Dim>::add_ball(panel, style, ball);
}

template <int Dim>
void add_dot(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& p, int body) {
    using Traits = viz::DrawTraits<Dim>;
    panel.marks.push_back(
        viz::Dot{style(role, body), Traits::on(panel, p), 1, Traits::depth(panel, p)});
}

template <int Dim>
void add_line(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& from,
              const lod::Vector<Dim>& to, int body) {
    const std::array<lod::Vector<Dim>, 2> ends{from, to};
    viz::add_line<Dim>(panel, style(role, body), ends, 1);
}

template <int Dim>
void add_arrow(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& tail,
               const lod::Vector<Dim>& tip, const std::string& label, int body) {
    viz::add_arrow<Dim>(panel, style(role, body), tail, tip, label);
}

template <int Dim>
void add_label(viz::Panel& panel, viz::Role role, const lod::Vector<Dim>& anchor,
               const std::string& text, int body, double clearance) {
    using Traits = viz::DrawTraits<Dim>;
    panel.marks.push_back(viz::Label{style(role, body), Traits::on(panel, anchor), text,
                                     clearance * Traits::magnification(panel, anchor)});
}

template <int Dim>
void add_centres(viz::Panel& panel, const lod::Sphere<Dim>& a, const lod::Sphere<Dim>& b) {
    add_line<Dim>(panel, viz::Role::construction, a.centre, b.centre);
    for (const lod::Vector<Dim>& centre : {a.centre, b.centre})
        add_dot<Dim>(panel, viz::Role::contact, centre);
    add_label<Dim>(panel, viz::Role::note, a.centre, "*o*_a");
    add_label<Dim>(panel, viz::Role::note, b.centre, "*o*_b");
}

void add_push(viz::Panel& panel, const lod::Vector<2>& point, const lod::Vector<2>& arrow) {
    add_dot(panel, viz::Role::contact, point);
    add_arrow(panel, viz::Role::impulse, point, point + arrow);
}

viz::Polyline curve(int series, const std::string& name) {
    return {style(viz::Role::curve, series), {}, 1, name};
}

void add_circles(viz::Panel& panel, const lod::Sphere<2>& a, const lod::Sphere<2>& b, bool meet) {
    const viz::Role role = meet ? viz::Role::meeting_node : viz::Role::level_node;
    add_ball(panel, a, style(role, 0, 0));
    add_ball(panel, b, style(role, 1, 0));
}

void add_sides(viz::Panel& panel, const lod::Vector<2>& a, const lod::Vector<2>& b,
               const std::string& across, const std::string& up) {
    const lod::Vector<2> corner(b.x(), a.y());
    add_line(panel, viz::Role::construction, a, corner);
    add_line(panel, viz::Role::construction, corner, b);
    add_label(panel, viz::Role::note, (a + corner) / 2, across);
    add_label(panel, viz::Role::note, (corner + b) / 2, up);
}

void add_piece(viz::Panel& panel, const lod2d::ConvexParts& parts, int index) {
    for (std::size_t part = 0; part < parts.count(); ++part) {
        viz::Ring ring;
        for (const lod2d::Point& corner : parts.part(part)) ring.push_back(at(corner));
        panel.marks.push_back(viz::Path{style(viz::Role::band, index), {ring}});
    }
}

double add_whisker(viz::Panel& panel, const lod2d::BoundaryIndex& outline,
                   std::span<const lod::Sphere<2>> discs, int body) {
    constexpr double tolerance = 1e-6;  // [m]
    const lod::Protrusion<2> out = lod::find_protrusion<2>(outline, discs, tolerance);
    const lod::Vector<2> foot = outline.nearest(out.at).point;
    const double length = (out.at - foot).norm();
    constexpr double beyond = 0.07;  // of the view's width: so that no circle crosses the words
    const double away = beyond * (panel.view.high.x - panel.view.low.x);
    add_line(panel, viz::Role::curve, foot, out.at, body);
    add_dot(panel, viz::Role::contact, out.at);
    add_label(panel, viz::Role::body, out.at + away * (out.at - foot).stableNormalized(),
              shown(length, 2) + " m", body);
    return length;
}

viz::Box box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, top}};
}

viz::Box box_round(const std::vector<lod::Sphere<2>>& discs) {
    constexpr double far = std::numeric_limits<double>::infinity();
    viz::Box round{{far, far}, {-far, -far}};
    for (const lod::Sphere<2>& disc : discs) {
        const double r = disc.radius;
        round = viz::united(round, {{disc.centre.x() - r, disc.centre.y() - r},
                                    {disc.centre.x() + r, disc.centre.y() + r}});
    }
    return round;
}

std::string pairs_text(std::size_t pairs) {
    return shown_count(pairs) + (pairs == 1 ? " pair" : " pairs");
}

void name_levels(viz::Figure& figure, const std::vector<lod::Front>& fronts) {
    for (std::size_t level = 0; level < figure.panels.size(); ++level) {
        const std::size_t pairs = fronts[level].pairs.size();
        figure.panels[level].title = "Level " + std::to_string(level) + ": " +
                                     (pairs == 0 ? "none, apart" : pairs_text(pairs));
    }
    figure.numbers = {{"tests", shown_count(fronts.back().tests)},
                      {"verdict", in_words(fronts.back().verdict)}};
}

viz::Figure figure_of(viz::Panel panel) {
    viz::Figure figure;
    figure.aspect = page_aspect;
    figure.panels.push_back(std::move(panel));
    return figure;
}

live::Scene to_play_with(std::vector<viz::Actor<2>> actors, const viz::Box& view, live::Told told) {
    live::Scene scene;
    scene.actors = std::move(actors);
    scene.view = view;
    scene.told = told;
    return scene;
}

#define LESSONS_MARKS(Dim)                                                            \
    template void add_ball(viz::Panel&, const lod::Sphere<Dim>&, viz::Style);         \
    template void add_dot<Dim>(viz::Panel&, viz::Role, const lod::Vector<Dim>&, int); \
    template void add_line<Dim>(viz::Panel&, viz::Role, const lod::Vector<Dim>&,      \
                                const lod::Vector<Dim>&, int);                        \
    template void add_arrow<Dim>(viz::Panel&, viz::Role, const lod::Vector<Dim>&,     \
                                 const lod::Vector<Dim>&, const std::string&, int);   \
    template void add_label<Dim>(viz::Panel&, viz::Role, const lod::Vector<Dim>&,     \
                                 const std::string&, int, double);                    \
    template void add_centres(viz::Panel&, const lod::Sphere<Dim>&, const lod::Sphere<Dim>&);

LESSONS_MARKS(2)
LESSONS_MARKS(3)
#undef LESSONS_MARKS

}  // namespace lessons
