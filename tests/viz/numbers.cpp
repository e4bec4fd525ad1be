#include "lodlab/viz/figure/number_text.hpp"

#include <limits>

#include "lodlab/viz/draw/motion/draw_plot.hpp"
#include "lodlab/viz/paint/plot.hpp"
#include "tests/catch.hpp"

using namespace viz;

TEST_CASE("numbers are rounded to their significant digits", "[numbers]") {
    CHECK(number_text(1.0 / 3) == "0.333");
    CHECK(number_text(1234.5, 6) == "1234.5");
    CHECK(number_text(0.000098) == "9.8 × 10⁻⁵");
    CHECK(number_text(2e7) == "2 × 10⁷");
    CHECK(number_text(1e7) == "10⁷");
    CHECK(number_text(999999.9) == "10⁶");
    CHECK(number_text(0) == "0");
}

TEST_CASE("every digit of an exponent is raised, and its minus", "[numbers]") {
    CHECK(superscript(0) == "⁰");
    CHECK(superscript(-16) == "⁻¹⁶");
    CHECK(superscript(1234567890) == "¹²³⁴⁵⁶⁷⁸⁹⁰");
}

TEST_CASE("negative numbers have a true minus, and zero has none", "[numbers]") {
    CHECK(number_text(-2.5) == "\u22122.5");
    CHECK(fixed_text(-0.001, 2) == "0.00");
    CHECK(fixed_text(-0.5, 2) == "\u22120.50");
}

TEST_CASE("what is no number is said in words", "[numbers]") {
    CHECK(number_text(std::numeric_limits<double>::quiet_NaN()) == "not a number");
    CHECK(number_text(-std::numeric_limits<double>::infinity()) == "\u2212∞");
}

TEST_CASE("lengths take the unit that suits them", "[numbers]") {
    CHECK(length_text(2) == "2\u00A0m");
    CHECK(length_text(0.05) == "5\u00A0cm");
    CHECK(length_text(0.003) == "3\u00A0mm");
    CHECK(length_text(4000) == "4\u00A0km");
}

TEST_CASE("one thing is singular", "[numbers]") {
    CHECK(count_text(1, "circle") == "1 circle");
    CHECK(count_text(1, "body") == "1 body");
    CHECK(count_text(2, "body") == "2 bodies");
    CHECK(count_text(12345, "circle") == "12\u2009345 circles");
}

TEST_CASE("ticks are round numbers within the axis", "[numbers]") {
    std::vector<std::string> words;
    for (const Tick& tick : ticks_of(Axis{}, 0.13, 1.1, 5)) words.push_back(tick.words);
    CHECK(words == std::vector<std::string>{"0.2", "0.4", "0.6", "0.8", "1.0"});
}

TEST_CASE("a logarithmic axis has its ticks at powers of ten", "[numbers]") {
    Axis axis;
    axis.scale = Scale::logarithmic;
    std::vector<double> at;
    for (const Tick& tick : ticks_of(axis, 0.05, 2000, 8)) at.push_back(tick.at);
    REQUIRE(at.size() == 5);
    CHECK(at[0] == Approx(0.1));
    CHECK(at[4] == Approx(1000));
}

TEST_CASE("a curve loses the points that a logarithmic axis cannot show", "[numbers]") {
    Axes axes;
    axes.y.scale = Scale::logarithmic;
    const Panel panel =
        plot_panel("", axes,
                   {{"error",
                     {{0, 1}, {1, 0}, {2, std::numeric_limits<double>::quiet_NaN()}, {3, 0.1}},
                     {},
                     {}}});
    const auto& line = std::get<Polyline>(panel.marks.at(0));
    CHECK(line.points == std::vector<Point>{{0, 1}, {3, 0.1}});
}
