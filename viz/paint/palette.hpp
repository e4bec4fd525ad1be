#pragma once

#include <array>
#include <optional>

#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace viz {

/// sRGB, each 0 to 1.
struct Rgb {
    double r = 0;
    double g = 0;
    double b = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// How a role is drawn. Widths are pixels of a 1280-pixel page.
struct Pen {
    Rgb ink;
    double width = 1;
    double fill = 0;  ///< opacity of the inside
    bool dashed = false;
    std::optional<Rgb> inside = {};  ///< where that is another ink than the line's
    bool doubled = false;  ///< a second line inside the first, so that grey print shows it
};

/// The page itself.
struct PageInks {
    Rgb ground;
    Rgb panel;  ///< behind a scene, where a page holds several
    Rgb text;
    Rgb muted;  ///< captions, names of numbers
    Rgb grid;
};

/// The inks are told apart by readers with common colour deficiencies, and bodies A and B in grey
/// print too; tests/viz/palette.cpp holds them to it. Bodies beyond the third take the inks again;
/// curves beyond the third do so dashed.
[[nodiscard]] Pen pen(Theme theme, Role role, int body);
/// The same of a mark: of Role::reached each level has an ink of its own up to deepest_ink, that
/// of deeper ones; none (-1) is grey.
[[nodiscard]] Pen pen(Theme theme, const Style& style);
/// Whether two marks are drawn alike.
[[nodiscard]] bool same_pen(const Style& a, const Style& b);
[[nodiscard]] PageInks page_inks(Theme theme);
[[nodiscard]] Rgb body_ink(Theme theme, int body);

/// `share` of the way from a to b, in sRGB.
[[nodiscard]] Rgb mixed(Rgb a, Rgb b, double share);

}  // namespace viz
