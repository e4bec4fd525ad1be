#pragma once

namespace lodtest {

/// Whether the program is built with the address sanitizer, which makes it some ten times slower:
/// tests of many cases take fewer then.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace lodtest
