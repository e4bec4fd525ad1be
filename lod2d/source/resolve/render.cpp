#include "lodlab/lod2d/source/resolve/render.hpp"

#include <cairo-script.h>
#include <librsvg/rsvg.h>

#include <array>
#include <memory>
#include <span>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/resolve/cairo_script.hpp"

namespace lod2d {
namespace {

template <auto release>
struct Release {
    template <typename T>
    void operator()(T* thing) const {
        release(thing);
    }
};
using Handle = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Device = std::unique_ptr<cairo_device_t, Release<cairo_device_destroy>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;

[[noreturn]] void refuse(const std::string& name, GError* error, const std::string& otherwise) {
    std::string why = error ? error->message : otherwise;
    if (error) g_error_free(error);
    lod::refuse_input("cannot read " + name, "librsvg says: " + why + "; save it as a plain SVG");
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

/// Draws one document at several sizes.
class Renderer {
  public:
    Renderer(const std::string& name, const PreparedSvg& svg) : name_(name), svg_(svg) {
        GError* error = nullptr;
        GInputStream* stream = g_memory_input_stream_new_from_data(
            svg.text.data(), static_cast<gssize>(svg.text.size()), nullptr);
        // No base file: it reads no other.
        handle_.reset(rsvg_handle_new_from_stream_sync(stream, nullptr, RSVG_HANDLE_FLAG_UNLIMITED,
                                                       nullptr, &error));
        g_object_unref(stream);
        if (!handle_) refuse(name, error, "it cannot be read");
        rsvg_handle_set_dpi(handle_.get(), 96);
        static constexpr std::string_view sheet =
            "*{filter:none !important;mask:none !important;mix-blend-mode:normal !important;"
            "isolation:auto !important;enable-background:accumulate !important}";
        if (!rsvg_handle_set_stylesheet(
                handle_.get(), reinterpret_cast<const guint8*>(sheet.data()), sheet.size(), &error))
            refuse(name, error, "it takes no style sheet");
    }

    /// What it draws where the page is scaled and moved so that `middle` of it lies in the middle
    /// of what Cairo can hold. Turned, because that surface is short and false about upright boxes.
    [[nodiscard]] SvgScript draw(double scale, const Point& middle) const {
        const lod::Matrix<2> turned(scale * cosine, -scale * sine, scale * sine, scale * cosine);
        const Point offset = Point::Constant(canvas / 2) - turned * middle;
        SvgScript script;
        {
            const Device device(cairo_script_create_for_stream(append, &script.text));
            const Surface surface(cairo_script_surface_create(
                device.get(), CAIRO_CONTENT_COLOR_ALPHA, canvas, canvas));
            const Context context(cairo_create(surface.get()));
            cairo_matrix_t matrix;
            cairo_matrix_init(&matrix, turned(0, 0), turned(1, 0), turned(0, 1), turned(1, 1),
                              offset.x(), offset.y());
            cairo_set_matrix(context.get(), &matrix);
            const RsvgRectangle viewport{0, 0, svg_.size.x(), svg_.size.y()};
            GError* error = nullptr;
            if (!rsvg_handle_render_document(handle_.get(), context.get(), &viewport, &error))
                refuse(name_, error, "it cannot be drawn");
            cairo_surface_finish(surface.get());
            if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
                refuse(name_, nullptr, cairo_status_to_string(cairo_surface_status(surface.get())));
        }
        const lod::Matrix<2> back(cosine / scale, sine / scale, sine / scale, -cosine / scale);
        const Point origin = Point(middle.x(), -middle.y()) - back * Point::Constant(canvas / 2);
        script.to_page = {back, origin};
        return script;
    }
    [[nodiscard]] SvgDrawing drawing(double scale, const Point& middle) const {
        return drawing(draw(scale, middle));
    }
    [[nodiscard]] SvgDrawing drawing(const SvgScript& script) const {
        return read_cairo_script(name_, script.text, script.to_page);
    }

    static constexpr double canvas = 0x1p23 - 1;  ///< Cairo's numbers have 23 bits before the point

  private:
    // Of 0.6437501 radians: no angle that a drawing has.
    static constexpr double cosine = 0.799850580478866036;
    static constexpr double sine = 0.600199174364328014;

    const std::string& name_;
    const PreparedSvg& svg_;
    Handle handle_;
};

Box box_of(const SvgDrawing& drawing) {
    Box box;
    for (const SvgFill& fill : drawing.fills) {
        box.hold(fill.region.path.control_box());
        for (const auto& clip : fill.clips) box.hold(clip->path.control_box());
    }
    for (const SvgStroke& stroke : drawing.strokes) {
        CurvePath path = stroke.path;
        path.transform(stroke.to_page);
        box.hold(path.control_box());
        for (const auto& clip : stroke.clips) box.hold(clip->path.control_box());
    }
    return box;
}

bool are_alike(const Box& a, const Box& b, double tolerance) {
    if (a.is_empty() || b.is_empty()) return a.is_empty() == b.is_empty();
    return (a.low - b.low).cwiseAbs().maxCoeff() < tolerance &&
           (a.high - b.high).cwiseAbs().maxCoeff() < tolerance;
}

/// The box of all that it draws, and how far that is rounded. What lies further out than Cairo's
/// numbers reach comes back at another place each time that the scale is another.
struct Extent {
    Box box;
    double rounding = 0;
    std::size_t marks = 0;  ///< fills and strokes
};

std::size_t count_marks(const SvgDrawing& drawing) {
    return drawing.fills.size() + drawing.strokes.size();
}

[[noreturn]] void refuse_far(const std::string& name) {
    lod::refuse_input("cannot read " + name,
                      "parts of it lie millions of pages outside its page; delete them");
}

/// How far from the middle of the page its parts reach [pages], drawn at so many units a page. Zero
/// where it cannot be drawn at all so small: a pattern's tile may vanish.
double reach_at(double side, const Renderer& renderer, const Point& size) {
    const double page = size.maxCoeff();
    try {
        const Box box = box_of(renderer.drawing(side / page, size / 2));
        if (box.is_empty()) return 0;
        const Point middle(size.x() / 2, -size.y() / 2);
        return (box.low - middle).cwiseAbs().cwiseMax((box.high - middle).cwiseAbs()).norm() / page;
    } catch (const lod::Error&) {
        return 0;
    }
}

/// The largest of the sides [Cairo's units a page], largest first, at which all that it draws lies
/// within Cairo's numbers. Beyond them points come back elsewhere, and edges longer than those
/// reach have differences that wrap around too: Cairo's tessellator then sorts them in no order,
/// and on some hundred of them it takes minutes or never ends. So what is far out is found at a
/// small scale first.
double largest_side(const std::string& name, const Renderer& renderer, const Point& size,
                    std::span<const double> sides) {
    const auto fits = [](double reach, double side) { return reach * side < Renderer::canvas / 2; };
    const double smallest = sides.back();
    if (!fits(reach_at(smallest * 0x1p-21, renderer, size), smallest)) refuse_far(name);
    const double reach = reach_at(smallest, renderer, size);
    for (const double side : sides)
        if (fits(reach, side)) return side;
    refuse_far(name);
}

Extent extent_of(const std::string& name, const Renderer& renderer, const Point& size) {
    static constexpr std::array<double, 3> sides{2048.0, 32.0, 0.5};
    const double page = size.maxCoeff();
    const double largest = largest_side(name, renderer, size, sides);
    for (const double side : sides) {
        if (side > largest) continue;
        const SvgDrawing drawing = renderer.drawing(side / page, size / 2);
        const Box box = box_of(drawing);
        const Box other = box_of(renderer.drawing(0.7123 * side / page, size / 2));
        const double rounding = page / side * 2;
        if (are_alike(box, other, rounding)) return {box, rounding, count_marks(drawing)};
    }
    refuse_far(name);
}

}  // namespace

SvgScript render_svg(const std::string& name, const PreparedSvg& svg) {
    const Renderer renderer(name, svg);
    const Extent extent = extent_of(name, renderer, svg.size);
    if (extent.marks == 0) return renderer.draw(2048 / svg.size.maxCoeff(), svg.size / 2);
    const Point middle(extent.box.centre().x(), -extent.box.centre().y());
    const double reach = extent.box.size().maxCoeff() + 2 * extent.rounding;
    for (double side = Renderer::canvas / 4; side > 4000; side /= 2) {
        SvgScript script = renderer.draw(side / reach, middle);
        const SvgDrawing drawing = renderer.drawing(script);
        script.precision = 0x1p-9 / side;
        if (count_marks(drawing) >= extent.marks &&
            are_alike(extent.box, box_of(drawing), 2 * extent.rounding))
            return script;
    }
    lod::refuse_input("cannot read " + name,
                      "it is drawn in another way at each size; save it as a plain SVG");
}

std::string librsvg_version() {
    return std::to_string(rsvg_major_version) + "." + std::to_string(rsvg_minor_version) + "." +
           std::to_string(rsvg_micro_version);
}

}  // namespace lod2d
