#include "lodlab/core/base/from_chars.hpp"

#include <limits>
#include <string_view>
#include <system_error>
#include <tuple>

#include "tests/catch.hpp"

namespace {

struct Read {
    double value = -7;
    std::errc failure{};
    std::size_t length = 0;
};

Read read(std::string_view text) {
    Read result;
    const auto [end, failure] =
        lod::from_chars(text.data(), text.data() + text.size(), result.value);
    result.failure = failure;
    result.length = static_cast<std::size_t>(end - text.data());
    return result;
}

}  // namespace

TEST_CASE("a number ends where its letters do", "[from_chars]") {
    for (const auto& [text, value, length] :
         {std::tuple{"0.1", 0.1, 3},
          {"-5.", -5.0, 3},
          {".5,6", 0.5, 2},
          {"1e", 1.0, 1},
          {"0x10", 0.0, 1},
          {"0e999", 0.0, 5},
          {"4.9e-324", 4.9406564584124654e-324, 8},
          {"inf", std::numeric_limits<double>::infinity(), 3}}) {
        INFO(text);
        CHECK(read(text).failure == std::errc{});
        CHECK(read(text).value == value);
        CHECK(read(text).length == static_cast<std::size_t>(length));
    }
}

TEST_CASE("what is no number, or beyond double, leaves the value as it was", "[from_chars]") {
    for (const char* text : {"", "x", "+1", " 1"}) {
        INFO(text);
        CHECK(read(text).failure == std::errc::invalid_argument);
        CHECK(read(text).value == -7);
        CHECK(read(text).length == 0);
    }
    for (const std::string_view text : {"1e400", "-1e400", "1e-400", "2e-324"}) {
        INFO(text);
        CHECK(read(text).failure == std::errc::result_out_of_range);
        CHECK(read(text).value == -7);
        CHECK(read(text).length == text.size());
    }
}
