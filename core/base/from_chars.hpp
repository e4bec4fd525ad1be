#pragma once

#include <charconv>

namespace lod {

/// std::from_chars of a double, for standard libraries that lack it, too (libc++, so a Mac): the
/// nearest double, whatever the locale; `value` stays as it was where no number follows or where it
/// is out of double's range.
[[nodiscard]] std::from_chars_result from_chars(const char* first, const char* last, double& value);

}  // namespace lod
