#include "lodlab/viz/paint/blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lodlab/viz/figure/check.hpp"
#include "lodlab/viz/paint/paint.hpp"

namespace viz {
namespace {

/// What a figure shows beside its words.
Figure without_words(Figure figure) {
    figure.title.clear();
    figure.caption.clear();
    figure.numbers.clear();
    figure.row_titles.clear();
    figure.column_titles.clear();
    figure.scale_bar = false;
    std::erase_if(figure.panels, [](const Panel& panel) { return !panel.entries.empty(); });
    for (Panel& panel : figure.panels) {
        panel.title.clear();
        if (panel.axes) panel.axes->x.hidden = panel.axes->y.hidden = true;
        std::erase_if(panel.marks,
                      [](const Mark& mark) { return std::holds_alternative<Label>(mark); });
        for (Mark& mark : panel.marks) {
            if (Arrow* arrow = std::get_if<Arrow>(&mark)) arrow->label.clear();
            if (Polyline* line = std::get_if<Polyline>(&mark)) line->end_label.clear();
        }
    }
    return figure;
}

using Colour = std::array<double, 3>;  ///< red, green, blue, 0 to 255

double distance(const Colour& a, const Colour& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// The mean colour of a part of the picture, from share to share of its sides.
Colour mean(const Image& image, const Rect& part) {
    const auto pixel = [](double share, int size) {
        return std::clamp(static_cast<int>(std::lround(share * size)), 0, size);
    };
    const int left = std::min(pixel(part.x, image.width), image.width - 1);
    const int top = std::min(pixel(part.y, image.height), image.height - 1);
    const int right = std::max(pixel(part.x + part.width, image.width), left + 1);
    const int bottom = std::max(pixel(part.y + part.height, image.height), top + 1);
    Colour sum{};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const std::uint8_t* at =
                image.pixels.data() +
                static_cast<std::size_t>(y) * static_cast<std::size_t>(image.stride) +
                4 * static_cast<std::size_t>(x);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += at[2 - i];
        }
    for (double& channel : sum) channel /= (right - left) * (bottom - top);
    return sum;
}

/// Four quarters of a character's cell in two colours, as near as two can be.
struct CellColours {
    unsigned fore_quarters = 0;  ///< bit 0: top left, 1: top right, 2: bottom left, 3: bottom right
    Colour fore{};
    Colour back{};
};

CellColours in_two(const std::array<Colour, 4>& quarters) {
    CellColours best;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned mask = 0; mask < 8; ++mask) {  // with their complements all sixteen
        std::array<Colour, 2> means{};
        std::array<int, 2> counts{};
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned side = mask >> i & 1U;
            ++counts[side];
            for (std::size_t c = 0; c < 3; ++c) means[side][c] += quarters[i][c];
        }
        for (unsigned side = 0; side < 2; ++side)
            for (double& channel : means[side]) channel /= std::max(counts[side], 1);
        double error = 0;
        for (unsigned i = 0; i < 4; ++i) error += distance(quarters[i], means[mask >> i & 1U]);
        if (error >= least) continue;
        least = error;
        best = {mask, means[1], means[0]};
    }
    return best;
}

constexpr std::array<const char*, 16> glyphs{" ", "▘", "▝", "▀", "▖", "▌", "▞", "▛",
                                             "▗", "▚", "▐", "▜", "▄", "▙", "▟", "█"};

int rounded(double channel) {
    return std::clamp(static_cast<int>(std::lround(channel)), 0, 255);
}

/// Of the colours 16 to 255, which every terminal of 256 has alike, the nearest.
int indexed(const Colour& colour) {
    constexpr std::array<int, 6> steps{0, 95, 135, 175, 215, 255};
    const auto nearest_step = [&](double channel) {
        const auto nearer = [&](int a, int b) {
            return std::abs(a - channel) < std::abs(b - channel);
        };
        return std::min_element(steps.begin(), steps.end(), nearer) - steps.begin();
    };
    std::array<std::size_t, 3> cube{};
    Colour in_cube{};
    for (std::size_t i = 0; i < 3; ++i) {
        cube[i] = static_cast<std::size_t>(nearest_step(colour[i]));
        in_cube[i] = steps[cube[i]];
    }
    const double brightness = (colour[0] + colour[1] + colour[2]) / 3;
    const int grey = std::clamp(static_cast<int>(std::lround((brightness - 8) / 10)), 0, 23);
    const double tone = 8 + 10 * grey;
    if (distance(colour, {tone, tone, tone}) < distance(colour, in_cube)) return 232 + grey;
    return static_cast<int>(16 + 36 * cube[0] + 6 * cube[1] + cube[2]);
}

/// The sequence that turns to a colour; `layer` is 38 for the letter, 48 for what is behind it.
std::string turn_to(int layer, const Colour& colour, TerminalColours colours) {
    std::string text = "\033[" + std::to_string(layer);
    if (colours == TerminalColours::indexed)
        return text + ";5;" + std::to_string(indexed(colour)) + "m";
    text += ";2";
    for (const double channel : colour) text += ";" + std::to_string(rounded(channel));
    return text + "m";
}

Image image_of(const Figure& figure, Theme theme) {
    constexpr double narrow = 420;  // page units: lines are wide enough to last
    Canvas canvas(PageFormat::image, narrow, page_height(figure, narrow), 2);
    paint(figure, theme, canvas, narrow);
    return canvas.image();
}

}  // namespace

std::string block_text(const Figure& whole, const BlockOptions& options) {
    check_figure(whole);
    const Figure figure = without_words(whole);
    if (figure.panels.empty()) return {};
    const Image image = image_of(figure, options.theme);
    const double rows_a_column = 0.5 * image.height / image.width;
    const int most = std::clamp(options.columns, 1, 1000);
    const int columns =
        std::clamp(static_cast<int>(std::max(options.rows, 1) / rows_a_column), 1, most);
    const int rows = std::max(1, static_cast<int>(std::lround(columns * rows_a_column)));
    std::string text;
    for (int row = 0; row < rows; ++row) {
        std::string colours;
        for (int column = 0; column < columns; ++column) {
            std::array<Colour, 4> quarters{};
            for (unsigned i = 0; i < 4; ++i)
                quarters[i] =
                    mean(image, {(column + 0.5 * (i & 1U)) / columns,
                                 (row + 0.5 * (i >> 1U)) / rows, 0.5 / columns, 0.5 / rows});
            const CellColours cell = in_two(quarters);
            const std::string wanted =
                turn_to(48, cell.back, options.colours) + turn_to(38, cell.fore, options.colours);
            if (wanted != colours) text += wanted;
            colours = wanted;
            text += glyphs[cell.fore_quarters];
        }
        text += "\033[0m\n";
    }
    return text;
}

}  // namespace viz
