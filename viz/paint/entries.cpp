#include "lodlab/viz/paint/entries.hpp"

#include <algorithm>

namespace viz {
namespace {

constexpr double usual_line = 28;
constexpr double words_size = 17;
constexpr double least_size = 15;
constexpr double swatch_width = 26;
constexpr double swatch_share = 0.6;  ///< of a line's height

void paint_swatch(const Style& style, const Rect& place, Theme theme, Canvas& canvas) {
    const Pen look = pen(theme, style);
    const std::vector<Ring> box{{{place.x, place.y},
                                 {place.right(), place.y},
                                 {place.right(), place.bottom()},
                                 {place.x, place.bottom()}}};
    if (look.fill > 0) canvas.fill(box, look.inside.value_or(look.ink), look.fill);
    canvas.stroke(box, true, {look.ink, std::max(1.0, look.width), 1, look.dashed});
}

}  // namespace

void paint_entries(std::span<const Entry> entries, const Rect& frame, Theme theme, Canvas& canvas) {
    const PageInks inks = page_inks(theme);
    const double line = std::min(
        usual_line, frame.height / static_cast<double>(std::max<std::size_t>(1, entries.size())));
    const double size = std::clamp(0.7 * line, least_size, words_size);
    double y = frame.y;
    for (const Entry& entry : entries) {
        const double height = swatch_share * line;
        paint_swatch(entry.style, {frame.x + 1, y + (line - height) / 2, swatch_width, height},
                     theme, canvas);
        const Text words{.words = entry.words, .size = size, .ink = inks.text};
        const double top = y + (line - canvas.measure(words).height) / 2;
        canvas.write(words, {frame.x + swatch_width + 12, top});
        const Text value{.words = entry.value,
                         .size = size,
                         .weight = Weight::medium,
                         .ink = inks.text,
                         .align = Align::right};
        if (!entry.value.empty()) canvas.write(value, {frame.right(), top});
        y += line;
    }
}

}  // namespace viz
