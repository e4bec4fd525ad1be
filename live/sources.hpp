#pragma once

/// \file
/// Which sources this is made of: the WebAssembly module comes from another build than the page
/// that holds it, and may be older.

namespace live {

/// SHA-256 over all that the module is made of, as it was when this was built: 64 hexadecimal
/// digits.
[[nodiscard]] const char* sources();

}  // namespace live
