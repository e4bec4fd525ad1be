#include "lodlab/lod2d/source/svg/plain.hpp"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <unordered_map>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/source/svg/style.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

enum class Role { container, shape, unread, inert, other };

/// What the plain reader makes of an element of SVG.
Role role_of(std::string_view tag) {
    const auto is = [tag](std::initializer_list<std::string_view> tags) {
        return std::ranges::find(tags, tag) != tags.end();
    };
    if (is({"g", "a", "svg"})) return Role::container;
    if (is({"path", "rect", "circle", "ellipse", "line", "polygon", "polyline"}))
        return Role::shape;
    if (is({"text", "image", "foreignObject"})) return Role::unread;
    // Nothing draws what these hold: what refers to them is not plain, but for gradients.
    if (is({"title", "desc", "metadata", "defs", "linearGradient", "radialGradient", "symbol",
            "clipPath", "mask", "pattern", "marker", "filter", "view", "cursor", "script"}))
        return Role::inert;
    return Role::other;
}

/// Walks the elements in the order in which they are drawn.
class PlainWalk {
  public:
    PlainWalk(const SvgXml& xml, const SvgSettings& settings) : xml_(xml), settings_(settings) {
        for (xml_node node = xml.root(); node; node = next(node))
            if (const auto id = node.attribute("id")) by_id_.emplace(id.value(), node);
    }

    /// Whether all of it is plain.
    bool check();
    SvgDrawing read();

  private:
    [[nodiscard]] xml_node next(xml_node node) const;
    [[nodiscard]] std::optional<SvgGradient> gradient_paint(std::string_view id) const;
    [[nodiscard]] std::optional<SvgStyle> style_of(const xml_node& node,
                                                   const SvgStyle& parent) const;
    bool check(const xml_node& node, const SvgStyle& parent) const;
    void draw(const xml_node& node, const Affine& outer, const SvgStyle& parent, int depth);
    void draw_shape(const xml_node& node, const Affine& frame, const SvgStyle& style);
    [[nodiscard]] CurvePath path_of(const xml_node& node, std::string_view tag) const;
    void set_page();

    const SvgXml& xml_;
    const SvgSettings& settings_;
    std::unordered_map<std::string, xml_node> by_id_;
    std::size_t elements_ = 0;
    SvgPage page_ = svg_page_of(xml_);
    Point percent_of_ = page_.percent_of().value_or(Point(100, 100));
    SvgDrawing drawing_;
};

/// The node after this one in the text, of the whole document.
xml_node PlainWalk::next(xml_node node) const {
    if (node.first_child()) return node.first_child();
    while (node && node != xml_.root() && !node.next_sibling()) node = node.parent();
    return node == xml_.root() ? xml_node() : node.next_sibling();
}

std::optional<SvgGradient> PlainWalk::gradient_paint(std::string_view id) const {
    std::string of(id);
    std::string units;
    std::optional<SvgPaint> paint;  // by the first that has stops
    for (int links = 0; links < 20; ++links) {
        const auto found = by_id_.find(of);
        if (found == by_id_.end()) return std::nullopt;
        const xml_node& node = found->second;
        const std::string_view tag = local_name(node.name());
        if (tag != "linearGradient" && tag != "radialGradient") return std::nullopt;
        const std::string link = svg_link(node);
        if (units.empty()) units = node.attribute("gradientUnits").value();
        if (node.child("stop")) paint = paint ? paint : plain_stops(node);
        if (node.child("stop") && !paint) return std::nullopt;
        if (link.empty())
            return SvgGradient{paint.value_or(SvgPaint::none), units != "userSpaceOnUse"};
        if (!link.starts_with('#')) return std::nullopt;
        of = link.substr(1);
    }
    return std::nullopt;
}

std::optional<SvgStyle> PlainWalk::style_of(const xml_node& node, const SvgStyle& parent) const {
    return plain_style(node, parent, [this](std::string_view id) { return gradient_paint(id); });
}

/// Of a font, a window, or computed; millimetres, too, in quarters.
bool is_relative_unit(const std::string& unit) {
    return unit.starts_with("calc") ||
           is_one_of(unit, {"em",  "ex",  "ch",  "rem", "ic",   "cap",  "lh",  "rlh", "q",
                            "vw",  "vh",  "vi",  "vb",  "vmin", "vmax", "svw", "svh", "lvw",
                            "lvh", "dvw", "dvh", "rex", "rch",  "ric",  "rcap"});
}

bool has_relative_lengths(const xml_node& node, bool percentages_too) {
    for (const char* name :
         {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height", "x1", "y1", "x2", "y2"}) {
        const std::string_view text = node.attribute(name).value();
        if (text.ends_with('%') && (percentages_too || name[0] == 'r')) return true;
        const std::size_t at = text.find_first_not_of("+-.0123456789 ");
        if (at == std::string_view::npos) continue;
        const std::string unit = lower(text.substr(at));
        const bool known = is_one_of(unit, {"px", "pt", "pc", "mm", "cm", "in"});
        if (known ? unit != text.substr(at) : is_relative_unit(unit)) return true;
    }
    return false;
}

bool PlainWalk::check(const xml_node& node, const SvgStyle& parent) const {
    const Role role = role_of(local_name(node.name()));
    if (role == Role::inert) return true;
    if (role == Role::other || (local_name(node.name()) == "svg" && node != xml_.root()))
        return false;
    const auto style = style_of(node, parent);
    if (!style) return false;
    if (role == Role::shape && has_relative_lengths(node, !page_.percent_of())) return false;
    if (role == Role::unread) return true;
    for (const xml_node& child : node.children())
        if (child.type() == pugi::node_element && is_svg_element(child) && !check(child, *style))
            return false;
    return true;
}

bool PlainWalk::check() {
    if (xml_.source.find("<?xml-stylesheet") != std::string::npos) return false;
    for (xml_node node = xml_.root(); node; node = next(node))
        if (local_name(node.name()) == "style" && is_svg_element(node)) return false;
    const std::string_view aspect = xml_.root().attribute("preserveAspectRatio").value();
    return (aspect.empty() || aspect == "xMidYMid" || aspect == "xMidYMid meet") &&
           check(xml_.root(), {});
}

CurvePath PlainWalk::path_of(const xml_node& node, std::string_view tag) const {
    const double diagonal = percent_of_.norm() / std::sqrt(2.0);
    const auto length = [&](const char* name, double percent_of) {
        return svg_length_of(xml_, node, name, percent_of);
    };
    const auto x = [&](const char* name) { return length(name, percent_of_.x()).value_or(0); };
    const auto y = [&](const char* name) { return length(name, percent_of_.y()).value_or(0); };
    if (tag == "path") return svg_path_of(xml_, node);
    if (tag == "rect") {
        const double width = x("width");
        const double height = y("height");
        if (!(width > 0 && height > 0)) return {};
        const double rx = length("rx", percent_of_.x()).value_or(-1);
        const double ry = length("ry", percent_of_.y()).value_or(-1);
        return rectangle_path({x("x"), y("y")}, {width, height},
                              {std::max(0.0, rx < 0 ? ry : rx), std::max(0.0, ry < 0 ? rx : ry)});
    }
    if (tag == "circle") {
        const double r = length("r", diagonal).value_or(0);
        return r > 0 ? ellipse_path({x("cx"), y("cy")}, r, r) : CurvePath();
    }
    if (tag == "ellipse") {
        const double rx = length("rx", percent_of_.x()).value_or(-1);
        const double ry = length("ry", percent_of_.y()).value_or(-1);
        if (!(std::max(rx, ry) > 0) || rx == 0 || ry == 0) return {};
        return ellipse_path({x("cx"), y("cy")}, rx < 0 ? ry : rx, ry < 0 ? rx : ry);
    }
    CurvePath path;
    if (tag == "line") {
        path.move_to({x("x1"), y("y1")});
        path.line_to({x("x2"), y("y2")});
        return path;
    }
    const std::vector<Point> points = svg_points_of(xml_, node);
    for (std::size_t i = 0; i < points.size(); ++i)
        i == 0 ? path.move_to(points[i]) : path.line_to(points[i]);
    if (tag == "polygon" && !points.empty()) path.close();
    return path;
}

void PlainWalk::draw_shape(const xml_node& node, const Affine& frame, const SvgStyle& style) {
    if (!style.visible) return;
    const bool filled = style.fill != SvgPaint::none && style.fill_seen;
    bool stroked = style.stroke != SvgPaint::none && style.stroke_seen && style.pen.width > 0;
    if (!filled && !stroked) return;
    CurvePath path = path_of(node, local_name(node.name()));
    if (path.empty()) return;
    const Point size = path.control_box().size();
    if (style.stroke_by_box && (size.x() == 0 || size.y() == 0)) stroked = false;
    CurvePath pen_path = path;
    path.transform(frame);
    if (!path.finite() || !pen_path.finite())
        xml_.refuse(node, "<" + std::string(node.name()) +
                              "> has a coordinate that is not finite or beyond 1e60; check its "
                              "numbers");
    const bool may_enclose = std::ranges::any_of(
        path.subpaths(), [](const CurvePath::Subpath& sub) { return sub.points.size() >= 3; });
    const bool fills = filled && may_enclose && local_name(node.name()) != "line";
    const bool fading =
        (fills && style.fill == SvgPaint::fading) || (stroked && style.stroke == SvgPaint::fading);
    SvgNotes::count(drawing_.notes.whole, "gradient that fades to nothing",
                    "gradients that fade to nothing", fading);
    if (stroked) drawing_.strokes.push_back({std::move(pen_path), style.pen, frame, fills, {}});
    if (!fills) return;
    path.drop_dots();
    drawing_.fills.push_back({{std::move(path), style.rule}, {}});
}

void PlainWalk::draw(const xml_node& node, const Affine& outer, const SvgStyle& parent, int depth) {
    const std::string_view tag = local_name(node.name());
    const Role role = role_of(tag);
    if (role == Role::inert) return;
    lod::check_interrupted();
    if (++elements_ > settings_.most_elements)
        xml_.refuse(node,
                    "it draws more than " + std::to_string(settings_.most_elements) +
                        " elements; simplify it or raise the limit",
                    lod::ErrorKind::limit_exceeded);
    if (depth > settings_.most_depth)
        xml_.refuse(node,
                    "its elements are nested deeper than " + std::to_string(settings_.most_depth) +
                        "; simplify it or raise the limit",
                    lod::ErrorKind::limit_exceeded);
    const SvgStyle style = style_of(node, parent).value_or(parent);
    if (!style.drawn) return;
    if (role == Role::unread) {
        const bool empty = tag == "text" && !node.first_child();
        if (style.visible && !empty)
            SvgNotes::count(drawing_.notes.left_out, std::string(tag), std::string(tag) + "s");
        return;
    }
    Affine frame = outer;
    if (node.attribute("transform")) frame = frame * svg_transform_of(xml_, node);
    if (role == Role::shape) return draw_shape(node, frame, style);
    for (const xml_node& child : node.children())
        if (child.type() == pugi::node_element && is_svg_element(child))
            draw(child, frame, style, depth + 1);
}

/// A browser shows the view box and what of its window is left beside it, in the middle.
void PlainWalk::set_page() {
    Point low = Point::Zero();
    if ((!page_.size && !page_.view_box) || xml_.root().attribute("transform")) return;
    Point size = page_.size.value_or(Point::Zero());
    if (page_.view_box) {
        const auto& box = *page_.view_box;
        const Point inner(box[2], box[3]);
        if (page_.size)
            size /= std::min(size.x() / inner.x(), size.y() / inner.y());
        else
            size = inner;
        low = Point(box[0], box[1]) - (size - inner) / 2;
    }
    Box page;
    page.hold({low.x(), -low.y()});
    page.hold({low.x() + size.x(), -(low.y() + size.y())});
    drawing_.page = page;
}

SvgDrawing PlainWalk::read() {
    draw(xml_.root(), Affine::scaling(1, -1), {}, 0);
    set_page();
    drawing_.plain = true;
    for (xml_node node = xml_.root(); node; node = next(node))
        if (local_name(node.name()) == "script" && is_svg_element(node))
            SvgNotes::count(drawing_.notes.left_out, "script", "scripts");
    return std::move(drawing_);
}

}  // namespace

std::optional<SvgDrawing> read_plain_svg(const SvgXml& xml, const SvgSettings& settings) {
    PlainWalk walk(xml, settings);
    if (!walk.check()) return std::nullopt;
    return walk.read();
}

}  // namespace lod2d
