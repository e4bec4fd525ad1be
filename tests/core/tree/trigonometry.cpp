#include "lodlab/core/math/trigonometry.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace lod;

namespace {

constexpr double pi = std::numbers::pi;

/// Error in units in the last place of the exact value.
double ulps(double value, long double exact) {
    const int exponent = std::ilogb(static_cast<double>(exact));
    return static_cast<double>(std::abs(value - exact) / std::ldexp(1.0L, exponent - 52));
}

/// The larger error of sine and cosine against the C library in extended precision.
double worst_ulps(double angle) {
    const SineCosine of = sine_cosine(angle);
    const long double x = angle;
    return std::max(ulps(of.sine, std::sin(x)), ulps(of.cosine, std::cos(x)));
}

// Where long double is no wider than double, its own error adds half a unit or more.
constexpr double bound = std::numeric_limits<long double>::digits > 53 ? 2.0 : 3.0;

}  // namespace

TEST_CASE("sine and cosine are within 2 units in the last place up to a million radians",
          "[trigonometry]") {
    lodtest::Random random(1);
    for (const double range : {0.8, 10.0, 1e3, 1e6}) {
        double worst = 0;
        for (int i = 0; i < 100000; ++i)
            worst = std::max(worst, worst_ulps(random.in(-range, range)));
        INFO("range " << range);
        CHECK(worst <= bound);
    }
}

TEST_CASE("sine and cosine hold their bound next to every quarter turn", "[trigonometry]") {
    double worst = 0;
    for (int quarter = 1; quarter < 636000; quarter += quarter < 2000 ? 1 : 97) {
        const double near = quarter * (pi / 2);
        const double infinity = std::numeric_limits<double>::infinity();
        for (const double angle : {std::nextafter(near, 0.0), near, std::nextafter(near, infinity)})
            worst = std::max(worst, worst_ulps(angle));
    }
    CHECK(worst <= bound);
}

TEST_CASE("sine and cosine are exact where they must be", "[trigonometry]") {
    CHECK(sine_cosine(0).sine == 0);
    CHECK(sine_cosine(0).cosine == 1);
    CHECK(sine_cosine(1e-300).sine == 1e-300);
    lodtest::Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const double angle = random.in(-100, 100);
        CHECK(sine_cosine(-angle).sine == -sine_cosine(angle).sine);
        CHECK(sine_cosine(-angle).cosine == sine_cosine(angle).cosine);
    }
}

TEST_CASE("an absurd angle still has a sine and a cosine on the unit circle", "[trigonometry]") {
    for (const double angle : {1e7, -1e16, 1e100, -1.7e308}) {
        const SineCosine of = sine_cosine(angle);
        CHECK(std::abs(of.sine * of.sine + of.cosine * of.cosine - 1) < 1e-15);
    }
    // Twenty million radians: 3 million turns of a double 2 pi that is off by 2.4e-16.
    CHECK(std::abs(sine_cosine(2e7).sine - static_cast<double>(std::sin(2e7L))) < 2e7 * 4e-17);
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(std::isnan(sine_cosine(infinity).sine));
    CHECK(std::isnan(sine_cosine(std::nan("")).cosine));
}

TEST_CASE("a wrapped angle differs by whole turns and stays within half a turn", "[trigonometry]") {
    const long double turn = 2 * std::numbers::pi_v<long double>;
    lodtest::Random random(3);
    const auto check = [&](double angle) {
        const double wrapped = wrapped_angle(angle);
        CHECK(wrapped >= -pi);
        CHECK(wrapped <= pi);
        const long double turns = std::round((angle - static_cast<long double>(wrapped)) / turn);
        const auto off = std::abs(angle - turns * turn - wrapped);
        // The rounding of the result, and of long double's own pi over that many turns.
        CHECK(static_cast<double>(off) <= 1e-15 + std::abs(angle) * 1e-19);
    };
    for (int i = 0; i < 20000; ++i) check(random.in(-1e3, 1e3));
    const double infinity = std::numeric_limits<double>::infinity();
    for (int odd = -1001; odd <= 1001; odd += 2)
        for (const double angle :
             {std::nextafter(odd * pi, -infinity), odd * pi, std::nextafter(odd * pi, infinity)})
            check(angle);
}

TEST_CASE("an angle within half a turn is not touched", "[trigonometry]") {
    for (const double angle : {0.0, -pi, pi, 1.0, -3.0}) CHECK(wrapped_angle(angle) == angle);
    for (const double angle : {1e10, -1e200}) CHECK(std::abs(wrapped_angle(angle)) <= pi);
}

namespace {

/// How far from the exact value, in units in the last place of it.
double ulps_off(double value, long double exact) {
    const double size = static_cast<double>(std::abs(exact));
    const double ulp = std::nextafter(size, 10.0) - size;
    return static_cast<double>(std::abs(value - exact) / ulp);
}

}  // namespace

TEST_CASE("the angle of a direction is within 3 units in the last place", "[trigonometry]") {
    lodtest::Random random(31);
    double worst = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        const double scale = std::ldexp(1.0, random.below(60) - 30);
        const double x = random.in(-1, 1) * (trial % 3 == 0 ? scale : 1);
        const double y = random.in(-1, 1) * (trial % 3 == 1 ? scale : 1);
        const long double exact =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        worst = std::max(worst, ulps_off(lod::direction_angle(y, x), exact));
    }
    CAPTURE(worst);
    CHECK(worst <= 3);
    CHECK(worst > 0.3);  // the measure sees something
}

TEST_CASE("the angle of a direction has the signs and zeros of atan2", "[trigonometry]") {
    for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-310, 1e300})
        for (const double x : {0.0, -0.0, 1.0, -1.0, -1e-310, -1e300, 0.5}) {
            CAPTURE(y, x);
            const double expected = std::atan2(y, x);
            const double found = lod::direction_angle(y, x);
            CHECK(std::signbit(found) == std::signbit(expected));
            CHECK(found == Approx(expected).epsilon(1e-15));
        }
    CHECK(std::isnan(lod::direction_angle(std::nan(""), 1)));
    CHECK(std::isnan(lod::direction_angle(1, std::numeric_limits<double>::infinity())));
}

TEST_CASE("the angle of a cosine is the inverse of the cosine", "[trigonometry]") {
    for (int i = -1000; i <= 1000; ++i) {
        const double c = i / 1000.0;
        CHECK(lod::angle_of_cosine(c) == Approx(std::acos(c)).margin(4e-16).epsilon(1e-15));
    }
}

TEST_CASE("many angles at once have the bits of each alone", "[trigonometry]") {
    Random random(41);
    std::vector<double> angles{0, -0.0, pi, -pi, 1e6, 2e6, -3e9};
    for (const std::size_t count : {0, 1, 15, 16, 17, 1000}) {
        while (angles.size() < count) angles.push_back(random.in(-20, 20));
        std::vector<SineCosine> results(angles.size());
        sine_cosine(angles, results);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const SineCosine alone = sine_cosine(angles[i]);
            REQUIRE(results[i].sine == alone.sine);
            REQUIRE(results[i].cosine == alone.cosine);
        }
    }
    SineCosine nowhere{0, 0};
    sine_cosine(std::vector<double>{std::numeric_limits<double>::quiet_NaN()}, {&nowhere, 1});
    CHECK(std::isnan(nowhere.sine));
}
