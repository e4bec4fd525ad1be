#include "lodlab/lod3d/source/text_words.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/from_chars.hpp"

namespace lod3d {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// What a number beyond double's range rounds to.
double beyond_range(std::string_view digits) {
    const bool tiny = digits.find("e-") != std::string_view::npos ||
                      digits.find("E-") != std::string_view::npos || digits.starts_with("0.") ||
                      digits.starts_with('.');
    return tiny ? 0 : std::numeric_limits<double>::infinity();
}

/// Whether what follows "nan", or a number, is how some C library writes what is no number.
bool marks_no_number(std::string_view rest) {
    return rest.starts_with("#") || (rest.starts_with("(") && rest.ends_with(")"));
}

}  // namespace

std::string_view TextWords::next() {
    for (;;) {
        const std::string_view word = next_on_line();
        if (!word.empty() || at_end()) return word;
        skip_line();
    }
}

std::string_view TextWords::next_on_line() {
    while (!at_end() && is_blank(text_[place_])) ++place_;
    if (at_end() || is_line_end(text_[place_])) return {};
    const bool comment = comments_ == Comments::after_hash && text_[place_] == '#';
    const std::size_t first = place_;
    while (!at_end() && !is_line_end(text_[place_]) && (comment || !is_blank(text_[place_])))
        ++place_;
    return comment ? std::string_view() : text_.substr(first, place_ - first);
}

void TextWords::skip_line() {
    while (!at_end() && !is_line_end(text_[place_])) ++place_;
    if (at_end()) return;
    place_ += text_.substr(place_).starts_with("\r\n") ? 2 : 1;
    ++line_;
}

std::optional<double> number_in(std::string_view word) {
    constexpr std::size_t longest_with_comma = 64;
    std::string with_point;
    const std::size_t comma = word.find(',');
    if (comma != std::string_view::npos && word.size() <= longest_with_comma) {
        with_point = word;
        with_point[comma] = '.';
        word = with_point;
    }
    const bool negative = word.starts_with('-');
    if (negative || word.starts_with('+')) word.remove_prefix(1);
    if (word.empty() || word[0] == '-') return {};
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [after, failure] = lod::from_chars(word.data(), end, value);
    if (failure == std::errc::result_out_of_range)
        value = beyond_range(word);
    else if (failure != std::errc())
        return {};
    if (after != end) {
        if (!marks_no_number({after, static_cast<std::size_t>(end - after)})) return {};
        value = std::numeric_limits<double>::quiet_NaN();
    }
    return negative ? -value : value;
}

WrittenDigits digits_of(std::string_view word) {
    constexpr int most = 400;  // decimals of a double
    WrittenDigits digits;
    bool after_point = false;
    std::size_t at = 0;
    for (; at < word.size() && word[at] != 'e' && word[at] != 'E'; ++at) {
        if (word[at] == '.' || word[at] == ',') after_point = true;
        if (word[at] < '0' || word[at] > '9') continue;
        if (digits.significant > 0 || word[at] != '0') ++digits.significant;
        if (after_point) ++digits.decimals;
    }
    const std::int64_t exponent =
        at < word.size() ? integer_in(word.substr(at + 1)).value_or(0) : 0;
    digits.decimals = static_cast<int>(std::clamp<std::int64_t>(
        digits.decimals - std::clamp<std::int64_t>(exponent, -most, most), -most, most));
    return digits;
}

std::optional<std::int64_t> integer_in(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    std::int64_t value = 0;
    const auto [after, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || after != word.data() + word.size()) return {};
    return value;
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 30;
    std::string text(word.substr(0, longest));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return '"' + text + (word.size() > longest ? "...\"" : "\"");
}

bool is_word(std::string_view word, std::string_view other) {
    return std::equal(word.begin(), word.end(), other.begin(), other.end(),
                      [](char a, char b) { return lower(a) == b; });
}

std::string_view text_in(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        lod::refuse_input(name, "is a text in UTF-16; save it as UTF-8 or ASCII");
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    return bytes;
}

}  // namespace lod3d
