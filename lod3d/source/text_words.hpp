#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lod3d {

/// Goes through a text word by word; words are separated by blanks and line ends (LF, CR LF or CR).
/// Where there are comments, a '#' at the beginning of a word hides the rest of its line.
/// A copy remembers its place. Views the text, which must outlive it.
class TextWords {
  public:
    enum class Comments { none, after_hash };
    TextWords(std::string_view text, Comments comments) : text_(text), comments_(comments) {}

    /// The next word, on whatever line; empty at the end of the text.
    std::string_view next();
    /// The next word of the present line; empty at the line's end, which is not passed.
    std::string_view next_on_line();
    /// Passes the end of the present line, whatever stands before it.
    void skip_line();
    /// Goes back by so many letters of the last word.
    void step_back(std::size_t letters) { place_ -= letters; }

    [[nodiscard]] std::uint64_t line() const { return line_; }  ///< of the last word; from 1
    [[nodiscard]] std::size_t place() const { return place_; }  ///< after the last word [bytes]
    [[nodiscard]] bool at_end() const { return place_ >= text_.size(); }

  private:
    std::string_view text_;
    Comments comments_;
    std::size_t place_ = 0;
    std::uint64_t line_ = 1;
};

/// The nearest double to a word that is a number as a whole, in any locale, also with a decimal
/// comma; infinite beyond double's range, NaN for the ways in which programs write that.
[[nodiscard]] std::optional<double> number_in(std::string_view word);

/// How finely a number is written.
struct WrittenDigits {
    int significant = 0;  ///< from the first that is not 0
    int decimals = 0;     ///< after the point, the exponent counted in: 2 for 0.25e0 and 25e-2
};
/// Requires: number_in(word).
[[nodiscard]] WrittenDigits digits_of(std::string_view word);

/// The whole number that a word is.
[[nodiscard]] std::optional<std::int64_t> integer_in(std::string_view word);

/// A word as a refusal may quote it: one line, in quotes, cut after 30 letters.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Whether a word is another one, which is in lower case, in whatever case.
[[nodiscard]] bool is_word(std::string_view word, std::string_view lower);

/// The text of a file: without a byte order mark. Throws lod::Error (input refused) for UTF-16.
[[nodiscard]] std::string_view text_in(std::string_view bytes, const std::string& name);

}  // namespace lod3d
