// Style sheets and declarations, as they are rewritten for a library.
#include "lodlab/lod2d/source/css/css.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        lod2d::SvgNotes notes;
        lod2d::SvgCss css(notes);
        css.learn(text);
        css.learn_root(text);
        static_cast<void>(css.sheet(text));
        static_cast<void>(css.declarations(text));
        static_cast<void>(css.display_for(text));
        static_cast<void>(css.value("fill", text));
    });
}
