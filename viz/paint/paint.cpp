#include "lodlab/viz/paint/paint.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/io/files/output_file.hpp"
#include "lodlab/viz/figure/check.hpp"
#include "lodlab/viz/paint/canvas/themes.hpp"
#include "lodlab/viz/paint/entries.hpp"
#include "lodlab/viz/paint/marks.hpp"
#include "lodlab/viz/paint/page.hpp"
#include "lodlab/viz/paint/plot.hpp"
#include "lodlab/viz/paint/space/render.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace viz {
namespace {

Point top_left(const Rect& rect) {
    return {rect.x, rect.y};
}

void paint_header(const Figure& figure, const PageLayout& layout, const PageInks& inks,
                  Canvas& canvas) {
    if (!figure.title.empty())
        canvas.write(title_text(figure, inks, layout.title.width), top_left(layout.title));
    for (std::size_t i = 0; i < layout.numbers.size(); ++i) {
        const Rect& box = layout.numbers[i];
        canvas.write(number_name(figure.numbers[i], inks), {box.right(), box.y});
        canvas.write(number_value(figure.numbers[i], inks, layout.number_size),
                     {box.right(), box.y + 18});
    }
}

void paint_scale_bar(const Figure& figure, const PageLayout& layout, const PageInks& inks,
                     Canvas& canvas) {
    if (layout.bar_metres <= 0) return;
    double length = 0;
    for (std::size_t i = 0; i < figure.panels.size() && length == 0; ++i)
        if (shows_scene(figure.panels[i]))
            length = layout.panels[i].mapping.length(layout.bar_metres);
    const Rect& box = layout.scale_bar;
    const double y = box.y + 12;
    const double x = box.right();
    const Line line{inks.muted, 2, 1, false};
    canvas.stroke({{{x - length, y}, {x, y}},
                   {{x - length, y - 5}, {x - length, y + 5}},
                   {{x, y - 5}, {x, y + 5}}},
                  false, line);
    canvas.write(bar_text(layout, figure, inks), {x - length - 10, y - 10});
}

void paint_foot(const Figure& figure, const PageLayout& layout, const PageInks& inks,
                Canvas& canvas) {
    if (!figure.caption.empty())
        canvas.write(caption_text(figure, inks, layout.caption.width), top_left(layout.caption));
    paint_scale_bar(figure, layout, inks, canvas);
}

void paint_headings(const Figure& figure, const PageLayout& layout, const PageInks& inks,
                    Canvas& canvas) {
    for (std::size_t i = 0; i < layout.row_titles.size() && i < figure.row_titles.size(); ++i) {
        const Rect& box = layout.row_titles[i];
        const Text words = heading(figure.row_titles[i], inks, box.width + 1);
        canvas.write(words, {box.x, box.y + (box.height - canvas.measure(words).height) / 2});
    }
    for (std::size_t i = 0; i < layout.column_titles.size() && i < figure.column_titles.size();
         ++i) {
        const Rect& box = layout.column_titles[i];
        canvas.write(heading(figure.column_titles[i], inks, box.width), top_left(box));
    }
}

/// Shades the panel's scene over its whole frame, and tells what it hides.
Hidden paint_space(const Panel& panel, const PanelPlace& place, Theme theme, Rgb ground,
                   Canvas& canvas) {
    const double resolution = canvas.resolution();
    const Rect& frame = place.frame;
    const double left = std::floor(frame.x * resolution);
    const double top = std::floor(frame.y * resolution);
    SpaceRendering choice;
    choice.width = static_cast<int>(std::ceil(frame.right() * resolution) - left);
    choice.height = static_cast<int>(std::ceil(frame.bottom() * resolution) - top);
    choice.line = resolution;
    choice.theme = theme;
    const double metres = 1 / (place.mapping.length(1) * resolution);  // for a pixel
    const double low_x =
        panel.view.low.x + (left / resolution - place.mapping.place.x) * resolution * metres;
    const double high_y =
        panel.view.high.y - (top / resolution - place.mapping.place.y) * resolution * metres;
    choice.view = {{low_x, high_y - choice.height * metres},
                   {low_x + choice.width * metres, high_y}};
    SpacePicture picture = render_space(*panel.space, choice);
    canvas.clip(frame);
    canvas.draw(picture.image, {left / resolution, top / resolution}, ground);
    canvas.unclip();
    const double slack = 3 * metres;
    return [=, depth = std::move(picture.depth)](Point at, double z) {
        const int x = static_cast<int>(std::clamp(at.x * resolution - left, -1.0, 1e6));
        const int y = static_cast<int>(std::clamp(at.y * resolution - top, -1.0, 1e6));
        if (x < 0 || y < 0 || x >= choice.width || y >= choice.height) return false;
        return z >
               slack +
                   static_cast<double>(
                       depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(choice.width) +
                             static_cast<std::size_t>(x)]);
    };
}

}  // namespace

void paint(const Figure& figure, Theme theme, Canvas& canvas, double width) {
    const PageInks inks = page_inks(theme);
    canvas.clear(inks.ground);
    const PageLayout layout = lay_out_page(figure, canvas, width);
    paint_header(figure, layout, inks, canvas);
    paint_headings(figure, layout, inks, canvas);
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        const Panel& panel = figure.panels[i];
        const PanelPlace& place = layout.panels[i];
        Rgb ground = inks.ground;
        if (!panel.title.empty() && !shows_scene(panel))
            canvas.write(panel_title(panel, inks, place), top_left(place.title));
        if (!panel.entries.empty()) {
            paint_entries(panel.entries, place.frame, theme, canvas);
            continue;
        }
        if (panel.axes) {
            paint_axes(panel, place, inks, canvas);
        } else if (figure.panels.size() > 1) {
            ground = inks.panel;
            const Rect& f = place.frame;
            canvas.fill(
                std::vector<Ring>{
                    {{f.x, f.y}, {f.right(), f.y}, {f.right(), f.bottom()}, {f.x, f.bottom()}}},
                ground, 1);
        }
        const Hidden hidden =
            panel.space ? paint_space(panel, place, theme, ground, canvas) : Hidden();
        paint_marks(panel, place, {theme, ground}, hidden, canvas);
        if (!panel.title.empty() && shows_scene(panel))
            canvas.write(panel_title(panel, inks, place), top_left(place.title),
                         title_within(panel, place) ? &ground : nullptr);
    }
    paint_foot(figure, layout, inks, canvas);
}

double page_height(const Figure& figure, double width) {
    return std::round(width / figure.aspect);
}

std::vector<PanelPlace> panel_places(const Figure& figure, double width) {
    Canvas canvas(PageFormat::image, width, page_height(figure, width), 1);
    return lay_out_page(figure, canvas, width).panels;
}

double pixels_per_unit(Quality quality) {
    switch (quality) {
        case Quality::draft:
            return 0.75;
        case Quality::p720:
            return 1;
        case Quality::p1080:
            return 1.5;
        case Quality::p4k:
            return 3;
    }
    return 1;
}

Image rasterise(const Figure& figure, Theme theme, Quality quality) {
    check_figure(figure);
    Canvas canvas(PageFormat::image, page_width, page_height(figure), pixels_per_unit(quality));
    paint(figure, theme, canvas);
    return canvas.image();
}

namespace {

std::string page_bytes(const Figure& figure, Theme theme, PageFormat format, double scale,
                       double width = page_width) {
    Canvas canvas(format, width, page_height(figure, width), scale);
    paint(figure, theme, canvas, width);
    return canvas.bytes(plain_text(figure.title), figure.alt);
}

void write_page(const std::filesystem::path& path, const Figure& figure,
                const WriteOptions& options, PageFormat format) {
    check_figure(figure);
    lod::OutputFile file(path);  // refuse an unwritable folder before the work
    file.write(page_bytes(figure, options.theme, format, pixels_per_unit(options.quality)));
    file.commit();
}

}  // namespace

void write_png(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options) {
    write_page(path, figure, options, PageFormat::image);
}
void write_svg(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options) {
    write_page(path, figure, options, PageFormat::svg);
}
void write_pdf(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options) {
    write_page(path, figure, options, PageFormat::pdf);
}

std::string web_svg_text(const Figure& figure, double width) {
    constexpr double pixels = 1400;  // across: a page is shown at most 700 pixels wide
    const double scale = std::max(1.4, pixels / width);
    check_figure(figure);
    return compacted(
        for_both_themes(page_bytes(figure, Theme::light, PageFormat::web, scale, width),
                        page_bytes(figure, Theme::dark, PageFormat::web, scale, width)));
}

void write_web_svg(const std::filesystem::path& path, const Figure& figure, double width) {
    check_figure(figure);
    lod::OutputFile file(path);
    file.write(web_svg_text(figure, width));
    file.commit();
}

}  // namespace viz
