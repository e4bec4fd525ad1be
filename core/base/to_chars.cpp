#include "lodlab/core/base/to_chars.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>
#include <version>

#include "lodlab/core/base/from_chars.hpp"

namespace lod {
namespace by_printf {
namespace {

std::to_chars_result put(const std::string& text, char* first, char* last) {
    if (last - first < static_cast<std::ptrdiff_t>(text.size()))
        return {last, std::errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), std::errc{}};
}

/// "-1.25e-07", as printf has it, with a point in every locale.
std::string printed(double value, std::chars_format format, int precision) {
    const char* const form = format == std::chars_format::fixed        ? "%.*f"
                             : format == std::chars_format::scientific ? "%.*e"
                                                                       : "%.*g";
    const int length = std::snprintf(nullptr, 0, form, precision, value);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    std::snprintf(text.data(), text.size(), form, precision, value);
    text.pop_back();
    if (!std::isfinite(value)) return text;
    const std::size_t point = text.find_first_not_of("-0123456789e");
    if (point != std::string::npos && text[point] != '+') {  // a locale's point may be long
        const std::size_t after = text.find_first_of("0123456789", point);
        text.replace(point, after - point, ".");
    }
    return text;
}

bool reads_as(const std::string& text, double value) {
    double read = 0;
    const auto end = from_chars(text.data(), text.data() + text.size(), read);
    return end.ec == std::errc{} && read == value;
}

/// The next decimal number away from zero of as many digits: "1.09e+05" after "1.08e+05".
std::string next_after(std::string scientific) {
    const std::size_t e = scientific.find('e');
    for (std::size_t i = e; i-- > 0;) {
        char& c = scientific[i];
        if (c < '0' || c > '9') continue;
        if (c < '9') {
            ++c;
            return scientific;
        }
        c = '0';
    }
    return scientific;  // all nines: fewer digits would do
}

/// As scientific text of the fewest digits that is read as the number, the nearest of those. The
/// numbers below a power of two are closer together than those above, so that the nearest decimal
/// number may be read as another one while the next, further above, is not.
std::string shortest_scientific(double value) {
    for (int digits = 1; digits < 17; ++digits) {
        const std::string text = printed(value, std::chars_format::scientific, digits - 1);
        if (reads_as(text, value)) return text;
        const std::string next = next_after(text);
        if (reads_as(next, value)) return next;
    }
    return printed(value, std::chars_format::scientific, 16);
}

/// The digits of a scientific text without an exponent. Large whole numbers have all their digits.
std::string in_full(const std::string& scientific, double value) {
    const std::size_t e = scientific.find('e');
    const int exponent = std::atoi(scientific.c_str() + e + 1);
    std::string digits = scientific.substr(0, e);
    const std::string sign = digits.front() == '-' ? "-" : "";
    digits.erase(0, sign.size());
    if (digits.size() > 1) digits.erase(1, 1);
    const int after_point = static_cast<int>(digits.size()) - 1 - exponent;
    if (after_point <= 0) return printed(value, std::chars_format::fixed, 0);
    if (exponent < 0) digits.insert(0, static_cast<std::size_t>(-exponent), '0');
    return sign + digits.insert(static_cast<std::size_t>(std::max(exponent, 0)) + 1, 1, '.');
}

}  // namespace

std::to_chars_result to_chars(char* first, char* last, double value) {
    if (!std::isfinite(value) || value == 0)
        return put(printed(value, std::chars_format::fixed, 0), first, last);
    const std::string scientific = shortest_scientific(value);
    const std::string full = in_full(scientific, value);
    return put(full.size() <= scientific.size() ? full : scientific, first, last);
}

std::to_chars_result to_chars(char* first, char* last, double value, std::chars_format format,
                              int precision) {
    return put(printed(value, format, precision), first, last);
}

}  // namespace by_printf

#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
namespace available = std;
#else
namespace available = by_printf;
#endif

std::to_chars_result to_chars(char* first, char* last, double value) {
    return available::to_chars(first, last, value);
}

std::to_chars_result to_chars(char* first, char* last, double value, std::chars_format format,
                              int precision) {
    return available::to_chars(first, last, value, format, precision);
}

std::string number_text(double value) {
    std::array<char, 32> text;
    return {text.data(), lod::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string number_text(double value, std::chars_format format, int precision) {
    std::array<char, 400> text;  // 309 digits before the point
    return {text.data(),
            lod::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr};
}

}  // namespace lod
