#pragma once

#include <cstddef>
#include <string_view>

namespace lod {

/// The length in bytes of the UTF-8 character at place `at` of a text; 0 where none begins there.
/// Requires: at < text.size().
[[nodiscard]] std::size_t utf8_length(std::string_view text, std::size_t at);

}  // namespace lod
