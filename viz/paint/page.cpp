#include "lodlab/viz/paint/page.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lodlab/viz/figure/number_text.hpp"
#include "lodlab/viz/paint/plot.hpp"

namespace viz {
namespace {

constexpr double gutter = 22;
constexpr double title_size = 29;
constexpr double value_size = 24;
constexpr double least_value_size = 17;
constexpr double number_gap = 30;
constexpr double scene_room = 10;  ///< between a scene's view and its frame

struct Grid {
    int rows = 1;
    int columns = 1;
    std::vector<Cell> cells;  ///< one a panel
};

/// The columns that show the panels largest, or what the figure asks for. A plot counts as 3 to 2.
int chosen_columns(const Figure& figure) {
    if (figure.columns > 0) return figure.columns;
    const int count = std::max(1, static_cast<int>(figure.panels.size()));
    double view_aspect = 1.5;
    for (const Panel& panel : figure.panels)
        if (shows_scene(panel))
            view_aspect =
                (panel.view.high.x - panel.view.low.x) / (panel.view.high.y - panel.view.low.y);
    const double page_aspect = figure.aspect * 1.2;  // what titles and caption leave of the page
    int best = 1;
    double most = 0;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double width = std::min(page_aspect / columns, 0.92 / rows * view_aspect);
        if (width < most * 1.02) continue;
        most = width;
        best = columns;
    }
    return best;
}

Grid grid_of(const Figure& figure) {
    Grid grid;
    grid.columns = chosen_columns(figure);
    int next = 0;
    for (const Panel& panel : figure.panels) {
        const Cell cell = panel.cell.value_or(Cell{next / grid.columns, next % grid.columns});
        if (!panel.cell) ++next;
        grid.cells.push_back(cell);
        grid.rows = std::max(grid.rows, cell.row + std::max(1, cell.rows));
        grid.columns = std::max(grid.columns, cell.column + std::max(1, cell.columns));
    }
    return grid;
}

/// Starts and lengths of the parts of a line, by their weights, gutters between them.
struct Parts {
    std::vector<double> start;
    std::vector<double> length;
};
Parts divided(double from, double length, int count, const std::vector<double>& weights) {
    std::vector<double> share(static_cast<std::size_t>(count), 1.0);
    for (std::size_t i = 0; i < share.size() && i < weights.size(); ++i)
        share[i] = std::max(1e-3, weights[i]);
    const double total = std::accumulate(share.begin(), share.end(), 0.0);
    const double usable = length - gutter * (count - 1);
    Parts parts;
    for (const double weight : share) {
        parts.start.push_back(from);
        parts.length.push_back(std::max(1.0, usable * weight / total));
        from += parts.length.back() + gutter;
    }
    return parts;
}

/// Numbers stand top right, each its name above its value.
void place_numbers(const Figure& figure, Canvas& canvas, Rect& content, PageLayout& layout) {
    const PageInks inks{};
    std::vector<double> widths;
    const double most = content.width * 0.55;
    double total = 0;
    for (layout.number_size = value_size;; layout.number_size -= 1) {
        widths.clear();
        total = 0;
        for (const Quantity& number : figure.numbers) {
            const double name = canvas.measure(number_name(number, inks)).width;
            const double value =
                canvas.measure(number_value(number, inks, layout.number_size)).width;
            widths.push_back(std::max(name, value));
            total += widths.back() + number_gap;
        }
        if (total <= most || layout.number_size <= least_value_size) break;
    }
    double x = content.right() - total + number_gap;
    for (const double width : widths) {
        layout.numbers.push_back({x, content.y, width, 18 + layout.number_size * 1.3});
        x += width + number_gap;
    }
    const double taken = figure.numbers.empty() ? 0 : total + number_gap;
    const double title_width = std::max(content.width * 0.3, content.width - taken);
    const Extent title = canvas.measure(title_text(figure, inks, title_width));
    layout.title = {content.x, content.y, title_width, figure.title.empty() ? 0 : title.height};
    const double numbers_height = layout.numbers.empty() ? 0 : layout.numbers[0].height;
    const double header = std::max(layout.title.height, numbers_height);
    if (header == 0) return;
    content.y += header + 12;
    content.height -= header + 12;
}

void place_caption(const Figure& figure, Canvas& canvas, double bar_width, Rect& content,
                   PageLayout& layout) {
    const double width = content.width - (bar_width > 0 ? bar_width + 40 : 0);
    double height = 0;
    if (!figure.caption.empty())
        height = canvas.measure(caption_text(figure, PageInks{}, width)).height;
    const double foot = std::max(height, bar_width > 0 ? 26.0 : 0.0);
    if (foot == 0) return;
    layout.caption = {content.x, content.bottom() - height, width, height};
    layout.scale_bar = {content.right() - bar_width, content.bottom() - 24, bar_width, 24};
    content.height -= foot + 14;
}

/// Where the rows and columns of panels lie.
struct Division {
    Parts rows;
    Parts columns;
};

Division place_headings(const Figure& figure, Canvas& canvas, const Grid& grid, const Rect& content,
                        PageLayout& layout) {
    double left = 0;
    for (const std::string& words : figure.row_titles)
        left = std::max(left, canvas.measure(heading(words, PageInks{}, 150)).width);
    if (left > 0) left += 16;
    const double top = figure.column_titles.empty() ? 0 : 32;
    Parts rows = divided(content.y + top, content.height - top, grid.rows, figure.row_weights);
    Parts columns =
        divided(content.x + left, content.width - left, grid.columns, figure.column_weights);
    for (std::size_t r = 0; r < rows.start.size() && !figure.row_titles.empty(); ++r)
        layout.row_titles.push_back({content.x, rows.start[r], left - 16, rows.length[r]});
    for (std::size_t c = 0; c < columns.start.size() && top > 0; ++c)
        layout.column_titles.push_back({columns.start[c], content.y, columns.length[c], top});
    return {std::move(rows), std::move(columns)};
}

Rect cell_rect(const Cell& cell, const Parts& rows, const Parts& columns) {
    const auto row = static_cast<std::size_t>(std::max(0, cell.row));
    const auto column = static_cast<std::size_t>(std::max(0, cell.column));
    const auto last_row = row + static_cast<std::size_t>(std::max(1, cell.rows)) - 1;
    const auto last_column = column + static_cast<std::size_t>(std::max(1, cell.columns)) - 1;
    return {columns.start[column], rows.start[row],
            columns.start[last_column] + columns.length[last_column] - columns.start[column],
            rows.start[last_row] + rows.length[last_row] - rows.start[row]};
}

/// A panel's title stands above its frame, or within its corner where the rows have titles already.
PanelPlace place_panel(const Panel& panel, Rect cell, bool title_within, Canvas& canvas) {
    PanelPlace place;
    if (title_within && shows_scene(panel)) {
        place.title = {cell.x + 10, cell.y + 6, cell.width - 20, panel.title.empty() ? 0.0 : 22.0};
        place.frame = cell;
        return place;
    }
    const double title = panel.title.empty() ? 0 : 30;
    place.title = {cell.x, cell.y, cell.width, title};
    cell.y += title;
    cell.height = std::max(10.0, cell.height - title);
    place.frame = panel.axes ? plot_frame(panel, cell, canvas) : cell;
    return place;
}

/// Plots one above the other begin and end together, so that what is across is the same in both.
void align_plots(const Figure& figure, const Grid& grid, PageLayout& layout) {
    const auto is_stacked = [&](std::size_t i, std::size_t j) {
        return figure.panels[i].axes && figure.panels[j].axes && !figure.panels[i].axes->x.hidden &&
               !figure.panels[j].axes->x.hidden && grid.cells[i].column == grid.cells[j].column &&
               grid.cells[i].columns == grid.cells[j].columns;
    };
    std::vector<Rect> aligned;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        Rect frame = layout.panels[i].frame;
        for (std::size_t j = 0; j < figure.panels.size(); ++j) {
            if (!is_stacked(i, j)) continue;
            const Rect& other = layout.panels[j].frame;
            const double right = std::min(frame.right(), other.right());
            frame.x = std::max(frame.x, other.x);
            frame.width = std::max(20.0, right - frame.x);
        }
        aligned.push_back(frame);
    }
    for (std::size_t i = 0; i < aligned.size(); ++i) layout.panels[i].frame = aligned[i];
}

double fitting_scale(const Panel& panel, const Rect& frame) {
    const Rect room = frame;
    const double width = std::max(1.0, room.width - 2 * scene_room);
    const double height = std::max(1.0, room.height - 2 * scene_room);
    return std::min(width / (panel.view.high.x - panel.view.low.x),
                    height / (panel.view.high.y - panel.view.low.y));
}

/// The rectangle of the page that shows a view at a scale, in the middle of the frame.
Rect centred(const Box& view, const Rect& frame, double scale) {
    const double width = scale * (view.high.x - view.low.x);
    const double height = scale * (view.high.y - view.low.y);
    return {frame.x + (frame.width - width) / 2, frame.y + (frame.height - height) / 2, width,
            height};
}

/// The scales of the scene panels; returns the one of a shared scale bar, or 0.
double map_views(const Figure& figure, PageLayout& layout) {
    double shared = std::numeric_limits<double>::infinity();
    int scenes = 0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        if (!shows_scene(figure.panels[i])) continue;
        shared = std::min(shared, fitting_scale(figure.panels[i], layout.panels[i].frame));
        ++scenes;
    }
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        const Panel& panel = figure.panels[i];
        PanelPlace& place = layout.panels[i];
        if (!panel.entries.empty()) continue;
        if (panel.axes) {
            place.mapping = {panel.view, place.frame, panel.axes->x.scale, panel.axes->y.scale};
            continue;
        }
        const double scale = figure.shared_scale ? shared : fitting_scale(panel, place.frame);
        place.mapping = {panel.view, centred(panel.view, place.frame, scale)};
    }
    return scenes > 0 && (figure.shared_scale || scenes == 1) ? shared : 0;
}

/// The longest of 1, 2, 5 x 10^k that is not above a length.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0, 1.0})
        if (step * power <= most) return step * power;
    return power;
}

}  // namespace

Point Mapping::operator()(Point p) const {
    const auto along = [](double value, double low, double high, Scale scale) {
        if (scale == Scale::linear) return (value - low) / (high - low);
        return std::log(std::max(value, low * 1e-6) / low) / std::log(high / low);
    };
    return {place.x + place.width * along(p.x, view.low.x, view.high.x, x),
            place.bottom() - place.height * along(p.y, view.low.y, view.high.y, y)};
}

double Mapping::length(double metres) const {
    return metres * place.width / (view.high.x - view.low.x);
}

PageLayout lay_out_page(const Figure& figure, Canvas& canvas, double width) {
    PageLayout layout;
    layout.width = width;
    layout.height = std::round(width / figure.aspect);
    const double side = margin_share * layout.width;
    const double top = margin_share * std::min(layout.height, 720.0);
    Rect content{side, top, layout.width - 2 * side, layout.height - 2 * top};
    place_numbers(figure, canvas, content, layout);

    bool has_scene = false;
    for (const Panel& panel : figure.panels) has_scene = has_scene || shows_scene(panel);
    const bool bar = figure.scale_bar && has_scene;
    place_caption(figure, canvas, bar ? 290 : 0, content, layout);

    const Grid grid = grid_of(figure);
    const Division division = place_headings(figure, canvas, grid, content, layout);
    for (std::size_t i = 0; i < figure.panels.size(); ++i)
        layout.panels.push_back(
            place_panel(figure.panels[i], cell_rect(grid.cells[i], division.rows, division.columns),
                        !figure.row_titles.empty(), canvas));
    align_plots(figure, grid, layout);
    const double scale = map_views(figure, layout);
    constexpr double longest_bar = 130;
    if (bar && scale > 0) layout.bar_metres = round_length(longest_bar / scale);
    return layout;
}

bool title_within(const Panel& panel, const PanelPlace& place) {
    return shows_scene(panel) && place.title.y > place.frame.y;
}

Text title_text(const Figure& figure, const PageInks& inks, double width) {
    return {.words = figure.title,
            .size = title_size,
            .weight = Weight::bold,
            .ink = inks.text,
            .max_width = width,
            .max_lines = 2};
}

Text number_name(const Quantity& number, const PageInks& inks) {
    return {.words = number.name, .size = smallest_text, .ink = inks.muted, .align = Align::right};
}

Text number_value(const Quantity& number, const PageInks& inks, double size) {
    return {.words = number.value,
            .size = size,
            .weight = Weight::medium,
            .ink = inks.text,
            .align = Align::right};
}

Text caption_text(const Figure& figure, const PageInks& inks, double width) {
    return {
        .words = figure.caption, .size = 17, .ink = inks.muted, .max_width = width, .max_lines = 2};
}

Text panel_title(const Panel& panel, const PageInks& inks, const PanelPlace& place) {
    const bool within = title_within(panel, place);
    return {.words = panel.title,
            .size = within ? smallest_text : 18,
            .weight = within ? Weight::regular : Weight::medium,
            .ink = within ? inks.muted : inks.text,
            .max_width = place.title.width,
            .max_lines = 1};
}

Text heading(const std::string& words, const PageInks& inks, double width) {
    return {.words = words,
            .size = 18,
            .weight = Weight::medium,
            .ink = inks.text,
            .max_width = width,
            .max_lines = 3};
}

Text bar_text(const PageLayout& layout, const Figure& figure, const PageInks& inks) {
    int scenes = 0;
    for (const Panel& panel : figure.panels) scenes += shows_scene(panel) ? 1 : 0;
    const std::string where = scenes > 1 ? " in every panel" : "";
    return {.words = length_text(layout.bar_metres) + where,
            .size = 16,
            .ink = inks.muted,
            .align = Align::right};
}

}  // namespace viz
