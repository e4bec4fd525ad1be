// Compares the shapes of drawings with the pixels that librsvg draws of the files themselves.
// Usage: svg_pixels [--pictures FOLDER] FILE...     one line a file, and the counts
//
// A pixel counts as different where one of the two covers it and the other covers neither it nor a
// neighbour within two pixels. Strokes are taken in. The verdicts:
//   agrees    fewer than 0.3 % of the covered pixels differ
//   said      more differ, and the shape's remarks name something left out or taken in another way
//   SILENT    more differ, and nothing is said
//   refused   with the reason
#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/svg.hpp"

namespace {

constexpr int side = 480;   // of the drawing's longer side [pixels]
constexpr int border = 12;  // of paper around it
constexpr int pixels = side + 2 * border;

using Mask = std::vector<unsigned char>;

struct Picture {
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface{
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels, pixels), cairo_surface_destroy};
    std::unique_ptr<cairo_t, void (*)(cairo_t*)> ink{cairo_create(surface.get()), cairo_destroy};

    Mask mask() {
        cairo_surface_flush(surface.get());
        const unsigned char* data = cairo_image_surface_get_data(surface.get());
        const int stride = cairo_image_surface_get_stride(surface.get());
        Mask mask(pixels * pixels);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                std::uint32_t pixel = 0;
                std::copy_n(data + y * stride + 4 * x, 4, reinterpret_cast<unsigned char*>(&pixel));
                mask[static_cast<std::size_t>(y * pixels + x)] = pixel >> 24 > 0;
            }
        return mask;
    }
};

struct Frame {
    double low_x = pixels, low_y = pixels, high_x = 0, high_y = 0;
};

Frame frame_of(const Mask& mask) {
    Frame frame;
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            if (!mask[static_cast<std::size_t>(y * pixels + x)]) continue;
            frame.low_x = std::min<double>(frame.low_x, x);
            frame.low_y = std::min<double>(frame.low_y, y);
            frame.high_x = std::max<double>(frame.high_x, x + 1);
            frame.high_y = std::max<double>(frame.high_y, y + 1);
        }
    return frame;
}

/// The file as librsvg draws it, whole, scaled into the picture twice, the second time to its
/// pixels.
bool draw_file(const std::string& path, Mask& mask) {
    GError* error = nullptr;
    GFile* file = g_file_new_for_path(path.c_str());
    std::unique_ptr<RsvgHandle, void (*)(gpointer)> handle(
        rsvg_handle_new_from_gfile_sync(file, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error),
        g_object_unref);
    g_object_unref(file);
    if (!handle) {
        g_clear_error(&error);
        return false;
    }
    rsvg_handle_set_dpi(handle.get(), 96);
    gdouble width = 0, height = 0;
    gboolean has_width = 0, has_height = 0, has_box = 0;
    RsvgLength w, h;
    RsvgRectangle box;
    rsvg_handle_get_intrinsic_dimensions(handle.get(), &has_width, &w, &has_height, &h, &has_box,
                                         &box);
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height)) {
        width = has_box ? box.width : 100;
        height = has_box ? box.height : 100;
    }
    if (!(width > 0 && height > 0)) return false;
    const RsvgRectangle page{0, 0, width, height};
    RsvgRectangle seen{}, logical{};
    if (!rsvg_handle_get_geometry_for_layer(handle.get(), nullptr, &page, &seen, &logical,
                                            &error)) {
        g_clear_error(&error);
        return false;
    }
    double scale = side / std::max(seen.width, seen.height);
    double x = border - scale * seen.x, y = border - scale * seen.y;
    for (int round = 0; round < 2; ++round) {
        Picture picture;
        cairo_translate(picture.ink.get(), x, y);
        cairo_scale(picture.ink.get(), scale, scale);
        if (!rsvg_handle_render_document(handle.get(), picture.ink.get(), &page, &error)) {
            g_clear_error(&error);
            return false;
        }
        mask = picture.mask();
        const Frame frame = frame_of(mask);
        if (frame.high_x <= frame.low_x) return false;
        const double zoom = side / std::max(frame.high_x - frame.low_x, frame.high_y - frame.low_y);
        x = border - (frame.low_x - x) * zoom;
        y = border - (frame.low_y - y) * zoom;
        scale *= zoom;
    }
    return true;
}

/// The shape, its box on the frame of the other picture.
Mask draw_shape(const lod2d::Shape& shape, const Frame& frame) {
    Picture picture;
    const lod2d::Box box = lod2d::bounds(shape.polygon);
    const double zoom_x = (frame.high_x - frame.low_x) / box.size().x();
    const double zoom_y = (frame.high_y - frame.low_y) / box.size().y();
    const double zoom = box.size().x() >= box.size().y() ? zoom_x : zoom_y;
    const double middle_x = (frame.low_x + frame.high_x) / 2;
    const double middle_y = (frame.low_y + frame.high_y) / 2;
    for (const lod2d::Ring& ring : shape.polygon.rings) {
        cairo_new_sub_path(picture.ink.get());
        for (const lod2d::Point& p : ring)
            cairo_line_to(picture.ink.get(), middle_x + zoom * (p - box.centre()).x(),
                          middle_y - zoom * (p - box.centre()).y());
        cairo_close_path(picture.ink.get());
    }
    cairo_fill(picture.ink.get());
    return picture.mask();
}

bool near(const Mask& mask, int x, int y) {
    for (int v = std::max(0, y - 2); v <= std::min(pixels - 1, y + 2); ++v)
        for (int u = std::max(0, x - 2); u <= std::min(pixels - 1, x + 2); ++u)
            if (mask[static_cast<std::size_t>(v * pixels + u)]) return true;
    return false;
}

/// The share of the covered pixels that differ.
double difference(const Mask& a, const Mask& b, cairo_surface_t* shown) {
    std::size_t differ = 0, covered = 0;
    unsigned char* data = cairo_image_surface_get_data(shown);
    const int stride = cairo_image_surface_get_stride(shown);
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const auto i = static_cast<std::size_t>(y * pixels + x);
            covered += a[i] || b[i];
            const bool apart = (a[i] && !near(b, x, y)) || (b[i] && !near(a, x, y));
            differ += apart;
            unsigned char* pixel = data + y * stride + 4 * x;
            pixel[0] = a[i] ? 200 : 255;  // blue stays where both are
            pixel[1] = apart ? 60 : a[i] && b[i] ? 200 : a[i] || b[i] ? 230 : 255;
            pixel[2] = apart ? (a[i] ? 255 : 60) : a[i] && b[i] ? 200 : 255;
            pixel[3] = 255;
        }
    cairo_surface_mark_dirty(shown);
    return covered == 0 ? 0 : static_cast<double>(differ) / static_cast<double>(covered);
}

}  // namespace

int main(int argc, char** argv) {
    std::map<std::string, int> counts;
    std::string folder;
    for (int i = 1; i < argc; ++i) {
        const std::string path = argv[i];
        if (path == "--pictures" && i + 1 < argc) {
            folder = argv[++i];
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        std::string verdict, detail;
        try {
            lod2d::SvgSettings settings;
            settings.strokes = true;
            settings.outline.tolerance = 5e-4;
            const lod2d::Shape shape = lod2d::load_svg(path, settings);
            std::string losses;
            for (const std::string& line : shape.remarks)
                if (line.find("through librsvg") == std::string::npos) losses += line + "; ";
            Mask theirs;
            if (!draw_file(path, theirs)) {
                verdict = "no oracle";
            } else {
                const Mask ours = draw_shape(shape, frame_of(theirs));
                Picture shown;
                const double apart = difference(theirs, ours, shown.surface.get());
                verdict = apart < 0.003 ? "agrees" : losses.empty() ? "SILENT" : "said";
                char text[32];
                std::snprintf(text, sizeof text, "%.4f ", apart);
                detail = text + losses;
                if (apart >= 0.003 && !folder.empty())
                    cairo_surface_write_to_png(
                        shown.surface.get(),
                        (folder + "/" + std::filesystem::path(path).stem().string() + ".png")
                            .c_str());
            }
        } catch (const lod::Error& error) {
            verdict = "refused";
            detail = error.what();
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ++counts[verdict];
        std::printf("%-9s %6.2f s  %s  %s\n", verdict.c_str(), seconds, path.c_str(),
                    detail.c_str());
        std::fflush(stdout);
    }
    for (const auto& [verdict, count] : counts) std::printf("%d %s\n", count, verdict.c_str());
    return counts["SILENT"] > 0;
}
