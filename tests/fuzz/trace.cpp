// Traces of runs: a text as it is, and with the checks of its lines put right, which no random
// change would come through.
#include "lodlab/scenes/trace/trace.hpp"

#include "lodlab/core/math/bit_hash.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

/// The text with right checks, of as many bytes.
std::string with_checks(std::string_view text) {
    constexpr std::string_view mark = ",\"check\":\"";
    std::string right(text);
    std::size_t line = 0;
    for (std::size_t at = right.find(mark); at != std::string::npos;
         at = right.find(mark, at + 1)) {
        const std::size_t end = right.find('\n', at);
        if (end == std::string::npos || end < at + mark.size() + 16) break;
        lod::BitHash hash;
        const std::size_t object = right.find('{', line);
        if (object < at) hash.add(std::string_view(right).substr(object, at - object));
        right.replace(at + mark.size(), 16, scenes::hexadecimal(hash.value()));
        line = end + 1;
    }
    return right;
}

/// Opens it, and reads all that it holds, backwards.
void read_all(std::string_view text) {
    const scenes::Trace trace = scenes::parse_trace(text, "trace.json");
    static_cast<void>(trace.end());
    for (std::int64_t frame = trace.frames() - 1; frame >= 0;)
        frame = trace.interval(frame).first - 1;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try_reading(bytes, size, [](std::string_view text) { read_all(text); });
    return try_reading(bytes, size, [](std::string_view text) { read_all(with_checks(text)); });
}
