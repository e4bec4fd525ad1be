#include <numbers>

#include "lodlab/core/error.hpp"
#include "lodlab/lod2d/svg.hpp"
#include "tests/catch.hpp"

using namespace lod2d;
using std::numbers::pi;

namespace {

/// A small drawing and how full its shape's square is: area / (longer side of its box)^2.
struct Case {
    const char* body;
    double fullness;
};

// What is to be seen of most drawings: 8 x 4, half of its square. What must not be seen is larger.
#define SEEN "<rect x='4' y='4' width='8' height='4'/>"
constexpr double half = 0.5;

Shape shape_of_body(const std::string& body, bool strokes = false) {
    SvgSettings settings;
    settings.outline.tolerance = 1e-5;
    settings.strokes = strokes;
    return parse_svg("case.svg",
                     "<svg xmlns='http://www.w3.org/2000/svg' "
                     "xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 40 40'>" +
                         body + "</svg>",
                     settings);
}

template <std::size_t n>
void check(const Case (&cases)[n], double epsilon = 1e-6) {
    for (const Case& one : cases) {
        INFO(one.body);
        CHECK(shape_of_body(one.body).area == Approx(one.fullness).epsilon(epsilon));
    }
}

std::string remarks_of(const Shape& shape) {
    std::string all;
    for (const std::string& line : shape.remarks) all += line + "\n";
    return all;
}

}  // namespace

TEST_CASE("style sheets decide as in a browser", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<style>.g{fill:none}</style><rect class='g' width='40' height='40'/>" SEEN, half},
        {"<style>@import url(x.css);.g{fill:none}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>@charset 'utf-8';.g{fill:none}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>@namespace svg url(http://www.w3.org/2000/svg);.g{fill:none}</style><rect "
         "class='g' width='40' height='40'/>" SEEN,
         half},
        {"<style>@media print{.k{fill:none}} .g{fill:none}</style><rect class='g' width='40' "
         "height='40'/><rect class='k' x='4' y='4' width='8' height='4'/>",
         half},
        {"<style>@media screen{.g{fill:none}}</style><rect class='g' width='40' height='40'/>" SEEN,
         half},
        {"<style>@media all and (unknown){.k{fill:none}}</style><rect class='k' x='4' y='4' "
         "width='8' height='4'/>",
         half},
        {"<style>@keyframes k{0%{fill:red}}.g{fill:none}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>g .g{fill:none}</style><g><rect class='g' width='40' height='40'/></g>" SEEN,
         half},
        {"<style>g>rect{fill:none}</style><g><rect width='40' height='40'/></g>" SEEN, half},
        {"<style>.a+rect{fill:none}</style><rect class='a' x='4' y='4' width='8' "
         "height='4'/><rect width='40' height='40'/>",
         half},
        {"<style>.a~rect{fill:none}</style><rect class='a' x='4' y='4' width='8' "
         "height='4'/><g/><rect width='40' height='40'/>",
         half},
        {"<style>[width='40']{fill:none}</style><rect width='40' height='40'/>" SEEN, half},
        {"<style>rect:first-of-type{fill:none}</style><rect width='40' height='40'/>" SEEN, half},
        {"<style>rect:not(.k){fill:none}</style><rect width='40' height='40'/><rect class='k' "
         "x='4' y='4' width='8' height='4'/>",
         half},
        {"<style>.a.b{fill:none}</style><rect class='b a' width='40' height='40'/><rect class='a' "
         "x='4' y='4' width='8' height='4'/>",
         half},
        {"<style>rect.a{fill:none}.a{fill:red}</style><rect class='a' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>.a{fill:none!important}.a.a{fill:red}</style><rect class='a' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>.x{fill:red}.y{fill:none}</style><rect class='y x' width='40' height='40'/>" SEEN,
         half},
        {"<style>.Big{fill:none}</style><rect class='Big' width='40' height='40'/><rect "
         "class='big' x='4' y='4' width='8' height='4'/>",
         half},
        {"<style>RECT{fill:none}</style><rect x='4' y='4' width='8' height='4'/>", half},
        {"<style>.g{FILL:None}</style><rect class='g' width='40' height='40'/>" SEEN, half},
        {"<style>.g{fill : none ; }</style><rect class='g' width='40' height='40'/>" SEEN, half},
        {"<style><![CDATA[<!-- .g{fill:none} -->]]></style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>/* } */.g/**/{/*fill:red*/fill:none}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style media='print'>.k{fill:none}</style><rect class='k' x='4' y='4' width='8' "
         "height='4'/>",
         half},
        {"<style type='text/less'>.k{fill:none}</style><rect class='k' x='4' y='4' width='8' "
         "height='4'/>",
         half},
        {"<style>:root{--c:none}.g{fill:var(--c)}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<style>.g{fill:var(--gone,none)}</style><rect class='g' width='40' height='40'/>" SEEN,
         half},
        {"<style>svg{--a:var(--b);--b:none}.g{fill:var( --a )}</style><rect class='g' width='40' "
         "height='40'/>" SEEN,
         half},
        {"<rect style='fill:initial;' fill='none' x='4' y='4' width='8' height='4'/>", half},
        {"<g fill='none'><rect style='fill:unset' width='40' height='40'/></g>" SEEN, half},
        {"<g fill='none'><rect style='fill:inherit' fill='red' width='40' height='40'/></g>" SEEN,
         half},
        {"<rect style='fill:oklch(0.5 0.1 20)' fill='none' x='4' y='4' width='8' height='4'/>",
         half},
        {"<style>#a,.b{fill:none}</style><rect id='a' width='40' height='40'/>" SEEN, half},
        {"<style>rect{opacity:0}.k{opacity:1}</style><rect width='40' height='40'/><rect class='k' "
         "x='4' y='4' width='8' height='4'/>",
         half},
    };
    check(cases);
}

TEST_CASE("paint that leaves no ink is not seen", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<rect width='40' height='40' fill='rgba(0,0,0,0)'/>" SEEN, half},
        {"<rect width='40' height='40' fill='#12345600'/>" SEEN, half},
        {"<rect width='40' height='40' fill='#1230'/>" SEEN, half},
        {"<rect width='40' height='40' fill='hsla(10,50%,50%,0)'/>" SEEN, half},
        {"<rect width='40' height='40' fill='url(#gone) none'/>" SEEN, half},
        {"<rect width='40' height='40' fill='NONE'/>" SEEN, half},
        {"<rect width='40' height='40' fill='none '/>" SEEN, half},
        {"<rect width='40' height='40' fill-opacity='0%'/>" SEEN, half},
        {"<g color='transparent'><rect width='40' height='40' fill='currentColor'/></g>" SEEN,
         half},
        {"<linearGradient id='n'><stop stop-opacity='0'/><stop offset='1' "
         "stop-opacity='0'/></linearGradient><rect width='40' height='40' fill='url(#n)'/>" SEEN,
         half},
        {"<linearGradient id='n'/><rect width='40' height='40' fill='url(#n)'/>" SEEN, half},
        {"<pattern id='p' width='2' height='2'/><rect width='40' height='40' "
         "fill='url(#p)'/>" SEEN,
         half},
        {"<pattern id='p' width='2' height='2' patternUnits='userSpaceOnUse'><rect width='1' "
         "height='1'/></pattern><rect x='4' y='4' width='8' height='4' fill='url(#p)'/>",
         half},
        {"<g opacity='0'><rect width='40' height='40'/></g>" SEEN, half},
        {"<g opacity='.5'><g opacity='.5'>" SEEN "</g></g>", half},
        {"<g style='opacity:0'><g style='opacity:1'><rect width='40' height='40'/></g></g>" SEEN,
         half},
        {"<x:g xmlns:x='urn:other'><rect width='40' height='40' display='none'/></x:g>" SEEN, half},
        {"<x:rect xmlns:x='urn:other' width='40' height='40'/>" SEEN, half},
    };
    check(cases);
}

TEST_CASE("view boxes, use and switch place what they draw", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<svg x='4' y='4' width='20' height='5' viewBox='0 0 10 10' "
         "preserveAspectRatio='none'><rect width='10' height='10'/></svg>",
         0.25},
        {"<svg width='20' height='5' viewBox='0 0 10 10' preserveAspectRatio='xMinYMin "
         "meet'><rect width='10' height='10'/></svg><rect x='19' width='1' height='5'/>",
         0.075},
        {"<svg width='20' height='5' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMid "
         "meet'><rect width='10' height='10'/></svg><rect width='1' height='5'/>",
         0.075},
        {"<svg width='20' height='10' viewBox='0 0 10 10' preserveAspectRatio='xMidYMid "
         "slice'><rect width='10' height='10'/></svg>",
         half},
        {"<svg x='4' y='4' width='8' height='4'><rect width='40' height='40'/></svg>", half},
        {"<svg x='4' y='4' width='8' height='4' overflow='visible'><rect width='16' "
         "height='8'/></svg>",
         half},
        {"<svg x='4' y='4' width='8' height='8' viewBox='0 0 2 2'><rect width='100%' "
         "height='50%'/></svg>",
         half},
        {"<symbol id='s' viewBox='0 0 2 1'><rect width='2' height='1'/></symbol><use href='#s' "
         "width='8' height='8'/>",
         half},
        {"<defs><svg id='n' width='2' height='2' viewBox='0 0 2 2'><rect width='2' "
         "height='1'/></svg></defs><use href='#n' width='8' height='8'/>",
         half},
        {"<defs><rect id='r' width='8' height='4'/></defs><use l:href='#r' "
         "xmlns:l='http://www.w3.org/1999/xlink'/>",
         half},
        {"<defs><rect id='r' width='8' height='4' fill='inherit'/></defs><g fill='none'><use "
         "href='#r' transform='scale(9)'/></g><use href='#r'/>",
         half},
        {"<switch><rect systemLanguage='xx' width='40' height='40'/>" SEEN "</switch>", half},
        {"<switch><rect systemLanguage='de, en-GB' x='4' y='4' width='8' height='4'/><rect "
         "width='40' height='40'/></switch>",
         half},
        {"<switch><rect requiredExtensions='urn:x' width='40' height='40'/>" SEEN "</switch>",
         half},
        {"<rect systemLanguage='xx' width='40' height='40'/>" SEEN, half},
        {"<marker id='m' markerWidth='4' markerHeight='4' markerUnits='userSpaceOnUse'><rect "
         "width='4' height='4'/></marker><path d='M0 0h4v2h-4z' marker-start='url(#m)' "
         "fill='red'/>",
         1},
    };
    check(cases);
}

TEST_CASE("clips and simple masks cut", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<clipPath id='c'>" SEEN "</clipPath><rect width='40' height='40' "
         "clip-path='url(#c)'/>",
         half},
        {"<clipPath id='c'>" SEEN "</clipPath><g style='clip-path:url(#c)'><rect width='40' "
         "height='40'/></g>",
         half},
        {"<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' "
         "height='.5'/></clipPath><rect width='8' height='8' clip-path='url(#c)'/>",
         half},
        {"<clipPath id='c'><path clip-rule='evenodd' d='M0 0h4v4h-4z M1 1h2v2h-2z'/></clipPath>"
         "<rect width='40' height='40' clip-path='url(#c)'/>",
         0.75},
        {"<clipPath id='a'><rect width='8' height='40'/></clipPath><clipPath id='b'><rect "
         "width='40' height='4'/></clipPath><g clip-path='url(#a)'><rect width='40' height='40' "
         "clip-path='url(#b)'/></g>",
         half},
        {"<clipPath id='c'>" SEEN "</clipPath><g transform='rotate(30)' "
         "clip-path='url(#c)'><rect x='-40' y='-40' width='99' height='99'/></g>",
         32 / ((8 * 0.8660254037844386 + 4 * 0.5) * (8 * 0.8660254037844386 + 4 * 0.5))},
        {"<mask id='m'><rect x='4' y='4' width='8' height='4' fill='#fff'/></mask><rect width='40' "
         "height='40' mask='url(#m)'/>",
         half},
        {"<mask id='m' fill='white'><use href='#u'/></mask><defs><rect id='u' width='8' "
         "height='4'/></defs><g mask='url(#m)'><rect width='40' height='40'/></g>",
         half},
        {"<mask id='m' style='mask-type:alpha'>" SEEN "</mask><rect width='40' height='40' "
         "style='mask:url(#m)'/>",
         half},
    };
    check(cases);
}

TEST_CASE("transforms and lengths of CSS move and size", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<rect width='4' height='4' style='transform:scale(2,1)'/>", half},
        {"<rect width='4' height='4' style='transform: rotate(0deg) scale(2,1)'/>", half},
        {"<style>.t{transform:translate(4px,4px)}</style><rect class='t' width='4' "
         "height='4'/><rect width='4' height='4'/>",
         half},
        {"<rect x='10' y='10' width='20' height='2' transform='rotate(90)' transform-origin='20 "
         "20'/><rect x='10' y='10' width='20' height='2'/>",
         0.19},
        {"<rect style='width:8px;height:4px'/>", half},
        {"<style>rect{width:8px;height:4px}</style><rect/>", half},
        {"<rect width='20%' height='10%'/>", half},
        {"<rect width='8mm' height='4mm'/>", half},
        {"<rect width='1in' height='48px'/>", half},
        {"<rect rx='auto' width='8' height='4'/>", half},
        {"<g font-size='4'><rect width='2em' height='4'/></g>", half},
    };
    check(cases);
    const Case round[] = {
        {"<style>circle{r:4px}</style><circle/>", pi / 4},
        {"<circle cx='50%' cy='50%' r='10%'/>", pi / 4},
        {"<ellipse ry='2' rx='4'/>", pi / 8},
        {"<ellipse rx='4'/>", pi / 4},
    };
    check(round, 3e-4);  // the library's circles
}

TEST_CASE("pens have joins, caps, limits and dashes", "[svg][svg-cases]") {
    // An arm of 20 and one of 20 under a pen of 4: the corner is (22, 2) out, or cut.
    constexpr double corner = 22.0 * 22.0;
    const Case cases[] = {
        {"<path d='M4 4H24V24' fill='none' stroke='#000' stroke-width='4'/>", 160 / corner},
        {"<path d='M4 4H24V24' fill='none' stroke='#000' stroke-width='4' "
         "stroke-linejoin='bevel'/>",
         158 / corner},
        {"<path d='M4 4H24V24' fill='none' stroke='#000' stroke-width='4' "
         "stroke-miterlimit='1.4'/>",
         158 / corner},
        {"<path d='M4 4H24V24' fill='none' stroke='#000' stroke-width='4' "
         "stroke-miterlimit='1.42'/>",
         160 / corner},
        {"<path d='M4 4H24V24' fill='none' stroke='#000' stroke-width='4' "
         "stroke-linecap='square'/>",
         176 / 576.0},
        {"<path d='M2 10H22' fill='none' stroke='#000' stroke-width='4'/>", 0.2},
        {"<path d='M2 10H22' stroke='#000' stroke-width='4'/>", 0.2},
        {"<polyline points='2,10 10,10 22,10' stroke='#000' stroke-width='4'/>", 0.2},
        {"<path d='M2 10H22' fill='none' stroke='#000' stroke-width='4' stroke-dasharray='4'/>",
         0.12},
        {"<path d='M2 10H22' fill='none' stroke='#000' stroke-width='4' stroke-dasharray='4 4' "
         "stroke-dashoffset='8'/>",
         0.12},
        {"<path d='M2 10H22' fill='none' stroke='#000' stroke-width='4' stroke-dasharray='8 0'/>",
         0.2},
        {"<path d='M2 10H22' fill='none' stroke='#000' stroke-width='4' stroke-dasharray='0 0'/>",
         0.2},
        {"<path d='M4 4h0' fill='none' stroke='#000' stroke-width='4' stroke-linecap='square'/>",
         1},
        {"<g transform='scale(2 1)'><path d='M2 10H12' fill='none' stroke='#000' "
         "stroke-width='4'/></g>",
         0.2},
        {"<style>path{stroke:red;stroke-width:4;fill:none;stroke-dasharray:4,4}</style><path d='M2 "
         "10H22'/>",
         0.12},
        {"<style>path{stroke:red;stroke-width:4;fill:none;stroke-linejoin:bevel}</style><path "
         "d='M4 4H24V24'/>",
         158 / corner},
        {"<path d='M0 0H20V20H0V0' fill='none' stroke='#000' stroke-width='4'/>",
         (24 * 24 - 16 * 16 - 4) / 576.0},
    };
    check(cases, 1e-5);
    const Case round[] = {
        {"<path d='M8 8H24' fill='none' stroke='#000' stroke-width='8' stroke-linecap='round'/>",
         (128 + 16 * pi) / 576},
        {"<path d='M4 4h0' fill='none' stroke='#000' stroke-width='4' stroke-linecap='round'/>",
         pi / 4},
        {"<circle r='8' fill='none' stroke='#000' stroke-width='4'/>", pi * (100 - 36) / 400},
    };
    check(round, 1e-3);
}

TEST_CASE("strokes beside fills are left out and said, or taken in", "[svg][svg-cases]") {
    const std::string body =
        "<rect x='2' y='2' width='8' height='8' stroke='red' stroke-width='4'/>"
        "<path d='M0 20H12' stroke='red' stroke-width='2' fill='none'/>";
    const Shape fills = shape_of_body(body);
    CHECK(fills.area == Approx(1));
    CHECK(remarks_of(fills).find("1 unfilled stroke, 1 stroke around a fill") != std::string::npos);
    const Shape all = shape_of_body(body, true);
    CHECK(all.area == Approx((144 + 24) / 441.0).epsilon(1e-6));
    CHECK(all.remarks.empty());
}

TEST_CASE("what is left out, or not followed, is said and refused strictly", "[svg][svg-cases]") {
    struct Said {
        const char* body;
        const char* words;
    };
    const Said cases[] = {
        {SEEN "<text x='4'>A</text><text>B</text><image href='x.png' width='9' height='9'/>",
         "left out 2 texts, 1 image"},
        {SEEN "<path d='M0 0H9' stroke='red' fill='none'/>", "1 unfilled stroke"},
        {"<filter id='f'/>" SEEN "<rect width='1' height='1' x='5' y='5' style='filter:url(#f)'/>",
         "1 filter"},
        {"<linearGradient id='n'><stop/><stop offset='1' stop-opacity='0'/></linearGradient><rect "
         "width='8' height='4' fill='url(#n)'/>",
         "1 gradient that fades"},
        {"<pattern id='p' width='2' height='2'><rect width='1' height='1'/></pattern><rect "
         "width='8' height='4' fill='url(#p)'/>",
         "1 pattern"},
        {"<mask id='m'><rect width='9' height='9'/><rect fill='#fff' width='9' "
         "height='9'/></mask><rect width='8' height='4' mask='url(#m)'/>",
         "1 mask"},
        {"<style>.a{fill:var(--q)}</style>" SEEN "<rect class='a' x='4' y='4' width='1' "
         "height='1'/>",
         "var(--q)"},
        {"<style>@media (min-width:9px){.a{fill:none}}</style>" SEEN, "@media (min-width:9px)"},
        {"<style>@supports (x:y){.a{fill:none}}</style>" SEEN, "@supports"},
        {"<style>@import 'a.css';</style>" SEEN, "imports another"},
        {"<style>rect:is(.q){fill:none}</style>" SEEN, ":is"},
        {"<style>rect{transform-origin:50% 50%}</style>" SEEN, "transform-origin"},
        {"<rect x='4' y='4' width='8' height='4'><animate attributeName='x' to='9'/></rect>",
         "1 animation"},
        {"<script>1</script>" SEEN, "1 script"},
        {SEEN "<use href='other.svg#a'/>", "another file"},
        {SEEN "<foreignObject width='9' height='9'/>", "1 foreignObject"},
        {"<rect x='30' y='4' width='20' height='10'/>", "1 shape lies in part outside its page"},
    };
    for (const Said& one : cases) {
        INFO(one.body);
        const Shape shape = shape_of_body(one.body);
        INFO(remarks_of(shape));
        CHECK(shape.area == Approx(half).epsilon(1e-6));
        CHECK(remarks_of(shape).find(one.words) != std::string::npos);
        SvgSettings settings;
        settings.strict = true;
        const std::string text = std::string("<svg viewBox='0 0 40 40'>") + one.body + "</svg>";
        try {
            (void)parse_svg("strict.svg", text, settings);
            FAIL("accepted");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::input_refused);
            CHECK(std::string(error.what()).find(one.words) != std::string::npos);
        }
    }
}

TEST_CASE("a plain drawing needs no library, and others say which", "[svg][svg-cases]") {
    const char* plain[] = {
        SEEN,
        "<g transform='scale(2)'>" SEEN "</g>",
        "<rect width='8' height='4' style='fill:#123456;stroke:none;font-family:\"A B\"'/>",
        "<defs><linearGradient id='g'><stop style='stop-color:#fff'/></linearGradient></defs><rect "
        "width='8' height='4' fill='url(#g)'/>",
        "<title>t</title><desc>d</desc><metadata/>" SEEN,
    };
    for (const char* body : plain) {
        INFO(body);
        CHECK(shape_of_body(body).remarks.empty());
    }
    for (const char* body : {"<style/>" SEEN, "<use href='#a'/><rect id='a' width='8' height='4'/>",
                             "<rect width='8' height='4' style='FILL:red'/>"}) {
        INFO(body);
        CHECK(remarks_of(shape_of_body(body)).find("through librsvg") != std::string::npos);
    }
}

TEST_CASE("by its page a drawing is cut off and stretched", "[svg][svg-cases]") {
    const auto area = [](const char* text) {
        SvgSettings settings;
        settings.page = true;
        return parse_svg("page.svg", text, settings).area;
    };
    CHECK(area("<svg viewBox='0 0 40 40'><rect x='32' y='0' width='99' height='4'/></svg>") ==
          Approx(half).epsilon(1e-6));
    CHECK(area("<svg width='80' height='40' viewBox='0 0 40 40'><rect x='-99' y='0' width='999' "
               "height='40'/></svg>") == Approx(half).epsilon(1e-6));
    CHECK(area("<svg width='80' height='40' viewBox='0 0 40 40' preserveAspectRatio='none'><rect "
               "width='40' height='40'/></svg>") == Approx(half).epsilon(1e-6));
}

TEST_CASE("lengths of the page that set no scale are no reason to refuse", "[svg][svg-cases]") {
    for (const char* attributes :
         {"width='100vw' height='100vh' viewBox='0 0 40 40'", "viewBox='0 0 40mm 40mm'",
          "width='calc(1px + 2px)'", "width='auto' height='auto'", "viewBox=''", "viewBox='0 0 40'",
          "width='40mm' height='40mm' viewBox='0,0 40,40'"}) {
        INFO(attributes);
        CHECK(parse_svg("page.svg", std::string("<svg ") + attributes + ">" SEEN "</svg>").area ==
              Approx(half).epsilon(1e-8));
    }
}

TEST_CASE("a drawing in UTF-16 is read, and its errors name its lines", "[svg][svg-cases]") {
    const std::string text = "<svg>\n\n<rect width='1' height='1' transform='spin(3)'/></svg>";
    std::string wide = "\xFF\xFE";
    for (const char c : text) wide += {c, '\0'};
    try {
        (void)parse_svg("wide.svg", wide);
        FAIL("accepted");
    } catch (const lod::Error& error) {
        CHECK(std::string(error.what()).find("line 3, column 2") != std::string::npos);
    }
}
