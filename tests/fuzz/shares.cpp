// Shares of a measurement, put together.
#include "lodlab/measure/curves.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        const auto share = measure::outcomes_from_json(std::string(text), "share.json");
        const measure::Outcomes all = measure::merged({share});
        static_cast<void>(measure::curves_csv(measure::curves_of(all)));
    });
}
