#include "lodlab/lod2d/source/load.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod2d/source/font.hpp"
#include "tests/catch.hpp"
#include "tests/refusal.hpp"

using namespace lod2d;
using namespace lodtest;

namespace {

Refusal load_refusal(std::string_view spec, const LoadSettings& settings = {}) {
    return refusal_of(spec, [&] { return load_shape(spec, settings); });
}

std::size_t holes_of(const Shape& shape) {
    std::size_t holes = 0;
    for (const Ring& ring : shape.polygon.rings) holes += polygon_area({{ring}}) < 0;
    return holes;
}

}  // namespace

TEST_CASE("a spec names a generator, a text or a file", "[load]") {
    CHECK(load_shape("box:2,0.5").area == 1);
    CHECK(load_shape("text:R").name == "text:R");
    const auto file = std::filesystem::temp_directory_path() / "lodlab-test-load.SVG";
    std::ofstream(file) << "<svg><rect width='4' height='2'/></svg>";
    CHECK(load_shape(file.string()).area == Approx(0.5).epsilon(1e-8));
    CHECK(names_shape(file.string()));
    LoadSettings large;
    large.outline.size = 4;
    CHECK(load_shape(file.string(), large).area == Approx(8).epsilon(1e-8));
    std::filesystem::remove(file);
    CHECK(load_refusal(file.string()).kind == lod::ErrorKind::input_refused);
}

TEST_CASE("a spec that names nothing is answered with what is understood", "[load]") {
    const Refusal refused = load_refusal("dodecahedron");
    CHECK(refused.kind == lod::ErrorKind::usage);
    CHECK(refused.line.find(".svg") != std::string::npos);
    CHECK(refused.line.find("text:R") != std::string::npos);
    CHECK(refused.line.find("gear") != std::string::npos);
    CHECK_FALSE(names_shape("dodecahedron"));
    CHECK_FALSE(names_shape("bunny.obj"));
}

TEST_CASE("letters have the holes that they have in print", "[font]") {
    CHECK(holes_of(load_shape("text:C")) == 0);
    CHECK(holes_of(load_shape("text:R")) == 1);
    CHECK(holes_of(load_shape("text:B")) == 2);
    CHECK(load_shape("text:i").polygon.rings.size() == 2);
    CHECK(load_shape("text:OO OO").polygon.rings.size() == 8);
    CHECK(holes_of(load_shape("text:\xc3\x85")) == 2);  // A with a ring above
}

TEST_CASE("letters stand upright and side by side", "[font]") {
    const Shape letter = load_shape("text:L");
    const Box box = bounds(letter.polygon);
    CHECK(box.size().y() == Approx(1).epsilon(1e-6));
    const BoundaryIndex index(letter.polygon);
    CHECK(index.inside({box.high.x() - 0.02, box.low.y() + 0.02}));
    CHECK(index.inside({box.low.x() + 0.02, box.high.y() - 0.02}));
    CHECK_FALSE(index.inside({box.high.x() - 0.02, box.high.y() - 0.02}));
    CHECK(bounds(load_shape("text:lodlab").polygon).size().x() == Approx(1).epsilon(1e-6));
}

TEST_CASE("a text that cannot be drawn is refused with its reason", "[font]") {
    using enum lod::ErrorKind;
    CHECK(load_refusal("text:").kind == input_refused);
    CHECK(load_refusal("text:   ").kind == input_refused);
    CHECK(load_refusal("text:\xff").kind == input_refused);
    CHECK(load_refusal("text:\xc3").kind == input_refused);
    CHECK(load_refusal("text:" + std::string(201, 'x')).kind == limit_exceeded);
    const Refusal missing = load_refusal("text:a\xf3\xb0\x80\x80");  // a plane for private use
    CHECK(missing.kind == input_refused);
    CHECK(missing.line.find("U+F0000") != std::string::npos);
    CHECK(missing.line.find("no glyph") != std::string::npos);
    CHECK(load_refusal("text:a\nb").line.find("U+000A") != std::string::npos);
}

TEST_CASE("without any font the line that installs one is given", "[font]") {
    const auto config = std::filesystem::temp_directory_path() / "lodlab-test-no-fonts.conf";
    std::ofstream(config) << "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'>"
                             "<fontconfig></fontconfig>";
    ::setenv("FONTCONFIG_FILE", config.c_str(), 1);
    const Refusal refused = load_refusal("text:R");
    ::unsetenv("FONTCONFIG_FILE");
    std::filesystem::remove(config);
    CHECK(refused.kind == lod::ErrorKind::not_installed);
    CHECK(refused.line.find("apt-get install fonts-inter") != std::string::npos);
}
