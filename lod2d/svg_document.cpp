#include "lodlab/lod2d/svg_document.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <unordered_map>

#include "lodlab/core/error.hpp"
#include "lodlab/lod2d/svg_style.hpp"
#include "lodlab/lod2d/svg_text.hpp"

namespace lod2d {
namespace {

using pugi::xml_node;

/// "line 3, column 7" of a byte.
std::string place_in(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t last_break = before.rfind('\n');
    const std::size_t column =
        last_break == std::string_view::npos ? offset + 1 : offset - last_break;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Walks the elements in the order in which they are drawn.
class SvgWalk {
  public:
    SvgWalk(const std::string& name, std::string_view text, const SvgSettings& settings)
        : name_(name), text_(text), settings_(settings) {}

    SvgDrawing read();

  private:
    [[noreturn]] void refuse(lod::ErrorKind kind, const xml_node& at, const std::string& why) const;
    void parse_xml();
    void check_format() const;
    void collect_ids_and_styles();
    void draw(const xml_node& node, const Affine& outer, const SvgStyle& parent, int depth);
    void draw_children(const xml_node& node, const Affine& frame, const SvgStyle& style, int depth);
    void draw_switch(const xml_node& node, const Affine& frame, const SvgStyle& style, int depth);
    void draw_use(const xml_node& node, const Affine& frame, const SvgStyle& style, int depth);
    void draw_shape(const xml_node& node, const Affine& frame, const SvgStyle& style);
    [[nodiscard]] Affine view_box_frame(const xml_node& node, const xml_node& placed) const;
    [[nodiscard]] CurvePath path_of(const xml_node& node, std::string_view tag) const;
    [[nodiscard]] double length(const xml_node& node, const char* attribute, double otherwise,
                                double percent_of) const;
    template <typename Parse>
    auto parsed(const xml_node& node, const char* attribute, Parse parse) const
        -> decltype(parse(std::string_view()));

    const std::string& name_;
    std::string_view text_;
    const SvgSettings& settings_;
    pugi::xml_document document_;
    SvgStyleSheet sheet_;
    std::unordered_map<std::string, xml_node> by_id_;
    std::vector<xml_node> in_use_;  ///< targets of the `use` elements being drawn
    double width_ = 100;            ///< of the outermost view box: what percentages refer to
    double height_ = 100;
    std::size_t elements_ = 0;
    std::size_t texts_ = 0;
    std::size_t images_ = 0;
    SvgDrawing drawing_;
};

void SvgWalk::refuse(lod::ErrorKind kind, const xml_node& at, const std::string& why) const {
    const auto offset = at.offset_debug();
    const std::string place =
        offset < 0 ? "" : ", " + place_in(text_, static_cast<std::size_t>(offset));
    throw lod::Error(kind, "cannot read " + name_ + place + ": " + why);
}

void SvgWalk::check_format() const {
    const auto refuse_file = [&](const char* why) {
        throw lod::Error(lod::ErrorKind::input_refused, "cannot read " + name_ + ": " + why);
    };
    if (text_.empty()) refuse_file("the file is empty");
    if (text_.starts_with("\x1f\x8b")) refuse_file("it is compressed; unpack it with gunzip first");
    if (text_.find('<') == std::string_view::npos) refuse_file("it is no SVG file");
}

void SvgWalk::parse_xml() {
    check_format();
    const pugi::xml_parse_result result = document_.load_buffer(
        text_.data(), text_.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!result) {
        const auto offset =
            std::clamp(static_cast<std::size_t>(std::max(result.offset, std::ptrdiff_t{0})),
                       std::size_t{0}, text_.size());
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot read " + name_ + ", " + place_in(text_, offset) +
                             ": broken XML: " + result.description());
    }
    if (local_name(document_.document_element().name()) != "svg")
        refuse(lod::ErrorKind::input_refused, document_.document_element(),
               "the outermost element is not <svg>; give an SVG file");
}

void SvgWalk::collect_ids_and_styles() {
    const xml_node root = document_.document_element();
    for (xml_node node = root; node;) {
        if (const auto id = node.attribute("id")) by_id_.emplace(id.value(), node);
        if (local_name(node.name()) == "style")
            for (const xml_node& text : node.children()) sheet_.read(text.value());
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node && node != root && !node.next_sibling()) node = node.parent();
        node = node == root ? xml_node() : node.next_sibling();
    }
}

template <typename Parse>
auto SvgWalk::parsed(const xml_node& node, const char* attribute, Parse parse) const
    -> decltype(parse(std::string_view())) {
    try {
        return parse(std::string_view(node.attribute(attribute).value()));
    } catch (const SvgTextError& error) {
        refuse(lod::ErrorKind::input_refused, node,
               "<" + std::string(node.name()) + "> has a broken " + attribute + ": expected " +
                   error.expected + " after " + std::to_string(error.place) + " characters");
    }
}

double SvgWalk::length(const xml_node& node, const char* attribute, double otherwise,
                       double percent_of) const {
    const std::string_view text = node.attribute(attribute).value();
    if (text.empty() || text == "auto") return otherwise;
    return parsed(node, attribute,
                  [&](std::string_view value) { return parse_svg_length(value, percent_of); });
}

/// Where the contents of a nested <svg> or a <symbol> stand: their view box, as large as fits,
/// in the middle of the place that `placed` gives them (preserveAspectRatio as by default).
Affine SvgWalk::view_box_frame(const xml_node& node, const xml_node& placed) const {
    if (!node.attribute("viewBox")) return {};
    const auto box = parsed(node, "viewBox", parse_svg_view_box);
    if (!(box[2] > 0 && box[3] > 0)) return {};
    const double width = length(placed, "width", length(node, "width", width_, width_), width_);
    const double height =
        length(placed, "height", length(node, "height", height_, height_), height_);
    const double scale = std::min(width / box[2], height / box[3]);
    return Affine::translation({(width - scale * box[2]) / 2, (height - scale * box[3]) / 2}) *
           Affine::scaling(scale, scale) * Affine::translation({-box[0], -box[1]});
}

CurvePath SvgWalk::path_of(const xml_node& node, std::string_view tag) const {
    const auto x = [&](const char* name) { return length(node, name, 0, width_); };
    const auto y = [&](const char* name) { return length(node, name, 0, height_); };
    if (tag == "path") return parsed(node, "d", parse_svg_path);
    if (tag == "rect") {
        const double width = x("width");
        const double height = y("height");
        if (!(width > 0 && height > 0)) return {};
        const double rx = length(node, "rx", -1, width_);
        const double ry = length(node, "ry", -1, height_);
        return rectangle_path(x("x"), y("y"), width, height, std::max(0.0, rx < 0 ? ry : rx),
                              std::max(0.0, ry < 0 ? rx : ry));
    }
    if (tag == "circle" || tag == "ellipse") {
        const double rx = x(tag == "circle" ? "r" : "rx");
        const double ry = tag == "circle" ? rx : y("ry");
        if (!(rx > 0 && ry > 0)) return {};
        return ellipse_path({x("cx"), y("cy")}, rx, ry);
    }
    CurvePath path;
    if (tag == "line") {
        path.move_to({x("x1"), y("y1")});
        path.line_to({x("x2"), y("y2")});
        return path;
    }
    const std::vector<Point> points = parsed(node, "points", parse_svg_points);
    for (std::size_t i = 0; i < points.size(); ++i)
        i == 0 ? path.move_to(points[i]) : path.line_to(points[i]);
    if (tag == "polygon") path.close();
    return path;
}

void SvgWalk::draw_shape(const xml_node& node, const Affine& frame, const SvgStyle& style) {
    if (!style.visible) return;
    const bool filled = style.filled && style.fill_seen;
    const bool stroked = style.stroked && style.stroke_seen && style.stroke_width > 0;
    if (!filled && !stroked) return;
    CurvePath path = path_of(node, local_name(node.name()));
    if (path.empty()) return;
    if (stroked) drawing_.strokes.push_back({path, style.stroke_width, frame});
    path.transform(frame);
    if (!path.finite())
        refuse(lod::ErrorKind::input_refused, node,
               "<" + std::string(node.name()) +
                   "> has a coordinate that is not finite or beyond 1e60; check its numbers");
    const bool may_enclose = std::ranges::any_of(
        path.subpaths(), [](const CurvePath::Subpath& sub) { return sub.points.size() >= 3; });
    if (filled && may_enclose) drawing_.fills.push_back({std::move(path), style.rule});
}

void SvgWalk::draw_children(const xml_node& node, const Affine& frame, const SvgStyle& style,
                            int depth) {
    for (const xml_node& child : node.children())
        if (child.type() == pugi::node_element) draw(child, frame, style, depth + 1);
}

/// The first child that needs no extension.
void SvgWalk::draw_switch(const xml_node& node, const Affine& frame, const SvgStyle& style,
                          int depth) {
    for (const xml_node& child : node.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::string_view tag = local_name(child.name());
        if (child.attribute("requiredExtensions") || tag == "foreignObject") continue;
        return draw(child, frame, style, depth + 1);
    }
}

void SvgWalk::draw_use(const xml_node& node, const Affine& frame, const SvgStyle& style,
                       int depth) {
    std::string_view link = node.attribute("xlink:href").value();
    if (node.attribute("href")) link = node.attribute("href").value();
    if (!link.starts_with('#')) return;  // another file's: not read
    const auto found = by_id_.find(std::string(link.substr(1)));
    if (found == by_id_.end()) return;
    const xml_node target = found->second;
    if (std::ranges::find(in_use_, target) != in_use_.end())
        refuse(lod::ErrorKind::input_refused, node,
               "<use> of '" + std::string(link) + "' draws itself; break the circle");
    const Affine placed =
        frame * Affine::translation({length(node, "x", 0, width_), length(node, "y", 0, height_)});
    in_use_.push_back(target);
    if (local_name(target.name()) == "symbol") {
        const SvgStyle inner = sheet_.style_of(target, style);
        if (inner.drawn)
            draw_children(target, placed * view_box_frame(target, node), inner, depth + 1);
    } else {
        draw(target, placed, style, depth + 1);
    }
    in_use_.pop_back();
}

void SvgWalk::draw(const xml_node& node, const Affine& outer, const SvgStyle& parent, int depth) {
    static constexpr std::string_view shapes[] = {"path", "rect",    "circle",  "ellipse",
                                                  "line", "polygon", "polyline"};
    const std::string_view tag = local_name(node.name());
    const bool shape = std::ranges::find(shapes, tag) != std::end(shapes);
    texts_ += tag == "text";
    images_ += tag == "image";
    const bool container =
        tag == "g" || tag == "a" || tag == "svg" || tag == "switch" || tag == "use";
    if (!shape && !container) return;

    lod::check_interrupted();
    if (++elements_ > settings_.most_elements)
        refuse(lod::ErrorKind::limit_exceeded, node,
               "it draws more than " + std::to_string(settings_.most_elements) +
                   " elements; simplify it or raise the limit");
    if (depth > settings_.most_depth)
        refuse(lod::ErrorKind::limit_exceeded, node,
               "its elements are nested deeper than " + std::to_string(settings_.most_depth) +
                   "; simplify it or raise the limit");

    const SvgStyle style = sheet_.style_of(node, parent);
    if (!style.drawn) return;
    Affine frame = outer;
    if (node.attribute("transform")) frame = frame * parsed(node, "transform", parse_svg_transform);
    if (shape) {
        draw_shape(node, frame, style);
    } else if (tag == "use") {
        draw_use(node, frame, style, depth);
    } else if (tag == "switch") {
        draw_switch(node, frame, style, depth);
    } else {
        if (tag == "svg" && depth > 0) {
            frame =
                frame *
                Affine::translation({length(node, "x", 0, width_), length(node, "y", 0, height_)}) *
                view_box_frame(node, node);
        }
        draw_children(node, frame, style, depth);
    }
}

SvgDrawing SvgWalk::read() {
    parse_xml();
    collect_ids_and_styles();
    const xml_node root = document_.document_element();
    width_ = length(root, "width", 100, 100);
    height_ = length(root, "height", 100, 100);
    if (root.attribute("viewBox")) {
        const auto box = parsed(root, "viewBox", parse_svg_view_box);
        if (box[2] > 0) width_ = box[2];
        if (box[3] > 0) height_ = box[3];
    }
    draw(root, Affine::scaling(1, -1), {}, 0);
    const auto mention = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        drawing_.left_out += (drawing_.left_out.empty() ? "" : ", ") + std::to_string(count) + " " +
                             what + (count == 1 ? "" : "s");
    };
    mention(texts_, "text");
    mention(images_, "image");
    return std::move(drawing_);
}

}  // namespace

SvgDrawing read_svg(const std::string& name, std::string_view text, const SvgSettings& settings) {
    return SvgWalk(name, text, settings).read();
}

}  // namespace lod2d
