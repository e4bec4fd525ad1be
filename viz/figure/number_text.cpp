#include "lodlab/viz/figure/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "lodlab/core/base/to_chars.hpp"

namespace viz {
namespace {

const std::string minus = "\u2212";
const std::string thin_space = "\u2009";

void drop_trailing_zeros(std::string& text) {
    if (text.find('.') == std::string::npos) return;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
}

std::string grouped(const std::string& text) {
    const std::size_t whole = std::min(text.find('.'), text.size());
    if (whole <= 4) return text;
    std::string out;
    for (std::size_t i = 0; i < whole; ++i) {
        if (i > 0 && (whole - i) % 3 == 0) out += thin_space;
        out += text[i];
    }
    return out + text.substr(whole);
}

}  // namespace

std::string superscript(int exponent) {
    static const std::array<std::string, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += raised[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string number_text(double value, int digits) {
    if (std::isnan(value)) return "not a number";
    const std::string sign = value < 0 ? minus : "";
    const double size = std::abs(value);
    if (std::isinf(size)) return sign + "∞";
    if (size == 0) return "0";
    std::string scientific = lod::number_text(size, std::chars_format::scientific, digits - 1);
    const std::size_t e = scientific.find('e');
    const int exponent = std::atoi(scientific.c_str() + e + 1);  // after rounding
    if (exponent >= 6 || exponent < -4) {
        std::string mantissa = scientific.substr(0, e);
        drop_trailing_zeros(mantissa);
        const std::string power = "10" + superscript(exponent);
        return sign + (mantissa == "1" ? power : mantissa + " × " + power);
    }
    std::string text =
        lod::number_text(size, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
    drop_trailing_zeros(text);
    return sign + grouped(text);
}

std::string quantity_text(double value, const std::string& unit, int digits) {
    return number_text(value, digits) + "\u00A0" + unit;
}

std::string length_text(double metres) {
    const double size = std::abs(metres);
    if (size >= 1000) return quantity_text(metres / 1000, "km");
    if (size >= 0.1 || size == 0) return quantity_text(metres, "m");
    if (size >= 0.01) return quantity_text(metres * 100, "cm");
    if (size >= 1e-4) return quantity_text(metres * 1000, "mm");
    return quantity_text(metres, "m");
}

std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) return number_text(value);
    std::string text = lod::number_text(std::abs(value), std::chars_format::fixed, decimals);
    const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
    return (value < 0 && !is_zero ? minus : "") + text;
}

std::string count_text(long long count, const std::string& noun) {
    const std::string number = grouped(std::to_string(count)) + " ";
    if (count == 1) return number + noun;
    if (noun.ends_with("dy")) return number + noun.substr(0, noun.size() - 1) + "ies";
    return number + noun + "s";
}

}  // namespace viz
