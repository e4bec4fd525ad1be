#include "lessons/engine/questions/read_number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "lessons/embed/lines.hpp"
#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lessons {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Signs that stand for plain ones.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> plain_signs{
    {{"−", "-"},
     {"–", "-"},
     {"\u00a0", " "},
     {"\u2009", " "},
     {"\u202f", " "},
     {"²", "2"},
     {"³", "3"},
     {"·", " "},
     {"×", " "},
     {"≈", " "},
     {"~", " "},
     {"=", " "}}};

std::string with_plain_signs(std::string_view text) {
    std::string plain(text);
    for (const auto& [sign, other] : plain_signs)
        for (std::size_t at = plain.find(sign); at != std::string::npos;
             at = plain.find(sign, at + other.size()))
            plain.replace(at, sign.size(), other);
    return trimmed(plain);
}

/// One past the digits, points, commas and groups that begin at `begin`. A space belongs to them
/// before exactly three digits.
std::size_t digits_end(const std::string& text, std::size_t begin) {
    std::size_t end = begin;
    const auto digits_from = [&](std::size_t at) {
        std::size_t count = 0;
        while (at + count < text.size() && is_digit(text[at + count])) ++count;
        return count;
    };
    while (end < text.size()) {
        const char c = text[end];
        const bool joins = c == '.' || c == ',' || c == '\'';
        if (is_digit(c) || (joins && digits_from(end + 1) > 0) || (c == '.' && end > begin))
            ++end;
        else if (c == ' ' && end > begin && digits_from(end + 1) == 3)
            end += 4;
        else
            break;
    }
    return end;
}

/// Whether every group after the first sign has three digits, and the first has one to three.
bool is_grouped(const std::string& body, char sign) {
    std::size_t begin = 0;
    for (std::size_t at = body.find(sign);; at = body.find(sign, begin)) {
        const std::size_t size = std::min(at, body.size()) - begin;
        if (begin == 0 ? size < 1 || size > 3 : size != 3) return false;
        if (at == std::string::npos) return true;
        begin = at + 1;
    }
}

std::string without(std::string text, char sign) {
    std::erase(text, sign);
    return text;
}

void add_value(std::vector<double>& values, std::string body) {
    for (char& c : body)
        if (c == ',') c = '.';
    double value = 0;
    const auto [end, error] = lod::from_chars(body.data(), body.data() + body.size(), value);
    if (error == std::errc() && end == body.data() + body.size() && std::isfinite(value))
        values.push_back(value);
}

/// The readings of digits with points, commas and groups.
std::vector<double> readings_of(std::string body) {
    std::vector<double> values;
    body = without(without(std::move(body), ' '), '\'');
    const std::size_t point = body.rfind('.');
    const std::size_t comma = body.rfind(',');
    if (point == std::string::npos && comma == std::string::npos) {
        add_value(values, body);
    } else if (point != std::string::npos && comma != std::string::npos) {
        const char last = point > comma ? '.' : ',';
        const char group = point > comma ? ',' : '.';
        const std::size_t cut = std::max(point, comma);
        if (body.find(last) == cut && is_grouped(body.substr(0, cut), group))
            add_value(values, without(body, group));
    } else {
        const char sign = point != std::string::npos ? '.' : ',';
        const bool once = body.find(sign) == body.rfind(sign);
        if (once) add_value(values, body);
        if (body.front() != '0' && is_grouped(body, sign)) add_value(values, without(body, sign));
    }
    return values;
}

/// Takes a number off the front of a text.
std::vector<double> take_number(std::string& text) {
    const std::size_t digits = digits_end(text, 0);
    if (digits == 0) return {};
    std::vector<double> values = readings_of(text.substr(0, digits));
    std::size_t end = digits;
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t power = end + 1;
        if (power < text.size() && (text[power] == '-' || text[power] == '+')) ++power;
        const std::size_t first = power;
        while (power < text.size() && is_digit(text[power])) ++power;
        if (power > first) {
            std::vector<double> scaled;
            std::string exponent = text.substr(end, power - end);
            std::erase(exponent, '+');
            add_value(scaled, without(text.substr(0, digits), ' ') + exponent);
            values = std::move(scaled);
            end = power;
        }
    }
    text.erase(0, end);
    return values;
}

constexpr double degree = lod::full_turn / 360;
struct Row {
    std::string_view unit;
    UnitSize size;
};
constexpr std::array<Row, 46> rows{{
    {"", {"share", 1}},
    {"%", {"share", 0.01}},
    {"percent", {"share", 0.01}},
    {"mm", {"length", 1e-3}},
    {"cm", {"length", 1e-2}},
    {"dm", {"length", 1e-1}},
    {"m", {"length", 1}},
    {"metre", {"length", 1}},
    {"metres", {"length", 1}},
    {"meter", {"length", 1}},
    {"meters", {"length", 1}},
    {"km", {"length", 1e3}},
    {"mm2", {"area", 1e-6}},
    {"cm2", {"area", 1e-4}},
    {"m2", {"area", 1}},
    {"ms", {"time", 1e-3}},
    {"s", {"time", 1}},
    {"second", {"time", 1}},
    {"seconds", {"time", 1}},
    {"g", {"mass", 1e-3}},
    {"kg", {"mass", 1}},
    {"mm/s", {"speed", 1e-3}},
    {"cm/s", {"speed", 1e-2}},
    {"m/s", {"speed", 1}},
    {"km/h", {"speed", 1 / 3.6}},
    {"mj", {"energy", 1e-3}},
    {"j", {"energy", 1}},
    {"joule", {"energy", 1}},
    {"nm", {"energy", 1}},
    {"kj", {"energy", 1e3}},
    {"ns", {"impulse", 1}},
    {"kgm/s", {"impulse", 1}},
    {"kgcm/s", {"impulse", 1e-2}},
    {"1/kg", {"compliance", 1}},
    {"kg-1", {"compliance", 1}},
    {"1/g", {"compliance", 1e3}},
    {"rad", {"angle", 1}},
    {"°", {"angle", degree}},
    {"deg", {"angle", degree}},
    {"degree", {"angle", degree}},
    {"degrees", {"angle", degree}},
    {"rad/s", {"spin", 1}},
    {"1/s", {"spin", 1}},
    {"°/s", {"spin", degree}},
    {"kgm2", {"inertia", 1}},
    {"kgm2/s", {"angular momentum", 1}},
}};

}  // namespace

TypedNumber read_number(std::string_view typed) {
    constexpr std::size_t longest = 100;
    TypedNumber number;
    if (typed.size() > longest) return number;
    std::string text = with_plain_signs(typed);
    double sign = 1;
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        sign = text.front() == '-' ? -1 : 1;
        text = trimmed(std::string_view(text).substr(1));
    }
    number.values = take_number(text);
    if (number.values.empty()) return number;
    const std::string rest = trimmed(text);
    if (rest.size() > 1 && rest.front() == '/' && (is_digit(rest[1]) || rest[1] == ' ')) {
        text = trimmed(std::string_view(rest).substr(1));
        const std::vector<double> below = take_number(text);
        if (below.empty() || below.front() == 0) return {};
        for (double& value : number.values) value /= below.front();
    }
    for (double& value : number.values) value *= sign;
    number.unit = plain_unit(text);
    return number;
}

std::string plain_unit(std::string_view unit) {
    std::string plain;
    for (const char c : with_plain_signs(unit))
        if (c != ' ' && c != '^' && c != '*' && c != '.')
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

UnitSize size_of(std::string_view plain_unit) {
    for (const Row& row : rows)
        if (row.unit == plain_unit) return row.size;
    return {{}, 1};
}

}  // namespace lessons
