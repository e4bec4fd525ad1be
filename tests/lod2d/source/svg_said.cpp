#include "tests/lod2d/source/svg_case.hpp"

#include <numbers>

#include "lodlab/core/base/error.hpp"

using namespace lod2d;
using namespace lod2d::svg_cases;
using std::numbers::pi;

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
}

TEST_CASE("round pens end in half circles", "[svg][svg-cases]") {
    const Case round[] = {
        {"<path d='M8 8H24' fill='none' stroke='#000' stroke-width='8' stroke-linecap='round'/>",
         (128 + 16 * pi) / 576},
        {"<path d='M4 4h0' fill='none' stroke='#000' stroke-width='4' stroke-linecap='round'/>",
         pi / 4},
        {"<circle r='8' fill='none' stroke='#000' stroke-width='4'/>", pi * (100 - 36) / 400},
        // Half a ring of radii 3 and 13, its ends cut straight.
        {"<path d='M12 20A8 8 0 0 1 28 20' fill='none' stroke='#000' stroke-width='10' "
         "stroke-linejoin='round'/>",
         pi * (169 - 9) / 2 / (26 * 26)},
        {"<path d='M4 10H27' fill='none' stroke='#000' stroke-width='4' stroke-dasharray='0 8' "
         "stroke-linecap='round'/>",
         3 * pi * 4 / (20 * 20)},
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

namespace {

const Said left_out[] = {
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
    {SEEN "<path d='M5 5h5' pathLength='5' stroke='red' stroke-dasharray='1'/>", "pathLength"},
    {SEEN "<foreignObject width='9' height='9'/>", "1 foreignObject"},
    {"<rect x='30' y='4' width='20' height='10'/>", "1 shape lies in part outside its page"},
};

}  // namespace

TEST_CASE("what is left out, or not followed, is said and refused strictly", "[svg][svg-cases]") {
    for (const Said& one : left_out) {
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

TEST_CASE("a compressed drawing is read, within the limit of bytes", "[svg][svg-cases]") {
    const std::string packed(
        "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xb3\x29\x2e\x4b\xb7\xb3"
        "\x29\x4a\x4d\x2e\x51\x28\xcf\x4c\x29\xc9\xb0\x55\xb7\x50\x57\xc8"
        "\x48\xcd\x4c\xcf\x28\xb1\x55\x37\x51\xd7\xb7\xb3\xd1\x07\xa9\x00"
        "\x00\x36\xca\x6b\x29\x27\x00\x00\x00",
        57);
    CHECK(parse_svg("box.svgz", packed).area == Approx(half).epsilon(1e-8));
    SvgSettings settings;
    settings.most_bytes = 20;
    CHECK_THROWS_AS(parse_svg("box.svgz", packed, settings), lod::Error);
    CHECK_THROWS_AS(parse_svg("box.svgz", packed.substr(0, 30)), lod::Error);
}

TEST_CASE("a scribble of thousands of lines ends at a named limit", "[svg][svg-cases]") {
    std::string d = "M0 0";
    for (int i = 1; i < 3000; ++i) {  // scattered by a multiplier that shares nothing with 1009
        d.append(" ").append(std::to_string(i * 389 % 1009));
        d.append(" ").append(std::to_string(i * i % 1013));
    }
    for (const char* ink : {"", " fill='none' stroke='#000'"}) {
        try {
            (void)parse_svg("scribble.svg", "<svg><path d='" + d + "'" + ink + "/></svg>");
            FAIL("accepted");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::limit_exceeded);
            CHECK(std::string(error.what()).find("120000 crossings") != std::string::npos);
        }
    }
}

TEST_CASE("custom properties that name themselves and each other end, and are said", "[svg]") {
    const std::string twice = "var(--%) var(--%)";
    std::string sheet = ":root{--a:red;--z:var(--z)";
    for (char name = 'b'; name < 'z'; ++name) {  // each is twice the one before
        std::string value = twice;
        for (char& c : value)
            if (c == '%') c = static_cast<char>(name - 1);
        sheet += std::string(";--") + name + ":" + value;
    }
    for (const char* used : {"var(--y)", "var(--z)"}) {
        const Shape shape =
            shape_of_body("<style>" + sheet + "} .no{fill:" + used + "}</style>" SEEN);
        CHECK(shape.area == Approx(half).epsilon(1e-6));
        CHECK(remarks_of(shape).find("which is not resolved here") != std::string::npos);
    }
}
