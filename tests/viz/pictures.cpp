#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/paint/canvas/document.hpp"
#include "lodlab/viz/paint/paint.hpp"
#include "lodlab/viz/paint/write.hpp"
#include "tests/catch.hpp"
#include "tests/text.hpp"
#include "tests/viz/scratch.hpp"

using namespace viz;
using lodtest::bytes_of;
using sample::Scratch;
using sample::SmallDisk;

namespace {

const std::vector<std::string> endings{"png", "svg", "pdf", "json"};

Figure some_figure() {
    Figure figure;
    figure.title = "Do *A* & <B> touch?";
    figure.numbers = {{"tests", "48"}};
    figure.caption = "A caption.";
    figure.alt = "Two circles & an arrow.";
    Panel panel;
    panel.view = {{-2, -1}, {2, 1}};
    panel.marks = {Disc{{.role = Role::meeting_node}, {-0.5, 0}, 0.8},
                   Disc{{.role = Role::node}, {1, 0}, 0.5},
                   Dot{{.role = Role::contact}, {0.3, 0}, 1},
                   Arrow{{.role = Role::impulse}, {0.3, 0}, {1, 0.4}, "*j* = 1 N s"},
                   Polyline{{.role = Role::trajectory}, {{-2, -1}, {0, 0.5}, {2, 1}}, 0.1, "path"},
                   Path{{.role = Role::body, .body = 1}, {{{0, 0}, {1, 0}, {0, 1}}}},
                   Label{{.role = Role::note}, {-0.5, 0}, "*o_A*", 0.8}};
    figure.panels = {panel, panel};
    return figure;
}

void refuses(const Figure& figure, const std::string& word) {
    const Scratch folder;
    for (const std::string& ending : endings) {
        INFO(ending);
        try {
            write_figure(folder / ("figure." + ending), figure);
            FAIL("drawn all the same");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::input_refused);
            CHECK_THAT(error.what(), lodtest::contains(word));
        }
        CHECK(folder.is_empty());
    }
}

Figure with(const Mark& mark) {
    Figure figure = some_figure();
    figure.panels[1].marks.push_back(mark);
    return figure;
}

}  // namespace

TEST_CASE("ids that a library counts through a process are numbered anew in each picture",
          "[pictures]") {
    // As Cairo 1.18 and 1.16 write them, where other pictures came before or did not.
    const auto svg = [](const std::string& n, const std::string& m) {
        return "<svg x=\"0\"><g id=\"source-" + n + "\"/><image id=\"source-" + m +
               "\"/><mask id=\"mask" + n + "\" fill=\"url(#source-" + m +
               ")\"/><use xlink:href=\"#source-" + n + "\" mask=\"url(#mask" + n +
               ")\" fill=\"#120012\"/></svg>";
    };
    const std::string first = finished_svg(svg("5", "7"), "a title", "words");
    CHECK(first == finished_svg(svg("12", "13"), "a title", "words"));
    CHECK_THAT(first, lodtest::contains("<image id=\"source-2\"/>"));
    CHECK_THAT(first, lodtest::contains("fill=\"url(#source-2)\""));
    CHECK_THAT(first, lodtest::contains("mask=\"url(#mask1)\" fill=\"#120012\""));
}

TEST_CASE("a figure drawn twice gives the same bytes", "[pictures]") {
    const Scratch folder;
    for (const std::string& ending : endings) {
        INFO(ending);
        write_figure(folder / ("first." + ending), some_figure());
        write_png(folder / "between.png", some_figure());  // moves the library's counters
        write_figure(folder / ("second." + ending), some_figure());
        CHECK(bytes_of(folder / ("first." + ending)) == bytes_of(folder / ("second." + ending)));
    }
}

TEST_CASE("each picture begins as its format does", "[pictures]") {
    const Scratch folder;
    for (const std::string& ending : endings) write_figure(folder / ("f." + ending), some_figure());
    CHECK(bytes_of(folder / "f.png").substr(1, 3) == "PNG");
    CHECK(bytes_of(folder / "f.pdf").substr(0, 5) == "%PDF-");
    CHECK(bytes_of(folder / "f.svg").substr(0, 5) == "<?xml");
    CHECK(bytes_of(folder / "f.json").substr(0, 1) == "{");
}

TEST_CASE("an SVG tells its title and alt text to those who cannot see it", "[pictures]") {
    const Scratch folder;
    write_svg(folder / "f.svg", some_figure());
    const std::string svg = bytes_of(folder / "f.svg");
    CHECK_THAT(svg, lodtest::contains("role=\"img\""));
    CHECK_THAT(svg, lodtest::contains("<title>Do A &amp; &lt;B&gt; touch?</title>"));
    CHECK_THAT(svg, lodtest::contains("<desc>Two circles &amp; an arrow.</desc>"));
}

TEST_CASE("light and dark draw the same page on different grounds", "[pictures]") {
    const Image light = rasterise(some_figure(), Theme::light, Quality::draft);
    const Image dark = rasterise(some_figure(), Theme::dark, Quality::draft);
    CHECK(light.width == dark.width);
    CHECK(light.pixels[0] > 240);
    CHECK(dark.pixels[0] < 40);
}

TEST_CASE("a page of 16 to 9 has the size that its quality names", "[pictures]") {
    const auto height = [](Quality quality) {
        return rasterise(some_figure(), Theme::light, quality).height;
    };
    CHECK(height(Quality::draft) == 540);
    CHECK(height(Quality::p720) == 720);
    CHECK(height(Quality::p1080) == 1080);
}

TEST_CASE("a page of any aspect has even sides", "[pictures]") {
    for (const double aspect : {0.7, 1.0, 1.37, 2.2}) {
        Figure figure = some_figure();
        figure.aspect = aspect;
        const Image image = rasterise(figure, Theme::light, Quality::draft);
        INFO("aspect " << aspect);
        CHECK(image.width % 2 == 0);
        CHECK(image.height % 2 == 0);
        CHECK(image.width / static_cast<double>(image.height) == Approx(aspect).epsilon(0.01));
    }
}

TEST_CASE("a number that is not finite is refused by panel and mark", "[pictures]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    refuses(with(Disc{{}, {nan, 0}, 1}), "panel 2, mark 8");
    refuses(with(Disc{{}, {0, 0}, inf}), "not a finite number");
    refuses(with(Disc{{}, {0, 0}, 1e300}), "beyond 1e12");
    refuses(with(Disc{{}, {0, 0}, -1}), "below zero");
    refuses(with(Dot{{}, {0, nan}, 1}), "not a finite number");
    refuses(with(Path{{}, {{{0, 0}, {inf, 1}, {1, 0}}}}), "not a finite number");
    refuses(with(Polyline{{}, {{0, 0}, {0, nan}}, 1, {}}), "not a finite number");
    refuses(with(Arrow{{}, {0, 0}, {nan, 0}, {}}), "not a finite number");
    refuses(with(Label{{}, {nan, 0}, "x", 0}), "not a finite number");
    refuses(with(Dot{{.opacity = nan}, {0, 0}, 1}), "opacity");
}

TEST_CASE("a view that is empty or not finite is refused", "[pictures]") {
    Figure figure = some_figure();
    figure.panels[0].view = {{1, 1}, {1, 2}};
    refuses(figure, "the view is empty");
    figure.panels[0].view = {{0, 0}, {std::numeric_limits<double>::infinity(), 2}};
    refuses(figure, "panel 1");
}

TEST_CASE("marks far outside the view and larger than it are drawn without harm", "[pictures]") {
    Figure figure = with(Disc{{.role = Role::meeting_node}, {1e11, 0}, 1e11});
    figure.panels[0].marks.push_back(Polyline{{}, {{-1e12, -1e12}, {1e12, 1e12}}, 0.5, "far"});
    figure.panels[0].marks.push_back(Path{{}, {{{-1e12, 0}, {1e12, 1e12}, {1e12, -1e12}}}});
    figure.panels[0].marks.push_back(Arrow{{}, {0, 0}, {1e12, 0}, "far"});
    const Scratch folder;
    write_png(folder / "f.png", figure);
    CHECK(bytes_of(folder / "f.png").size() > 1000);
}

TEST_CASE("words that are no UTF-8, or markup, are shown and do no harm", "[pictures]") {
    Figure figure = some_figure();
    figure.title = "bad \xff\xfe bytes, <b>no markup</b> & an open *italic and _{subscript";
    figure.panels[0].title = std::string(5000, 'x');
    const Scratch folder;
    write_svg(folder / "f.svg", figure);
    write_png(folder / "f.png", figure);
    write_figure(folder / "f.json", figure);
    write_pdf(folder / "f.pdf", figure);
    CHECK(bytes_of(folder / "f.png").size() > 1000);
}

TEST_CASE("an empty figure is an empty page", "[pictures]") {
    const Scratch folder;
    write_png(folder / "f.png", Figure{});
    CHECK(bytes_of(folder / "f.png").size() > 100);
}

TEST_CASE("a full disk is an error, and no file is left", "[pictures]") {
    const Scratch folder;
    for (const std::string& ending : endings) {
        INFO(ending);
        const SmallDisk disk(500);
        try {
            write_figure(folder / ("f." + ending), some_figure());
            FAIL("written to a full disk");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::output_failed);
        }
        CHECK(folder.is_empty());
    }
}

TEST_CASE("a folder that is not there is named in the error", "[pictures]") {
    try {
        write_png("/nowhere/at/all/f.png", some_figure());
        FAIL("written");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::output_failed);
        CHECK_THAT(error.what(), lodtest::contains("/nowhere/at/all/f.png"));
    }
}

TEST_CASE("an ending that names no format is a usage error that lists those that do",
          "[pictures]") {
    try {
        write_figure("f.bmp", some_figure());
        FAIL("written");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::usage);
        CHECK_THAT(error.what(), lodtest::contains(".png .svg .pdf .json"));
    }
}
