#include "lodlab/core/base/from_chars.hpp"

#include <version>

#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
namespace lod {

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
    return std::from_chars(first, last, value);
}

}  // namespace lod
#else
#include <fast_float/fast_float.h>

#include <cmath>
#include <string_view>
#include <system_error>

namespace lod {
namespace {

/// Whether a number as written, not inf or nan, is other than zero.
bool has_digits(std::string_view number) {
    const std::string_view before_exponent = number.substr(0, number.find_first_of("eE"));
    return before_exponent.find_first_of("123456789") != std::string_view::npos;
}

}  // namespace

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
    double read = 0;
    const auto [end, failure] = fast_float::from_chars(first, last, read);
    if (failure != std::errc{}) return {end, failure};
    // Older releases (3.9) say nothing when a number is out of range.
    if ((read == 0 || std::isinf(read)) &&
        has_digits(std::string_view(first, static_cast<std::size_t>(end - first))))
        return {end, std::errc::result_out_of_range};
    value = read;
    return {end, failure};
}

}  // namespace lod
#endif
