#pragma once

#include <string>

#include "lessons/engine/lessons.hpp"

namespace lessons {

/// A question of a completed lesson as a form: its words, what the reader chooses or types, and
/// what the page's script grades it by. Without a script it is the question in words.
[[nodiscard]] std::string form_html(const Lesson& lesson, const Question& question,
                                    std::size_t number);

/// Markdown of one paragraph as HTML, without the paragraph's element.
[[nodiscard]] std::string inline_html(const Lesson& lesson, const std::string& markdown);

/// `r_a` in running text becomes an italic letter with its index; tags and code stay as they are.
[[nodiscard]] std::string with_symbols(const std::string& html);

/// A text of a figure (`*v*_a`, viz/figure/figure.hpp) as HTML.
[[nodiscard]] std::string figure_words_html(const std::string& words);

}  // namespace lessons
