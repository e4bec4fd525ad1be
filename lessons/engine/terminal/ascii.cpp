#include "lessons/engine/terminal/ascii.hpp"

#include <array>
#include <utility>

namespace lessons {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 40> forms{{
    {"\u00a0", " "}, {"\u2009", " "}, {"\u202f", " "}, {"−", "-"},    {"–", "-"},
    {"⁻", "^-"},     {"×", "x"},      {"·", "."},      {"²", "^2"},   {"³", "^3"},
    {"≤", "<="},     {"≥", ">="},     {"≈", "~"},      {"√", "sqrt"}, {"°", " deg"},
    {"ᵀ", "^T"},     {"ω", "omega"},  {"“", "\""},     {"”", "\""},   {"’", "'"},
    {"‘", "'"},      {"→", "->"},     {"←", "<-"},     {"…", "..."},  {"⁰", "0"},
    {"¹", "1"},      {"⁴", "4"},      {"⁵", "5"},      {"⁶", "6"},    {"⁷", "7"},
    {"⁸", "8"},      {"⁹", "9"},      {"é", "e"},      {"ä", "a"},    {"ö", "o"},
    {"ü", "u"},      {"½", "1/2"},    {"¼", "1/4"},    {"π", "pi"},   {"Δ", "delta "},
}};

std::string_view form_of(std::string_view character) {
    for (const auto& [sign, form] : forms)
        if (sign == character) return form;
    return "?";
}

/// Bytes of a character by its first one.
std::size_t length_of(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
}

}  // namespace

AsciiBuffer::int_type AsciiBuffer::overflow(int_type c) {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    if (static_cast<unsigned char>(byte) < 0x80U) {
        pending_.clear();
        return to_->sputc(byte);
    }
    pending_ += byte;
    if (pending_.size() < length_of(pending_[0])) return c;
    const std::string_view form = form_of(pending_);
    pending_.clear();
    const bool whole = to_->sputn(form.data(), static_cast<std::streamsize>(form.size())) ==
                       static_cast<std::streamsize>(form.size());
    return whole ? c : traits_type::eof();
}

int AsciiBuffer::sync() {
    return to_->pubsync();
}

}  // namespace lessons
