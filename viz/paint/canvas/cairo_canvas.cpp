// The one file that includes Cairo and Pango.

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <new>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/paint/canvas/canvas.hpp"
#include "lodlab/viz/paint/canvas/document.hpp"
#include "lodlab/viz/paint/canvas/webp.hpp"
#include "lodlab/viz/paint/write.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
/// Fontconfig keeps fonts for the next time, behind pointers that a leak checker cannot follow.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\n";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";  // a line on standard error is the program's own
}
#endif
#endif

namespace viz {
namespace {

constexpr const char* families = "Inter,Source Sans 3,Source Sans Pro,Fira Sans,DejaVu Sans,Sans";
constexpr double halo_width = 5;
constexpr double dash_length = 7;
constexpr double dash_gap = 5;

struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// Cairo's stream: into memory, so that the file's own writer sees a full disk.
cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
    try {
        static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    throw lod::Error(lod::ErrorKind::output_failed,
                     std::string("cannot draw the figure: the drawing library says \"") +
                         cairo_status_to_string(status) + "\"; draw it smaller");
}

std::string valid_utf8(const std::string& words) {
    const std::unique_ptr<char, void (*)(void*)> valid(g_utf8_make_valid(words.c_str(), -1),
                                                       g_free);
    return valid.get();
}

std::string escaped(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        default:
            return std::string(1, c);
    }
}

/// Our marks of italics and subscripts as Pango's markup.
std::string markup(const std::string& words) {
    std::string out;
    bool italic = false;
    bool lowered = false;  // within _{...}
    const std::string begin_lowered = "<span size=\"72%\" rise=\"-2500\">";
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char c = words[i];
        if (c == '\\' && i + 1 < words.size()) {
            out += escaped(words[++i]);
        } else if (c == '*' && !lowered) {
            out += italic ? "</i>" : "<i>";
            italic = !italic;
        } else if (c == '_' && i + 1 < words.size() && !lowered) {
            lowered = words[i + 1] == '{';
            out += begin_lowered;
            ++i;
            if (!lowered) out += escaped(words[i]) + "</span>";
        } else if (c == '}' && lowered) {
            out += "</span>";
            lowered = false;
        } else {
            out += escaped(c);
        }
    }
    return out + (lowered ? "</span>" : "") + (italic ? "</i>" : "");
}

PangoWeight pango_weight(Weight weight) {
    switch (weight) {
        case Weight::regular:
            return PANGO_WEIGHT_NORMAL;
        case Weight::medium:
            return PANGO_WEIGHT_MEDIUM;
        case Weight::bold:
            return PANGO_WEIGHT_SEMIBOLD;
    }
    return PANGO_WEIGHT_NORMAL;
}

PangoAlignment pango_align(Align align) {
    switch (align) {
        case Align::left:
            return PANGO_ALIGN_LEFT;
        case Align::centre:
            return PANGO_ALIGN_CENTER;
        case Align::right:
            return PANGO_ALIGN_RIGHT;
    }
    return PANGO_ALIGN_LEFT;
}

}  // namespace

struct Canvas::State {
    PageFormat format;
    double width;
    double height;
    double resolution;
    std::string stream;             ///< must outlive the surface, which writes to it
    std::deque<std::string> links;  ///< of pictures; the surface writes them at its end
    Owned<cairo_surface_t> surface;
    Owned<cairo_t> context;
    Owned<PangoLayout> layout;

    void set_ink(Rgb ink, double opacity) const {
        cairo_set_source_rgba(context.get(), ink.r, ink.g, ink.b, opacity);
    }
    void set_line(const Line& line) const {
        set_ink(line.ink, line.opacity);
        cairo_set_line_width(context.get(), line.width);
        constexpr std::array<double, 2> dashes{dash_length, dash_gap};
        cairo_set_dash(context.get(), dashes.data(), line.dashed ? 2 : 0, 0);
    }
    void trace(const std::vector<Ring>& rings, bool closed) const {
        cairo_new_path(context.get());
        for (const Ring& ring : rings) {
            if (ring.empty()) continue;
            cairo_move_to(context.get(), ring[0].x, ring[0].y);
            for (std::size_t i = 1; i < ring.size(); ++i)
                cairo_line_to(context.get(), ring[i].x, ring[i].y);
            if (closed) cairo_close_path(context.get());
        }
    }
    void trace(const Circle& disc) const {
        cairo_new_sub_path(context.get());
        cairo_arc(context.get(), disc.centre.x, disc.centre.y, disc.radius, 0,
                  2 * std::numbers::pi);
        cairo_close_path(context.get());
    }
    void set_text(const Text& text) const;
};

/// Fills the layout with the words; the same for measuring and for writing.
void Canvas::State::set_text(const Text& text) const {
    const Owned<PangoFontDescription> font(pango_font_description_new());
    pango_font_description_set_family_static(font.get(), families);
    pango_font_description_set_absolute_size(font.get(), std::round(text.size * PANGO_SCALE));
    pango_font_description_set_weight(font.get(), pango_weight(text.weight));
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_alignment(layout.get(), pango_align(text.align));
    const bool wraps = text.max_width > 0;
    pango_layout_set_width(layout.get(),
                           wraps ? static_cast<int>(text.max_width * PANGO_SCALE) : -1);
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    pango_layout_set_height(layout.get(), wraps ? -std::max(1, text.max_lines) : -1);
    pango_layout_set_ellipsize(layout.get(), wraps ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);

    const std::string marked =
        "<span font_features=\"tnum=1\">" + markup(valid_utf8(text.words)) + "</span>";
    pango_layout_set_markup(layout.get(), marked.c_str(), static_cast<int>(marked.size()));
}

Canvas::Canvas(PageFormat format, double width, double height, double scale)
    : state_(std::make_unique<State>()) {
    state_->format = format;
    state_->width = width;
    state_->height = height;
    constexpr double print = 2;  // pixels a page unit
    const bool prints = format == PageFormat::svg || format == PageFormat::pdf;
    state_->resolution = prints ? std::max(print, scale) : scale;
    const auto pixels = [&](double length) {
        return 2 * static_cast<int>(length * scale / 2 + 0.5);
    };
    switch (format) {
        case PageFormat::image:
            state_->surface.reset(
                cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
            break;
        case PageFormat::svg:
        case PageFormat::web:
            state_->surface.reset(
                cairo_svg_surface_create_for_stream(append, &state_->stream, width, height));
            cairo_svg_surface_set_document_unit(state_->surface.get(), CAIRO_SVG_UNIT_PX);
            break;
        case PageFormat::pdf:
            state_->surface.reset(
                cairo_pdf_surface_create_for_stream(append, &state_->stream, width, height));
            break;
    }
    check(cairo_surface_status(state_->surface.get()));
    state_->context.reset(cairo_create(state_->surface.get()));
    if (format == PageFormat::image)
        cairo_scale(state_->context.get(), pixels(width) / width, pixels(height) / height);
    cairo_set_line_join(state_->context.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(state_->context.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_tolerance(state_->context.get(), 0.1);
    state_->layout.reset(pango_cairo_create_layout(state_->context.get()));
    // The same letters whatever the desktop's settings are.
    const Owned<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    PangoContext* pango = pango_layout_get_context(state_->layout.get());
    pango_cairo_context_set_font_options(pango, options.get());
    pango_cairo_context_set_resolution(pango, 72);
    pango_context_set_language(pango, pango_language_from_string("en"));
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::clear(Rgb ground) {
    state_->set_ink(ground, 1);
    cairo_paint(state_->context.get());
}

void Canvas::fill(const std::vector<Ring>& rings, Rgb ink, double opacity) {
    state_->trace(rings, true);
    state_->set_ink(ink, opacity);
    cairo_set_fill_rule(state_->context.get(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(state_->context.get());
}

void Canvas::stroke(const std::vector<Ring>& rings, bool closed, const Line& line) {
    state_->trace(rings, closed);
    state_->set_line(line);
    cairo_stroke(state_->context.get());
}

void Canvas::fill(const std::vector<Circle>& discs, Rgb ink, double opacity) {
    cairo_new_path(state_->context.get());
    for (const Circle& disc : discs) state_->trace(disc);
    state_->set_ink(ink, opacity);
    cairo_set_fill_rule(state_->context.get(), CAIRO_FILL_RULE_WINDING);
    cairo_fill(state_->context.get());
}

void Canvas::stroke(const Circle& disc, const Line& line) {
    cairo_new_path(state_->context.get());
    state_->trace(disc);
    state_->set_line(line);
    cairo_stroke(state_->context.get());
}

Extent Canvas::measure(const Text& text) {
    state_->set_text(text);
    PangoRectangle logical;
    pango_layout_get_extents(state_->layout.get(), nullptr, &logical);
    return {static_cast<double>(logical.width) / PANGO_SCALE,
            static_cast<double>(logical.height) / PANGO_SCALE};
}

void Canvas::write(const Text& text, Point at, const Rgb* halo) {
    state_->set_text(text);
    // A wrapped layout aligns within its width; a single line is aligned here.
    PangoRectangle logical;
    pango_layout_get_extents(state_->layout.get(), nullptr, &logical);
    const double box =
        text.max_width > 0 ? text.max_width : static_cast<double>(logical.width) / PANGO_SCALE;
    const double shift = text.align == Align::left     ? 0
                         : text.align == Align::centre ? box / 2
                                                       : box;
    cairo_t* context = state_->context.get();
    cairo_move_to(context, at.x - shift, at.y);
    if (halo) {
        pango_cairo_layout_path(context, state_->layout.get());
        state_->set_line({*halo, halo_width, text.opacity});
        cairo_stroke(context);
        cairo_move_to(context, at.x - shift, at.y);
    }
    state_->set_ink(text.ink, text.opacity);
    pango_cairo_show_layout(context, state_->layout.get());
    cairo_new_path(context);
}

double Canvas::resolution() const {
    return state_->resolution;
}

void Canvas::draw(const Image& picture, Point at, Rgb ground) {
    const bool web = state_->format == PageFormat::web;
    Image copy = web ? over_ground(picture, ground) : picture;
    const Owned<cairo_surface_t> surface(cairo_image_surface_create_for_data(
        copy.pixels.data(), CAIRO_FORMAT_ARGB32, copy.width, copy.height, copy.stride));
    check(cairo_surface_status(surface.get()));
    if (web) {
        const std::string& link = state_->links.emplace_back(webp_link(copy));
        check(cairo_surface_set_mime_data(surface.get(), CAIRO_MIME_TYPE_URI,
                                          reinterpret_cast<const unsigned char*>(link.data()),
                                          link.size(), nullptr, nullptr));
    }
    cairo_t* context = state_->context.get();
    cairo_save(context);
    cairo_translate(context, at.x, at.y);
    cairo_scale(context, 1 / state_->resolution, 1 / state_->resolution);
    cairo_set_source_surface(context, surface.get(), 0, 0);
    if (state_->format == PageFormat::image)
        cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
    cairo_paint(context);
    cairo_restore(context);
    cairo_surface_finish(surface.get());  // what still needs the pixels has copied them by now
}

void Canvas::clip(const Rect& to) {
    cairo_t* context = state_->context.get();
    cairo_save(context);
    cairo_rectangle(context, to.x, to.y, to.width, to.height);
    cairo_clip(context);
}

void Canvas::unclip() {
    cairo_restore(state_->context.get());
}

std::string Canvas::bytes(const std::string& title_words, const std::string& alt_words) {
    const std::string title = valid_utf8(title_words);
    const std::string alt = valid_utf8(alt_words);
    cairo_surface_t* surface = state_->surface.get();
    check(cairo_status(state_->context.get()));
    if (state_->format == PageFormat::image) {
        cairo_surface_flush(surface);
        check(cairo_surface_write_to_png_stream(surface, append, &state_->stream));
        return std::move(state_->stream);
    }
    if (state_->format == PageFormat::pdf) {
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, alt.c_str());
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                       "2000-01-01T00:00:00Z");
    }
    cairo_surface_finish(surface);
    check(cairo_surface_status(surface));
    if (state_->format == PageFormat::pdf) return std::move(state_->stream);
    return finished_svg(state_->stream, title, alt);
}

Image Canvas::image() {
    cairo_surface_t* surface = state_->surface.get();
    check(cairo_status(state_->context.get()));
    cairo_surface_flush(surface);
    Image image{cairo_image_surface_get_width(surface),
                cairo_image_surface_get_height(surface),
                cairo_image_surface_get_stride(surface),
                {}};
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const auto size =
        static_cast<std::size_t>(image.stride) * static_cast<std::size_t>(image.height);
    image.pixels.assign(data, data + size);
    return image;
}

std::string drawing_libraries() {
    return std::string("Cairo ") + cairo_version_string() + ", Pango " + pango_version_string();
}

}  // namespace viz
