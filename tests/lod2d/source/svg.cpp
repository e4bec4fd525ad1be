#include "lodlab/lod2d/source/svg.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "tests/catch.hpp"
#include "tests/refusal.hpp"

using namespace lod2d;
using namespace lodtest;
using std::numbers::pi;

namespace {

std::string svg(const std::string& body, const std::string& attributes = "") {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " +
           attributes + ">\n" + body + "\n</svg>\n";
}

Shape shape_of_drawing(const std::string& body, const std::string& attributes = "") {
    SvgSettings settings;
    settings.outline.tolerance = 1e-6;
    return parse_svg("test.svg", svg(body, attributes), settings);
}

/// Area / (longer side of the box)^2, which no scaling changes.
double fullness(const std::string& body, const std::string& attributes = "") {
    const Shape shape = shape_of_drawing(body, attributes);
    CHECK(bounds(shape.polygon).size().maxCoeff() == Approx(1).epsilon(1e-6));
    return shape.area;
}

Refusal refusal(const std::string& text, const SvgSettings& settings = {}) {
    const Refusal refused = refusal_of(text, [&] { return parse_svg("test.svg", text, settings); });
    CHECK(refused.line.find("test.svg") != std::string::npos);
    return refused;
}

void check_refused(const std::string& text, std::string_view must_name) {
    const Refusal refused = refusal(text);
    INFO(refused.line);
    CHECK(refused.kind == lod::ErrorKind::input_refused);
    CHECK(refused.line.find(must_name) != std::string::npos);
}

constexpr double curved = 1e-5;

}  // namespace

TEST_CASE("basic shapes have the areas of the textbook", "[svg]") {
    CHECK(fullness("<rect width='4' height='2'/>") == Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<circle r='3'/>") == Approx(pi / 4).epsilon(curved));
    CHECK(fullness("<ellipse cx='7' rx='4' ry='1'/>") == Approx(pi / 16).epsilon(curved));
    CHECK(fullness("<polygon points='0,0 2,0 0,2'/>") == Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<polyline points='0,0 2,0 0,2'/>") == Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<path d='M0 0h2v2z'/>") == Approx(0.5).epsilon(1e-8));
    // A rounded square loses (4 - pi) r^2.
    CHECK(fullness("<rect width='10' height='10' rx='2'/>") ==
          Approx((100 - (4 - pi) * 4) / 100).epsilon(curved));
    CHECK(fullness("<rect width='10' height='10' rx='2' ry='1'/>") ==
          Approx((100 - (4 - pi) * 2) / 100).epsilon(curved));
    CHECK(fullness("<rect width='10' height='10' rx='50' ry='50'/>") ==
          Approx(pi / 4).epsilon(curved));
}

TEST_CASE("up in the picture is up", "[svg]") {
    const Shape shape =
        shape_of_drawing("<path d='M0 0h4v1h-3v3h-1z'/>");  // an L lying on its back
    const Box box = bounds(shape.polygon);
    const BoundaryIndex index(shape.polygon);
    CHECK(index.inside({box.high.x() - 0.01, box.high.y() - 0.01}));
    CHECK(index.inside({box.low.x() + 0.01, box.low.y() + 0.01}));
    CHECK_FALSE(index.inside({box.high.x() - 0.01, box.low.y() + 0.01}));
}

TEST_CASE("the fill rule comes from the attribute, the style or a group", "[svg]") {
    const std::string d = "d='M0 0h4v4h-4z M1 1h2v2h-2z'";
    const auto path = [&](const std::string& more) { return "<path " + d + " " + more + "/>"; };
    CHECK(fullness(path("")) == Approx(1).epsilon(1e-8));
    CHECK(fullness(path("fill-rule='evenodd'")) == Approx(0.75).epsilon(1e-8));
    CHECK(fullness(path("style='fill:red; fill-rule : evenodd'")) == Approx(0.75).epsilon(1e-8));
    CHECK(fullness("<g fill-rule='evenodd'>" + path("") + "</g>") == Approx(0.75).epsilon(1e-8));
    CHECK(fullness("<g fill-rule='evenodd'>" + path("style='fill-rule:nonzero'") + "</g>") ==
          Approx(1).epsilon(1e-8));
    CHECK(fullness("<style>/* c */ .hole, #x { fill-rule: evenodd }</style>" +
                   path("class='big hole'")) == Approx(0.75).epsilon(1e-8));
    CHECK(fullness("<style><![CDATA[path{fill-rule:evenodd}]]></style>" + path("")) ==
          Approx(0.75).epsilon(1e-8));
    CHECK(shape_of_drawing(path("fill-rule='evenodd'")).polygon.rings.size() == 2);
}

TEST_CASE("the shape is the union of all that is filled", "[svg]") {
    CHECK(fullness("<rect width='2' height='2'/><rect x='1' y='1' width='3' height='3'/>") ==
          Approx((4 + 9 - 1) / 16.0).epsilon(1e-8));
    const Shape parts =
        shape_of_drawing("<rect width='1' height='1'/><rect x='3' width='1' height='1'/>");
    CHECK(parts.polygon.rings.size() == 2);
    CHECK(parts.area == Approx(2.0 / 16).epsilon(1e-8));
}

TEST_CASE("what is not painted is not part of the shape", "[svg]") {
    const std::string kept = "<rect width='2' height='1'/>";
    for (const std::string hidden : {"fill='none'", "display='none'", "style='display:none'",
                                     "visibility='hidden'", "opacity='0'", "fill-opacity='0'",
                                     "style='fill:none;stroke:black'", "fill='transparent'"})
        CHECK(fullness(kept + "<rect x='5' width='9' height='9' " + hidden + "/>") ==
              Approx(0.5).epsilon(1e-8));
    for (const std::string unseen : {"defs", "clipPath", "mask", "pattern", "marker", "symbol",
                                     "metadata", "foreignObject", "linearGradient"})
        CHECK(fullness(kept + "<" + unseen + "><rect width='9' height='9'/></" + unseen + ">") ==
              Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<g display='none'><rect width='9' height='9' display='inline'/></g>" + kept) ==
          Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<g visibility='hidden'><rect width='9' height='9'/>"
                   "<rect width='2' height='1' visibility='visible'/></g>") ==
          Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<rect width='0' height='9'/><rect width='-1' height='9'/>" + kept) ==
          Approx(0.5).epsilon(1e-8));
}

TEST_CASE("a picture of strokes alone is drawn by its strokes", "[svg]") {
    CHECK(fullness("<path d='M0 0H10' fill='none' stroke='black' stroke-width='2'/>") ==
          Approx(0.2).epsilon(curved));
    // A closed square of side 8 under a pen of 2: 10 x 10 with corners by the join, less 6 x 6.
    const std::string square = "<rect width='8' height='8' fill='none' stroke='black' ";
    CHECK(fullness(square + "stroke-width='2'/>") == Approx(0.64).epsilon(1e-6));
    CHECK(fullness(square + "stroke-width='2' stroke-linejoin='round'/>") ==
          Approx((100 - (4 - pi) - 36) / 100).epsilon(1e-3));
    CHECK(fullness(square + "stroke-width='2' stroke-linejoin='bevel'/>") ==
          Approx((100 - 2 - 36) / 100.0).epsilon(1e-6));
    CHECK(fullness("<line x2='5' style='stroke:red;stroke-width:1' transform='scale(2)'/>") ==
          Approx(0.2).epsilon(curved));
}

TEST_CASE("transforms nest from the outside in", "[svg]") {
    // A unit square at (1, 0), scaled by 2 and moved by 1, and the same square as it stands.
    CHECK(fullness("<g transform='translate(1)'><g transform='scale(2)'>"
                   "<rect x='1' width='1' height='1'/></g></g><rect width='1' height='1'/>") ==
          Approx((4 + 1) / 25.0).epsilon(1e-8));
    CHECK(fullness("<rect width='2' height='2' transform='rotate(45)'/>") ==
          Approx(0.5).epsilon(1e-8));
    CHECK(fullness("<rect width='2' height='2' transform='skewX(45)'/>") ==
          Approx(0.25).epsilon(1e-8));
}

TEST_CASE("use draws its target again, elsewhere and in its own style", "[svg]") {
    CHECK(fullness("<defs><rect id='a' width='1' height='1'/></defs><use xlink:href='#a'/>"
                   "<use href='#a' x='3' y='0'/>") == Approx(2.0 / 16).epsilon(1e-8));
    CHECK(fullness("<defs><g id='b'><use href='#a'/><use href='#a' x='2'/></g>"
                   "<rect id='a' width='1' height='1'/></defs>"
                   "<use href='#b' transform='scale(1,3)'/>") == Approx(6.0 / 9).epsilon(1e-8));
    CHECK(fullness("<rect id='a' width='2' height='1'/><use href='#missing'/>"
                   "<use href='other.svg#a'/>") == Approx(0.5).epsilon(1e-8));
    // A symbol fits its view box into the place that use gives it.
    CHECK(fullness("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='5'/></symbol>"
                   "<use href='#s' width='4' height='4'/><rect y='3' width='4' height='1'/>") ==
          Approx((8 + 4) / 16.0).epsilon(1e-8));
}

TEST_CASE("a nested svg stands where its view box says", "[svg]") {
    CHECK(fullness("<rect width='1' height='1'/><svg x='2' y='0' width='2' height='2' "
                   "viewBox='10 10 4 4'><rect x='10' y='10' width='4' height='4'/></svg>") ==
          Approx((1 + 4) / 16.0).epsilon(1e-8));
    CHECK(fullness("<rect width='50%' height='25%'/>", "viewBox='0 0 40 40'") ==
          Approx(0.5).epsilon(1e-8));
}

TEST_CASE("the first child of a switch that needs no extension is drawn", "[svg]") {
    CHECK(fullness("<switch><foreignObject requiredExtensions='x'/>"
                   "<g><rect width='2' height='1'/></g><rect width='9' height='9'/></switch>") ==
          Approx(0.5).epsilon(1e-8));
}

TEST_CASE("the longer side of the shape is the size asked for", "[svg]") {
    SvgSettings settings;
    settings.outline.size = 0.25;
    // A line of no width reaches further than the shape and must not count.
    const Shape shape =
        parse_svg("a/b/box.svg", svg("<path d='M0 0h2v4h-2z M9 9 L 20 20 z'/>"), settings);
    CHECK(bounds(shape.polygon).size().y() == Approx(0.25).epsilon(1e-6));
    CHECK(bounds(shape.polygon).size().x() == Approx(0.125).epsilon(1e-6));
    CHECK(shape.name == "box");
    settings.outline.size = 0;
    CHECK(refusal(svg("<rect width='1' height='1'/>"), settings).line.find("size") !=
          std::string::npos);
}

TEST_CASE("a file that is no SVG or draws nothing is refused with its place", "[svg]") {
    check_refused("", "empty");
    check_refused("hello", "no SVG");
    check_refused("\x1f\x8b\x08 gz", "gunzip");  // and broken
    check_refused("<svg>\n  <path d='M0 0'\n</svg>", "line 3, column 1");
    check_refused("<svg><g></svg>", "line 1");
    check_refused("<html><svg/></html>", "outermost");
    check_refused(svg(""), "fills no region");
    check_refused(svg("<text>R</text><image/><image/>"), "1 text, 2 images");
    check_refused(svg("<path d=''/>"), "fills no region");
    check_refused(svg("<path d='M1 1'/>"), "fills no region");
    check_refused(svg("<path d='M1 1L2 2z'/>"), "fills no region");
    check_refused(svg("<path d='M1 1L2 2 3 3z'/>"), "area is zero");
    check_refused(svg("<rect width='1' height='1'/>\n <path d='M0 0 L1'/>"), "line 3, column 3");
    check_refused(svg("<path d='M0 0 L nan 1 2 3'/>"), "a number");
    check_refused(svg("<path d='M0 0 L 1e300 0 0 1e300z'/>"), "line 2");
    check_refused(svg("<path d='M0 0 L 1e999 0 0 1z'/>"), "double's range");
    check_refused(svg("<rect width='inf' height='2'/>"), "broken width");
    check_refused(svg("<rect width='1' height='2' transform='spin(3)'/>"), "broken transform");
    check_refused(svg("<polygon points='0,0 1,x'/>"), "broken points");
}

TEST_CASE("what a browser takes for broken XML is refused with its place", "[svg]") {
    check_refused("<svg>\n<style>.a{fill:red} & b{x:y}</style><rect width='1' height='1'/></svg>",
                  "line 2, column 21: broken XML: a bare &");
    check_refused(svg("<title>A&B</title><rect width='1' height='1'/>"), "a bare &");
    check_refused(svg("<rect id='a&b;c' width='1' height='1'/>"), "&b; is not declared");
    check_refused(svg("<rect x='1' width='1' height='1' x='2'/>"), "attribute x stands twice");
    for (const char* whole : {"<style><![CDATA[a & b{}]]></style>", "<!-- a & b -->", "<?a & b?>",
                              "<title>&amp;&lt;&gt;&quot;&apos;&#65;&#x41;</title>"}) {
        INFO(whole);
        CHECK_NOTHROW(parse_svg("a.svg", svg(std::string(whole) + "<rect width='1' height='1'/>")));
    }
}

TEST_CASE("elements that would draw themselves or explode are refused", "[svg]") {
    check_refused(svg("<g id='a'><use href='#a'/></g>"), "draws itself");
    check_refused(svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"),
                  "draws itself");
    std::string doubling = "<rect id='d0' width='1' height='1'/>";
    for (int i = 1; i <= 40; ++i) {
        const std::string half = "<use href='#d" + std::to_string(i - 1) + "'/>";
        doubling += "<g id='d" + std::to_string(i) + "'>" + half + half + "</g>";
    }
    const Refusal exploded = refusal(svg("<defs>" + doubling + "</defs><use href='#d40'/>"));
    CHECK(exploded.kind == lod::ErrorKind::limit_exceeded);
    CHECK(exploded.line.find("200000") != std::string::npos);

    std::string deep;
    for (int i = 0; i < 5000; ++i) deep += "<g>";
    for (int i = 0; i < 5000; ++i) deep += "</g>";
    CHECK(refusal(svg(deep)).kind == lod::ErrorKind::limit_exceeded);
}

TEST_CASE("entities are resolved, and refused where they explode or stand outside", "[svg]") {
    std::string laughs = "<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a0 'M0 0h2v1h-2z'>";
    for (int i = 1; i < 30; ++i) {
        const std::string last = "&a" + std::to_string(i - 1) + ";";
        laughs += "<!ENTITY a" + std::to_string(i) + " '" + last + last + last + last + "'>";
    }
    laughs += "]>";
    const Shape shape =
        parse_svg("a.svg", laughs + svg("<desc>&a29;</desc><path d='M0 0h2v1h-2z'/>"));
    CHECK(shape.area == Approx(0.5).epsilon(1e-8));
    check_refused(laughs + svg("<path d='&a29;'/>"), "entity");
    check_refused(
        "<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + svg("<path d='&x;'/>"),
        "entity &x; stands in another file");
    check_refused("<!DOCTYPE svg [<!ENTITY part '<rect/>'>]>" + svg("&part;"), "entity &part;");
    CHECK(parse_svg("a.svg", laughs + svg("<path d='&a0;'/>")).area == Approx(0.5).epsilon(1e-8));
}

TEST_CASE("limits of points are named and can be raised", "[svg]") {
    std::string d = "M0 0";
    for (int i = 0; i < 2000; ++i) d += "h1v1";
    SvgSettings settings;
    settings.outline.clean.most_points = 1000;
    const Refusal refused = refusal(svg("<path d='" + d + "'/>"), settings);
    CHECK(refused.kind == lod::ErrorKind::limit_exceeded);
    CHECK(refused.line.find("1000") != std::string::npos);
    settings.outline.clean.most_points = 10000;
    CHECK(parse_svg("stairs.svg", svg("<path d='" + d + "'/>"), settings).area > 0);
}

TEST_CASE("a file that is missing, a folder or too large is refused", "[svg]") {
    const auto kind_of = [](const std::filesystem::path& path, std::size_t most_bytes) {
        SvgSettings settings;
        settings.most_bytes = most_bytes;
        try {
            (void)load_svg(path, settings);
        } catch (const lod::Error& error) {
            CHECK(std::string(error.what()).find(path.string()) != std::string::npos);
            return error.kind();
        }
        return lod::ErrorKind::usage;
    };
    const auto folder = std::filesystem::temp_directory_path();
    const auto file = folder / "lodlab-test-large.svg";
    std::ofstream(file) << svg("<rect width='1' height='1'/>");
    CHECK(load_svg(file).area == Approx(1).epsilon(1e-8));
    CHECK(kind_of(file, 20) == lod::ErrorKind::limit_exceeded);
    std::filesystem::remove(file);
    CHECK(kind_of(file, 20) == lod::ErrorKind::input_refused);
    CHECK(kind_of(folder, 20) == lod::ErrorKind::input_refused);
}

TEST_CASE("a drawing that takes librsvg too long is refused at the limit of time", "[svg]") {
    // Every line of the star crosses almost every other: a million crossings at each size.
    std::string points;
    constexpr int corners = 2001;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i * (corners / 2) / corners;
        points += std::to_string(50 + 40 * std::cos(angle)) + "," +
                  std::to_string(50 + 40 * std::sin(angle)) + " ";
    }
    const std::string star = "<g id='a'><polygon points='" + points + "'/></g><use href='#a'/>";
    SvgSettings settings;
    settings.most_seconds = 0.2;
    const Refusal refused = refusal(svg(star, "viewBox='0 0 100 100'"), settings);
    CHECK(refused.kind == lod::ErrorKind::limit_exceeded);
    CHECK(refused.line.find("longer than the limit of 0 s") != std::string::npos);
    settings.most_seconds = 0;
    CHECK(parse_svg("plain.svg", svg("<path d='M0 0H1V1Z'/>"), settings).area == Approx(0.5));
}
