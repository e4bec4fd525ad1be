#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/paint/canvas/themes.hpp"
#include "lodlab/viz/paint/canvas/webp.hpp"
#include "lodlab/viz/paint/write.hpp"
#include "tests/catch.hpp"
#include "tests/text.hpp"
#include "tests/viz/scratch.hpp"

using namespace viz;
using lodtest::bytes_of;
using sample::Scratch;

namespace {

Figure flat_figure() {
    Figure figure;
    figure.title = "Two circles";
    figure.alt = "Two circles that meet.";
    Panel panel;
    panel.view = {{-2, -1}, {2, 1}};
    panel.marks = {Disc{{.role = Role::meeting_node}, {-0.5, 0}, 0.8},
                   Disc{{.role = Role::node, .body = 1}, {1, 0}, 0.5}};
    figure.panels = {panel};
    return figure;
}

Figure figure_in_space() {
    Figure figure = flat_figure();
    Camera camera;
    camera.eye = {0, 0, 5};
    figure.panels[0].space = SpaceScene{camera, {{{.role = Role::body}, {0, 0, 0}, 1}}, {}, {}};
    return figure;
}

std::string web_svg(const Figure& figure) {
    const Scratch folder;
    write_web_svg(folder / "figure.svg", figure);
    return bytes_of(folder / "figure.svg");
}

std::size_t count(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), expression), {}));
}

}  // namespace

TEST_CASE("an ink of two themes becomes a name with a colour for each", "[web]") {
    const std::string head = "<svg><desc>d</desc>";
    const std::string grey = "<path style=\"fill:rgb(50%,50%,50%);\"/></svg>";
    CHECK(for_both_themes(head + "<path style=\"fill:rgb(100%,0%,0%);\"/>" + grey,
                          head + "<path style=\"fill:rgb(0%,0%,100%);\"/>" + grey) ==
          head +
              "\n<style>:root{--a:#ff0000;}@media(prefers-color-scheme:dark){:root{--a:#0000ff;}}"
              "</style><path style=\"fill:var(--a);\"/><path style=\"fill:#808080;\"/></svg>");
}

TEST_CASE("a picture of two themes is shown in one of them", "[web]") {
    const auto svg = [](const std::string& data) {
        return "<svg><desc>d</desc><image id=\"p1\" width=\"2\" href=\"" + data +
               "\"/><use href=\"#p1\"/></svg>";
    };
    const std::string both = for_both_themes(svg("data:1"), svg("data:2"));
    CHECK_THAT(both,
               lodtest::contains("<g id=\"p1\"><image class=\"L\" width=\"2\" href=\"data:1\"/>"
                                 "<image class=\"D\" width=\"2\" href=\"data:2\"/></g>"));
    CHECK_THAT(both, lodtest::contains(".L{display:none}.D{display:inline}}</style>"));
}

TEST_CASE("drawings that differ in more than inks have no common SVG", "[web]") {
    for (const std::string other :
         {"<svg><path d=\"M 1 3\"/></svg>", "<svg></svg>", "<svg><path d=\"M 1 2\"/></svg> ", ""})
        CHECK_THROWS_AS(for_both_themes("<svg><path d=\"M 1 2\"/></svg>", other), lod::Error);
}

TEST_CASE("coordinates are rounded to a hundredth, links and factors are not", "[web]") {
    CHECK(compacted("<svg>\n<path d=\"M 1.23456 -0.001 L 3 40.5000 Z M 1 1\"/>\n</svg>\n") ==
          "<svg><path d=\"M1.23 0L3 40.5ZM1 1\"/></svg>");
    CHECK(compacted(
              "<use href=\"#g-1.23456\" x=\"1.999\" transform=\"matrix(0.71428,0,0,1,0,0)\"/>") ==
          "<use href=\"#g-1.23456\" x=\"2\" transform=\"matrix(0.71428,0,0,1,0,0)\"/>");
    CHECK(compacted("<title>a 1.23456 b</title>") == "<title>a 1.23456 b</title>");
}

TEST_CASE("a style that is used again and again is named once", "[web]") {
    CHECK(compacted("<style>x{}</style><g style=\"fill:none;\"/><g style=\"fill:none;\"/>") ==
          "<style>.s0{fill:none;}x{}</style><g class=\"s0\"/><g class=\"s0\"/>");
}

TEST_CASE("a page's SVG has every ink of both themes and less than half of their bytes", "[web]") {
    const Scratch folder;
    const std::string both = web_svg(flat_figure());
    std::size_t apart = 0;
    for (const Theme theme : {Theme::light, Theme::dark}) {
        WriteOptions how;
        how.theme = theme;
        write_svg(folder / "one.svg", flat_figure(), how);
        apart += bytes_of(folder / "one.svg").size();
    }
    CHECK(both.size() < apart / 2);
    for (const char* ink : {"#ffffff", "#14171c", "#00609c", "#4a9fe0"}) {
        INFO(ink);
        CHECK_THAT(both, lodtest::contains(ink));
    }
    CHECK(both == web_svg(flat_figure()));
}

TEST_CASE("what a page's SVG holds of pixels is WebP, once a theme", "[web]") {
    const std::string both = web_svg(figure_in_space());
    CHECK(count(both, "data:image/webp;base64,") == 2);
    CHECK(count(both, "data:image/png") == 0);
    CHECK(both == web_svg(figure_in_space()));
}

TEST_CASE("a picture over a ground is opaque, and shows it where nothing covers it", "[web]") {
    const Image picture{2, 1, 8, {10, 20, 30, 255, 0, 0, 0, 0}};
    const Image opaque = over_ground(picture, {1, 0.4, 0});
    CHECK(opaque.pixels == std::vector<std::uint8_t>{10, 20, 30, 255, 0, 102, 255, 255});
}

TEST_CASE("a WebP link holds the file that its format names", "[web]") {
    const Image white{4, 4, 16, std::vector<std::uint8_t>(64, 255)};
    const std::string link = webp_link(white);
    CHECK_THAT(link, lodtest::contains("data:image/webp;base64,UklGR"));  // "RIFF"
}

TEST_CASE("on a narrower page the words keep their size and the shapes do not", "[web]") {
    const Scratch folder;
    const auto svg_of = [&](double width) {
        write_web_svg(folder / "figure.svg", flat_figure(), width);
        return bytes_of(folder / "figure.svg");
    };
    const auto glyphs_of = [](const std::string& svg) {  // outlines of letters, in page units
        std::set<std::string> glyphs;
        const std::regex glyph("id=\"glyph[^\"]*\"><path [^>]*d=\"([^\"]*)\"");
        for (std::sregex_iterator it(svg.begin(), svg.end(), glyph), end; it != end; ++it)
            glyphs.insert((*it)[1]);
        return glyphs;
    };
    const std::string wide = svg_of(1280);
    const std::string narrow = svg_of(520);
    CHECK(wide.find("viewBox=\"0 0 1280 720\"") != std::string::npos);
    CHECK(narrow.find("viewBox=\"0 0 520 293\"") != std::string::npos);
    CHECK(wide == web_svg(flat_figure()));
    std::size_t shared = 0;
    for (const std::string& glyph : glyphs_of(narrow)) shared += glyphs_of(wide).count(glyph);
    CHECK(shared > 4);
}
