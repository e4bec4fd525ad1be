#pragma once

#include <cstddef>  // says which standard library this is

/// What a file that computes the method must not be compiled with. The library's own targets never
/// are; this is for a program that includes its headers.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error \
    "lodlab: -ffast-math (-Ofast, -ffinite-math-only, ...) lets the compiler reorder sums and \
forget infinities, so that results change and proofs of a cover fail; compile files that include \
lodlab without it"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error \
    "lodlab: doubles must be rounded at every step, and here they are not (x87?); on 32-bit x86 \
compile with -msse2 -mfpmath=sse"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

// What changes the layout of the types in our headers stands in the name of a variable of the
// library, and everything that includes them asks for it: where the library was built in another
// way, or is another release, the program does not link, instead of writing into memory that is not
// there.
#if defined(_GLIBCXX_DEBUG)
#define LOD_LAYOUT layout_0_1_with_GLIBCXX_DEBUG
#elif defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define LOD_LAYOUT layout_0_1_without_GLIBCXX_USE_CXX11_ABI
#else
#define LOD_LAYOUT layout_0_1
#endif
namespace lod::layout {
enum Few { one };
struct Padded {
    char byte;
    double number;
};
static_assert(sizeof(Few) == sizeof(int) && sizeof(Padded) == 16 && alignof(double) == 8,
              "lodlab: -fshort-enums, -fpack-struct and the like give its types another layout");
extern const char LOD_LAYOUT;
[[gnu::used]] inline const char* const asked_for = &LOD_LAYOUT;
}  // namespace lod::layout

/// For the small functions of the method: they are part of whoever calls them, so that a program's
/// flags decide about the program's own calls alone and leave no second version for the linker.
#if defined(__GNUC__)
#define LOD_INLINE [[gnu::always_inline]] inline
#else
#define LOD_INLINE inline
#endif

/// For functions that return a reference into a parameter that lives on, not into a temporary.
#if defined(__has_cpp_attribute) && __has_cpp_attribute(gnu::no_dangling)
#define LOD_NO_DANGLING [[gnu::no_dangling]]
#else
#define LOD_NO_DANGLING
#endif
