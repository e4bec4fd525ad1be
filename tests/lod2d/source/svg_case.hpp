#pragma once

#include "lodlab/lod2d/source/svg.hpp"
#include "tests/catch.hpp"

// Small drawings in tables, with what is to be seen of each.
namespace lod2d::svg_cases {

/// A small drawing and how full its shape's square is: area / (longer side of its box)^2.
struct Case {
    const char* body;
    double fullness;
};

// What is to be seen of most drawings: 8 x 4, half of its square. What must not be seen is larger.
#define SEEN "<rect x='4' y='4' width='8' height='4'/>"
constexpr double half = 0.5;

/// A drawing, and words of what is said of it.
struct Said {
    const char* body;
    const char* words;
};

inline Shape shape_of_body(const std::string& body, bool strokes = false) {
    SvgSettings settings;
    settings.outline.tolerance = 1e-5;
    settings.strokes = strokes;
    return parse_svg("case.svg",
                     "<svg xmlns='http://www.w3.org/2000/svg' "
                     "xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 40 40'>" +
                         body + "</svg>",
                     settings);
}

template <std::size_t n>
void check(const Case (&cases)[n], double epsilon = 1e-6) {
    for (const Case& one : cases) {
        INFO(one.body);
        CHECK(shape_of_body(one.body).area == Approx(one.fullness).epsilon(epsilon));
    }
}

inline std::string remarks_of(const Shape& shape) {
    std::string all;
    for (const std::string& line : shape.remarks) all += line + "\n";
    return all;
}

}  // namespace lod2d::svg_cases
