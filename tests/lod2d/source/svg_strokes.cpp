#include <numbers>

#include "tests/lod2d/source/svg_case.hpp"

using namespace lod2d;
using namespace lod2d::svg_cases;
using std::numbers::pi;

#define PEN "fill='none' stroke='#000' stroke-width='4' "

TEST_CASE("a closed point is a dot where the pen has caps", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<path d='M10 10z' " PEN "stroke-linecap='square'/>", 1},
        {"<polygon points='10,10' " PEN "stroke-linecap='square'/>", 1},
        {"<path d='M4 10z M12 10h0' " PEN "stroke-linecap='square'/>", 32 / 144.0},
        // A move alone draws nothing, and neither does a dot without a cap.
        {"<path d='M4 10 M12 10h0' " PEN "stroke-linecap='square'/>", 1},
        {"<path d='M4 30z M2 10H22' " PEN "/>", 0.2},
        {"<path d='M-90 10z M0 0h8v4h-8z'/>", half},
    };
    check(cases);
    const Case round[] = {
        {"<path d='M10 10z' " PEN "stroke-linecap='round'/>", pi / 4},
        {"<style/><path d='M4 10z M12 10h0' " PEN "stroke-linecap='square'/>", 32 / 144.0},
    };
    check(round, 1e-3);
    CHECK(shape_of_body("<path d='M-90 10z M0 0h8v4h-8z'/>").remarks.empty());
}

TEST_CASE("a dash goes on over the closing point of its line", "[svg][svg-cases]") {
    constexpr double square = 24 * 24;
    const Case cases[] = {
        // Four corners of two arms of 5 x 4: each has its outer square and loses its inner one.
        {"<path d='M10 10H30V30H10z' " PEN "stroke-dasharray='10' stroke-dashoffset='5'/>",
         4 * 40 / square},
        {"<rect x='10' y='10' width='20' height='20' " PEN
         "stroke-dasharray='10' stroke-dashoffset='5'/>",
         4 * 40 / square},
        {"<path d='M10 10H30V30H10z' " PEN "stroke-dasharray='100 2'/>", 320 / square},
        {"<path d='M10 10H30V30H10z' " PEN "stroke-dasharray='70 2'/>", 312 / square},
        // An open line of the same points is not joined: it lacks the outer square of a corner.
        {"<path d='M10 10H30V30H10V10' " PEN "stroke-dasharray='100 2'/>", 316 / square},
    };
    check(cases, 1e-5);
}

TEST_CASE("a pen wider than a bend covers what lies beyond its centre", "[svg][svg-cases]") {
    // Half a circle of radius r under a pen of half width h: half discs of h + r and of h - r.
    const Case cases[] = {
        {"<path d='M8 20a2 2 0 0 1 4 0' fill='none' stroke='#000' stroke-width='10'/>",
         pi * (49 + 9) / 2 / 196},
        {"<path d='M10 20a1 1 0 0 1 2 0' fill='none' stroke='#000' stroke-width='12'/>",
         pi * (49 + 25) / 2 / 196},
        {"<style/><path d='M8 20a2 2 0 0 1 4 0' fill='none' stroke='#000' stroke-width='10' "
         "stroke-linejoin='round'/>",
         pi * (49 + 9) / 2 / 196},
        {"<circle r='2' fill='none' stroke='#000' stroke-width='12'/>", pi / 4},
    };
    check(cases, 1e-3);
    // Where dashes end on a curve, their ends stand across its chord.
    const Case dashed[] = {
        {"<path d='M8 20a2 2 0 0 1 4 0' fill='none' stroke='#000' stroke-width='10' "
         "stroke-dasharray='99'/>",
         pi * (49 + 9) / 2 / 196},
    };
    check(dashed, 4e-3);
}

TEST_CASE("corners turn by the directions of their curves, not of lines along them",
          "[svg][svg-cases]") {
    // The curve comes in at a right angle to the line that follows, though the last line along it
    // does not: a miter limit of 1.42 takes the corner (sqrt 2), one of 1.41 cuts it.
    const auto area = [](const char* d, const char* limit) {
        return parse_svg("corner.svg",
                         std::string("<svg><path d='") + d +
                             "' fill='none' stroke='#000' stroke-width='8' stroke-miterlimit='" +
                             limit + "'/></svg>")
            .area;
    };
    for (const char* d :
         {"M4 20C32 30 32 8 32 8L60 8", "M60 8L32 8C32 8 32 30 4 20", "M4 20C32 30 32 8 32 8H4"}) {
        INFO(d);
        CHECK(area(d, "1.42") == Approx(area(d, "9")).epsilon(1e-6));
        CHECK(area(d, "1.41") == Approx(area(d, "1")).epsilon(1e-3));
        CHECK(area(d, "1.41") < area(d, "1.42") * 0.99);
    }
}
