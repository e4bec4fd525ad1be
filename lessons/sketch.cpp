#include "lessons/sketch.hpp"

#include <array>
#include <charconv>
#include <limits>

#include "core/error.hpp"
#include "lessons/source.hpp"

namespace lessons {

std::string shown(double value, int decimals) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    std::string text(buffer.data(), end);
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
    return unit.empty() ? number : number + "\u00a0" + unit;
}

Number number(double value, int decimals, const std::string& unit) {
    return {value, with_unit(shown(value, decimals), unit)};
}

std::string in_words(lod::Verdict verdict) {
    if (verdict == lod::Verdict::apart) return "apart";
    return verdict == lod::Verdict::possible ? "possible" : "true collision";
}

void add_step(Lesson& lesson, const std::string& title, const std::string& text, viz::Figure figure,
              const Named& numbers, const std::string& figure_name) {
    const std::string where = lesson.entry.slug + ", step '" + title + "'";
    const auto number_named = [&](const std::string& name) {
        const auto found = lesson.numbers.find(name);
        if (found == lesson.numbers.end())
            throw lod::Error(lod::ErrorKind::input_refused,
                             where + ": the lesson has no number '" + name + "'");
        return found->second;
    };
    Step step{title, {}, std::move(figure), {}};
    std::size_t end = 0;
    for (const Tag& tag : find_tags(text, where)) {
        if (tag.kind != "number")
            throw lod::Error(lod::ErrorKind::input_refused,
                             where + ": a step's text holds numbers only, not a " + tag.kind);
        step.text += text.substr(end, tag.begin - end) + number_named(tag.name).text;
        end = tag.end;
    }
    step.text += text.substr(end);
    for (const auto& [told, name] : numbers) step.numbers[told] = number_named(name);
    if (!figure_name.empty()) lesson.figures[figure_name] = step.figure;
    lesson.steps.push_back(std::move(step));
}

lod2d::Shape scaled(const lod2d::Shape& shape, double factor) {
    lod2d::Polygon polygon = shape.polygon;
    for (lod2d::Ring& ring : polygon.rings)
        for (lod2d::Point& p : ring) p *= factor;
    return lod2d::make_shape(shape.name, polygon);
}

std::vector<viz::Ring> rings_of(const lod2d::Polygon& polygon) {
    std::vector<viz::Ring> rings;
    for (const lod2d::Ring& ring : polygon.rings) {
        viz::Ring& drawn = rings.emplace_back();
        for (const lod2d::Point& p : ring) drawn.push_back(at(p));
    }
    return rings;
}

std::size_t edge_count(const lod2d::Polygon& polygon) {
    std::size_t edges = 0;
    for (const lod2d::Ring& ring : polygon.rings) edges += ring.size();
    return edges;
}

viz::Actor<2> actor(const std::string& name, const lod2d::Shape& shape,
                    std::shared_ptr<const lod::SphereTree<2>> tree) {
    viz::Actor<2> result;
    result.look = {name, rings_of(shape.polygon)};
    lod::set_mass(result.body, shape.area, lod::Inertia<2>::Constant(shape.second_moment));
    result.body.tree = std::move(tree);
    return result;
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

viz::Point at(const lod::Vector<2>& p) {
    return {p.x(), p.y()};
}

viz::Style style(viz::Role role, int body, int level) {
    return {role, body, level, 1};
}

void add_body(viz::Panel& panel, const viz::Actor<2>& actor, int index) {
    const viz::Role role = actor.body.is_static() ? viz::Role::wall : viz::Role::body;
    panel.marks.push_back(
        viz::Path{style(role, index), viz::carried(actor.body, actor.look.outline)});
}

void add_disc(viz::Panel& panel, const lod::Sphere<2>& disc, viz::Style style) {
    panel.marks.push_back(viz::Disc{style, at(disc.centre), disc.radius});
}

void add_dot(viz::Panel& panel, viz::Role role, const lod::Vector<2>& p, int body) {
    panel.marks.push_back(viz::Dot{style(role, body), at(p)});
}

void add_line(viz::Panel& panel, viz::Role role, const lod::Vector<2>& from,
              const lod::Vector<2>& to, int body) {
    panel.marks.push_back(viz::Polyline{style(role, body), {at(from), at(to)}, 1, {}});
}

void add_arrow(viz::Panel& panel, viz::Role role, const lod::Vector<2>& tail,
               const lod::Vector<2>& tip, const std::string& label, int body) {
    panel.marks.push_back(viz::Arrow{style(role, body), at(tail), at(tip), label});
}

void add_centres(viz::Panel& panel, const lod::Sphere<2>& a, const lod::Sphere<2>& b) {
    add_line(panel, viz::Role::construction, a.centre, b.centre);
    add_dot(panel, viz::Role::contact, a.centre);
    add_dot(panel, viz::Role::contact, b.centre);
    add_label(panel, viz::Role::note, a.centre, "*o*_a");
    add_label(panel, viz::Role::note, b.centre, "*o*_b");
}

void add_label(viz::Panel& panel, viz::Role role, const lod::Vector<2>& anchor,
               const std::string& text, int body, double clearance) {
    panel.marks.push_back(viz::Label{style(role, body), at(anchor), text, clearance});
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

viz::Figure figure_of(viz::Panel panel, std::string title, std::string alt) {
    viz::Figure figure;
    figure.aspect = page_aspect;
    figure.title = std::move(title);
    figure.alt = std::move(alt);
    figure.panels.push_back(std::move(panel));
    return figure;
}

}  // namespace lessons
