#include "lodlab/lod2d/source/svg/text.hpp"

#include <cmath>
#include <numbers>

#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

double radians(double degrees) {
    return degrees * (std::numbers::pi / 180);
}

/// As SVG writes a matrix: column by column.
Affine from_columns(const std::array<double, 6>& m) {
    return {{m[0], m[2], m[1], m[3]}, {m[4], m[5]}};
}

Affine rotation(double degrees) {
    const lod::SineCosine of =
        lod::sine_cosine(std::remainder(radians(degrees), 2 * std::numbers::pi));
    return from_columns({of.cosine, of.sine, -of.sine, of.cosine, 0, 0});
}

double tangent(double degrees) {
    const lod::SineCosine of =
        lod::sine_cosine(std::remainder(radians(degrees), 2 * std::numbers::pi));
    return of.sine / of.cosine;
}

Affine one_transform(std::string_view name, const std::vector<double>& v, const SvgReader& reader) {
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) return from_columns({v[0], v[1], v[2], v[3], v[4], v[5]});
    if (name == "translate" && (n == 1 || n == 2))
        return from_columns({1, 0, 0, 1, v[0], n == 2 ? v[1] : 0});
    if (name == "scale" && (n == 1 || n == 2))
        return from_columns({v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0});
    if (name == "rotate" && n == 1) return rotation(v[0]);
    if (name == "rotate" && n == 3)
        return from_columns({1, 0, 0, 1, v[1], v[2]}) * rotation(v[0]) *
               from_columns({1, 0, 0, 1, -v[1], -v[2]});
    if (name == "skewX" && n == 1) return from_columns({1, 0, tangent(v[0]), 1, 0, 0});
    if (name == "skewY" && n == 1) return from_columns({1, tangent(v[0]), 0, 1, 0, 0});
    reader.fail("matrix, translate, scale, rotate, skewX or skewY with their numbers before this");
}

}  // namespace

void SvgReader::skip_spaces() {
    while (is_space(peek())) ++place_;
}

void SvgReader::skip_separator() {
    skip_spaces();
    if (peek() == ',') ++place_;
    skip_spaces();
}

bool SvgReader::at_end() {
    skip_spaces();
    return place_ >= text_.size();
}

bool SvgReader::take_if(char c) {
    if (peek() != c) return false;
    ++place_;
    return true;
}

bool SvgReader::number_follows() {
    const char c = peek();
    return is_digit(c) || c == '.' || c == '-' || c == '+';
}

double SvgReader::number() {
    std::size_t digits = place_;
    if (peek() == '-' || peek() == '+') ++digits;
    const bool dot = digits < text_.size() && text_[digits] == '.';
    const std::size_t first = digits + (dot ? 1 : 0);
    if (first >= text_.size() || !is_digit(text_[first])) fail("a number");
    double value = 0;
    const auto [end, failure] =
        lod::from_chars(text_.data() + digits, text_.data() + text_.size(), value);
    if (failure != std::errc{}) fail("a number within double's range");
    const bool negative = peek() == '-';
    place_ = static_cast<std::size_t>(end - text_.data());
    return negative ? -value : value;
}

bool SvgReader::flag() {
    if (peek() != '0' && peek() != '1') fail("a flag (0 or 1)");
    return take() == '1';
}

std::string_view SvgReader::letters() {
    const std::size_t start = place_;
    while (is_letter(peek())) ++place_;
    return text_.substr(start, place_ - start);
}

void SvgReader::fail(const char* expected) const {
    throw SvgTextError{expected, place_};
}

Affine parse_svg_transform(std::string_view text) {
    SvgReader reader(text);
    Affine result;
    while (!reader.at_end()) {
        const std::string_view name = reader.letters();
        if (name == "none" && reader.at_end()) break;
        reader.skip_spaces();
        if (!reader.take_if('(')) reader.fail("a transform such as translate(1,2)");
        std::vector<double> values;
        reader.skip_spaces();
        while (reader.number_follows()) {
            values.push_back(reader.number());
            reader.skip_separator();
        }
        if (!reader.take_if(')')) reader.fail("a number or )");
        result = result * one_transform(name, values, reader);
        reader.skip_separator();
    }
    return result;
}

std::vector<Point> parse_svg_points(std::string_view text) {
    SvgReader reader(text);
    std::vector<Point> points;
    while (!reader.at_end()) {
        const double x = reader.number();
        reader.skip_separator();
        if (reader.at_end()) break;
        points.emplace_back(x, reader.number());
        reader.skip_separator();
    }
    return points;
}

std::array<double, 4> parse_svg_view_box(std::string_view text) {
    SvgReader reader(text);
    std::array<double, 4> box{};
    reader.skip_spaces();
    for (double& value : box) {
        value = reader.number();
        reader.skip_separator();
    }
    if (!reader.at_end()) reader.fail("four numbers");
    return box;
}

double parse_svg_length(std::string_view text, double percent_of) {
    struct Unit {
        std::string_view name;
        double pixels;
    };
    static constexpr Unit units[] = {
        {"", 1},           {"px", 1},  {"pt", 4.0 / 3}, {"pc", 16}, {"mm", 96 / 25.4},
        {"cm", 96 / 2.54}, {"in", 96}, {"em", 16},      {"ex", 8},  {"rem", 16}};
    SvgReader reader(text);
    reader.skip_spaces();
    const double value = reader.number();
    if (reader.take_if('%')) return value / 100 * percent_of;
    const std::string_view name = reader.letters();
    if (!reader.at_end()) reader.fail("a length");
    for (const Unit& unit : units)
        if (unit.name == name) return value * unit.pixels;
    reader.fail("a unit px, pt, pc, mm, cm, in, em, ex or % before this");
}

}  // namespace lod2d
