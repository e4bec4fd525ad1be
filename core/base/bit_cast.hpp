#pragma once

#include <type_traits>

namespace lod {

/// std::bit_cast, for standard libraries that lack it, too (libc++ before 14).
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}

}  // namespace lod
