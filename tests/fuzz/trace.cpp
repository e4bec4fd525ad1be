// Traces of runs.
#include "lodlab/scenes/trace.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        static_cast<void>(scenes::parse_trace(text, "trace.json"));
    });
}
