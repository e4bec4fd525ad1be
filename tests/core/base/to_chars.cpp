#include "lodlab/core/base/to_chars.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include "lodlab/core/base/bit_cast.hpp"
#include "tests/property.hpp"

// The oracle is the standard library of this machine, which has what libc++ lacks.

namespace {

using Limits = std::numeric_limits<double>;
using Text = std::array<char, 2000>;

std::string shortest(double value, std::to_chars_result (*to_chars)(char*, char*, double)) {
    Text text;
    return {text.data(), to_chars(text.data(), text.data() + text.size(), value).ptr};
}

bool same_shortest(double value) {
    const std::string expected = shortest(value, std::to_chars);
    return shortest(value, lod::by_printf::to_chars) == expected &&
           shortest(value, lod::to_chars) == expected;
}

bool same_rounded(double value, std::chars_format format, int precision) {
    Text ours;
    Text theirs;
    const auto our_end =
        lod::by_printf::to_chars(ours.data(), ours.data() + ours.size(), value, format, precision);
    const auto their_end =
        std::to_chars(theirs.data(), theirs.data() + theirs.size(), value, format, precision);
    return std::string_view(ours.data(), static_cast<std::size_t>(our_end.ptr - ours.data())) ==
           std::string_view(theirs.data(), static_cast<std::size_t>(their_end.ptr - theirs.data()));
}

}  // namespace

TEST_CASE("by printf any double has the same shortest text as by the standard library",
          "[to_chars]") {
    check_property(2200, 20000, [](std::uint64_t bits) {
        RC_ASSERT(same_shortest(lod::bit_cast<double>(bits)));
    });
    // rapidcheck's numbers are small at first; these have every bit at random.
    std::uint64_t bits = 2201;
    for (int i = 0; i < 100000; ++i) {
        bits = 6364136223846793005ULL * bits + 1442695040888963407ULL;
        const double value = lod::bit_cast<double>(bits ^ (bits >> 29));
        if (!same_shortest(value)) FAIL(shortest(value, std::to_chars));
    }
}

TEST_CASE("by printf numbers of few digits, powers of two and whole numbers have that text, too",
          "[to_chars]") {
    for (int exponent = -1074; exponent < 1024; ++exponent) {
        const double power = std::ldexp(1.0, exponent);
        for (const double value : {power, -power, std::nextafter(power, 0.0), 3 * power})
            if (!same_shortest(value)) FAIL(shortest(value, std::to_chars));
    }
    for (const double value : {1e-5, 1e-4, 0.001, 12.0, 120000.0, 1e5, 1e6, 123456.0, 1e22, 1e23,
                               9.5e15, 5e-324, 0.3, 123456789012.0}) {
        for (const double sum : {value, -value, 7 * value, value + 0.1})
            if (!same_shortest(sum)) FAIL(shortest(sum, std::to_chars));
    }
    check_property(2202, 5000, [](std::int64_t whole) {
        RC_ASSERT(same_shortest(static_cast<double>(whole)));
        RC_ASSERT(same_shortest(static_cast<double>(whole) / 1000));
    });
    for (const double value : {0.0, -0.0, Limits::infinity(), -Limits::infinity(),
                               Limits::quiet_NaN(), Limits::max(), Limits::min()})
        CHECK(same_shortest(value));
}

TEST_CASE("by printf a number of so many digits is the standard library's", "[to_chars]") {
    using enum std::chars_format;
    check_property(2203, 5000, [](std::uint64_t bits, std::uint8_t digits) {
        const double value = lod::bit_cast<double>(bits);
        for (const double number : {value, std::fmod(value, 1e6)})
            for (const std::chars_format format : {fixed, scientific, general})
                RC_ASSERT(same_rounded(number, format, digits % 20));
    });
}

TEST_CASE("a text that has no room is not begun", "[to_chars]") {
    std::array<char, 3> room{'a', 'b', 'c'};
    const auto result = lod::by_printf::to_chars(room.data(), room.data() + room.size(), 0.25);
    CHECK(result.ec == std::errc::value_too_large);
    CHECK(result.ptr == room.data() + room.size());
    CHECK(room == std::array{'a', 'b', 'c'});
}

TEST_CASE("a number as a text of its own holds the longest of its format", "[to_chars]") {
    CHECK(lod::number_text(0.1) == "0.1");
    CHECK(lod::number_text(-1e22) == "-1e+22");
    CHECK(lod::number_text(-5e-324) == "-5e-324");
    CHECK(lod::number_text(2.0 / 3, std::chars_format::fixed, 2) == "0.67");
    CHECK(lod::number_text(1234.5, std::chars_format::general, 3) == "1.23e+03");
    const double largest = std::numeric_limits<double>::max();
    const std::string text = lod::number_text(-largest, std::chars_format::fixed, 10);
    CHECK(text.size() == 1 + 309 + 1 + 10);
    CHECK(text.substr(0, 6) == "-17976");
}
