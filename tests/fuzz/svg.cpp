// Drawings: plain ones and those that go through librsvg.
#include "lodlab/lod2d/source/svg.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        lod2d::SvgSettings settings;
        settings.most_bytes = 20'000;
        settings.most_elements = 200;
        settings.in_child = false;  // copies of a program that traces itself are slow
        settings.strokes = text.size() % 2 == 0;
        static_cast<void>(lod2d::parse_svg("drawing.svg", text, settings));
    });
}
