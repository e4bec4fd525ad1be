#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lodlab/viz/paint/palette.hpp"

namespace viz {

/// A rectangle of the page: x to the right, y down, in units of a page 1280 wide.
struct Rect {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
};

enum class Weight { regular, medium, bold };
enum class Align { left, centre, right };

/// Words in one style. `words` may hold the marks of viz/figure/figure.hpp (italics, subscripts).
struct Text {
    std::string words;
    double size = 16;  ///< height of the letters' em
    Weight weight = Weight::regular;
    Rgb ink;
    double opacity = 1;
    Align align = Align::left;
    double max_width = 0;  ///< wrapped beyond it; 0: one line of any width
    int max_lines = 1;     ///< ellipsised beyond it
};

struct Extent {
    double width = 0;
    double height = 0;
};

/// How a line is drawn.
struct Line {
    Rgb ink;
    double width = 1;
    double opacity = 1;
    bool dashed = false;
};

/// Pixels, four bytes each (blue, green, red, unused), rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    int stride = 0;  ///< bytes from one row to the next
    std::vector<std::uint8_t> pixels;
};

/// web: an SVG for one theme, to be joined with the other's (viz/paint/canvas/themes.hpp); what it
/// holds of pixels is opaque WebP.
enum class PageFormat { image, svg, pdf, web };

/// The drawing library behind a few primitives, in page units with y down. Every coordinate must
/// be finite and near the page (viz/paint/canvas/clip.hpp). The same calls give the same bytes.
class Canvas {
  public:
    /// One page unit is `scale` pixels (image; web: of what it holds of pixels), or the same page
    /// in points (svg, pdf).
    Canvas(PageFormat format, double width, double height, double scale);
    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    void clear(Rgb ground);
    void fill(const std::vector<Ring>& rings, Rgb ink, double opacity);  ///< even-odd
    void stroke(const std::vector<Ring>& rings, bool closed, const Line& line);
    struct Circle {
        Point centre;
        double radius;
    };
    /// The union of the discs, in one even tone.
    void fill(const std::vector<Circle>& discs, Rgb ink, double opacity);
    void stroke(const Circle& disc, const Line& line);

    [[nodiscard]] Extent measure(const Text& text);
    /// `at` is the top left (or centre, or right) corner of the words. With `halo`, the ground's
    /// ink surrounds the letters.
    void write(const Text& text, Point at, const Rgb* halo = nullptr);

    /// Pixels of a raster picture for one page unit: the page's own where it is an image, enough
    /// for print where it is not.
    [[nodiscard]] double resolution() const;
    /// A raster picture of that resolution; `at` is its top left corner, a whole number of pixels.
    /// Its colours are premultiplied by their cover, the fourth byte; what they do not cover is
    /// `ground`.
    void draw(const Image& picture, Point at, Rgb ground);

    void clip(const Rect& to);
    void unclip();

    /// Ends the drawing. The finished file's bytes: PNG, SVG or PDF (web: SVG).
    [[nodiscard]] std::string bytes(const std::string& title, const std::string& alt);
    [[nodiscard]] Image image();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace viz
