#pragma once

#include <vector>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

inline constexpr double page_width = 1280;
inline constexpr double margin_share = 0.04;
inline constexpr double smallest_text = 15;
inline constexpr double label_size = 18;

/// From a panel's coordinates to the page.
struct Mapping {
    Box view;
    Rect place;  ///< what `view` is carried to
    Scale x = Scale::linear;
    Scale y = Scale::linear;

    [[nodiscard]] Point operator()(Point p) const;
    /// A length of a scene in page units. Requires: linear axes.
    [[nodiscard]] double length(double metres) const;
};

/// Where a panel stands.
struct PanelPlace {
    Rect title;
    Rect frame;       ///< the scene is clipped to it; a plot's axes stand round it
    Mapping mapping;  ///< of the view
};

/// Where everything stands on the page.
struct PageLayout {
    double width = page_width;
    double height = 720;
    Rect title;
    std::vector<Rect> numbers;  ///< one a quantity
    double number_size = 24;
    Rect caption;
    Rect scale_bar;  ///< empty: none
    double bar_metres = 0;
    std::vector<Rect> row_titles;
    std::vector<Rect> column_titles;
    std::vector<PanelPlace> panels;
};

/// On a narrower page words are larger beside the shapes.
[[nodiscard]] PageLayout lay_out_page(const Figure& figure, Canvas& canvas,
                                      double width = page_width);

/// Whether a panel's title stands within its frame.
[[nodiscard]] bool title_within(const Panel& panel, const PanelPlace& place);

// The texts of the page, the same for measuring and for writing.
[[nodiscard]] Text title_text(const Figure& figure, const PageInks& inks, double width);
[[nodiscard]] Text number_name(const Quantity& number, const PageInks& inks);
[[nodiscard]] Text number_value(const Quantity& number, const PageInks& inks, double size);
[[nodiscard]] Text caption_text(const Figure& figure, const PageInks& inks, double width);
[[nodiscard]] Text panel_title(const Panel& panel, const PageInks& inks, const PanelPlace& place);
[[nodiscard]] Text heading(const std::string& words, const PageInks& inks, double width);
[[nodiscard]] Text bar_text(const PageLayout& layout, const Figure& figure, const PageInks& inks);

}  // namespace viz
