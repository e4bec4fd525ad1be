#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "lodlab/lod2d/source/paths/curve_path.hpp"

// The small languages inside SVG attributes. Each parser throws SvgTextError where the text does
// not follow its grammar.
namespace lod2d {

struct SvgTextError {
    std::string expected;   ///< "a number"
    std::size_t place = 0;  ///< characters before it
};

/// Reads numbers, words and signs from left to right.
class SvgReader {
  public:
    explicit SvgReader(std::string_view text) : text_(text) {}

    void skip_spaces();
    void skip_separator();  ///< spaces with at most one comma
    [[nodiscard]] bool at_end();
    [[nodiscard]] char peek() const { return place_ < text_.size() ? text_[place_] : '\0'; }
    char take() { return text_[place_++]; }
    [[nodiscard]] bool take_if(char c);
    [[nodiscard]] bool number_follows();
    double number();
    bool flag();  ///< 0 or 1, which need no separator after them
    std::string_view letters();
    [[noreturn]] void fail(const char* expected) const;

  private:
    std::string_view text_;
    std::size_t place_ = 0;
};

/// The value of `d`: every command, absolute and relative.
[[nodiscard]] CurvePath parse_svg_path(std::string_view d);

/// The value of `transform`: matrix, translate, scale, rotate, skewX, skewY, in order.
[[nodiscard]] Affine parse_svg_transform(std::string_view text);

/// The value of `points`. An odd number at the end is left out, as browsers do.
[[nodiscard]] std::vector<Point> parse_svg_points(std::string_view text);

/// The value of `viewBox`: x, y, width, height.
[[nodiscard]] std::array<double, 4> parse_svg_view_box(std::string_view text);

/// A length in user units (px); `percent_of` is what 100% stands for.
[[nodiscard]] double parse_svg_length(std::string_view text, double percent_of);

}  // namespace lod2d
