#include "lodlab/core/base/error.hpp"
#include "tests/lod2d/source/svg_case.hpp"

using namespace lod2d;
using namespace lod2d::svg_cases;

namespace {

#define ALL "<rect class='g' width='40' height='40'/>"
#define SMALL "<rect width='4' height='4'/>"

/// Each is drawn as a browser draws it, and nothing is said but that a library read it.
template <std::size_t n>
void check_unsaid(const Case (&cases)[n]) {
    check(cases);
    for (const Case& one : cases) {
        INFO(one.body);
        const std::vector<std::string> remarks = shape_of_body(one.body).remarks;
        INFO(remarks.back());
        CHECK(remarks.size() == 1);
    }
}

}  // namespace

TEST_CASE("selectors with a prefix take elements of its namespace", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<style>@namespace s url(http://www.w3.org/2000/svg);s|rect.g{fill:none}</style>" ALL SEEN,
         half},
        {"<style>@namespace s 'http://www.w3.org/2000/svg';s|rect.g{fill:none}</style>" ALL SEEN,
         half},
        {"<style>*|rect.g{fill:none}</style>" ALL SEEN, half},
        {"<style>*|*.g{fill:none}</style>" ALL SEEN, half},
        {"<style>@namespace h url(http://www.w3.org/1999/xhtml);h|rect{fill:none}</style>" SEEN,
         half},
        {"<style>undeclared|rect{fill:none}</style>" SEEN, half},
        {"<style>[class|='g']{fill:none}</style>" ALL SEEN, half},
    };
    check_unsaid(cases);
}

TEST_CASE("transforms of CSS move in any words that stay in the plane", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<rect width='4' height='4' style='transform:scale3d(2,1,1)'/>", half},
        {"<rect width='4' height='4' style='transform:scaleX(200%) translateZ(3px)'/>", half},
        {SMALL "<rect width='4' height='4' style='transform:translate3d(4px,0,0)'/>", half},
        {SMALL "<rect width='4' height='4' style='transform:translateX(4px)'/>", half},
        {SMALL "<rect width='4' height='4' style='transform:translate(10%,0)'/>", half},
        {SMALL "<rect width='4' height='4' style='transform:translateY(10%)'/>", half},
        {"<style>.t{transform:translate(0,10%)}</style>" SMALL
         "<rect class='t' width='4' height='4'/>",
         half},
        {"<rect width='16' height='8'/><rect width='16' height='8' "
         "style='transform:translate(1rem,0)'/>",
         0.25},
        {"<rect x='8' width='8' height='4' style='transform:skewX(.125turn)'/>", 32 / 144.0},
        {"<rect x='4' width='4' height='4' style='transform:rotateZ(0) scaleX(2)'/>", half},
        {"<rect width='4' height='4' style='transform:matrix3d(2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1)'/>",
         half},
        {"<rect width='4' height='4' style='-webkit-transform:scale(2,1)'/>", half},
        // The style counts before the attribute.
        {"<rect width='4' height='4' transform='scale(9)' style='transform:scale(2,1)'/>", half},
        // No transforms: a length without its unit, an angle without its, no commas.
        {SMALL "<rect width='4' height='4' style='transform:translate(4,0)'/>", 1},
        {SEEN "<rect x='4' y='4' width='8' height='4' style='transform:rotate(30)'/>", half},
        {SEEN "<rect x='4' y='4' width='8' height='4' style='transform:scale(2) spin(3)'/>", half},
        // An origin where it is anyway.
        {"<rect width='4' height='4' style='transform:scale(2,1);transform-origin:0 0'/>", half},
        {"<rect width='4' height='4' style='transform:scale(2,1);transform-origin:left top'/>",
         half},
        {"<style>rect{transform-origin:0px 0%}</style><rect width='4' height='4' "
         "transform='scale(2,1)'/>",
         half},
    };
    check_unsaid(cases);
}

TEST_CASE("places and lengths count in every unit that the document decides", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<rect width='1rem' height='.5rem'/>", half},
        {"<rect style='width:1rem;height:.5rem'/>", half},
        {"<rect width='8q' height='4Q'/>", half},
        {"<rect width='8PX' height='4Mm'/>", 4 * 96 / 25.4 * 8 / (4 * 96 / 25.4) / (4 * 96 / 25.4)},
        {"<path d='M2 20H32' stroke='#000' stroke-width='1rem' fill='none'/>", 16 / 30.0},
        {"<g style='font-size:.5rem'><rect width='1em' height='.5em'/></g>", half},
        {"<defs><rect id='r' width='4' height='4'/></defs>" SMALL "<use href='#r' "
         "style='x:4px'/>",
         half},
        {"<defs><rect id='r' width='4' height='4'/></defs>" SMALL "<use href='#r' x='30' "
         "style='x:0;y:4px'/>",
         half},
    };
    check_unsaid(cases);
}

namespace {

const Said decided_elsewhere[] = {
    {SEEN "<rect x='4' y='4' width='20vw' height='10'/>", "width 20vw is in vw"},
    {SEEN "<rect x='4' y='4' width='1' height='1vh'/>", "height 1vh is in vh"},
    {SEEN "<circle cx='8' cy='6' r='10vmin'/>", "r 10vmin is in vmin"},
    {SEEN "<rect x='4' y='4' width='2ch' height='10'/>", "in ch"},
    {SEEN "<rect x='4' y='4' width='1svw' height='10'/>", "in svw"},
    {SEEN "<rect x='4' y='4' width='calc(1px*2)' height='1'/>", "computes width"},
    {"<style>svg{font-size:4px}.z{width:2rem;height:1px}</style>" SEEN
     "<rect class='z' x='4' y='4'/>",
     "in rem"},
    {"<rect x='4' y='4' width='8' height='4' style='clip-path:inset(1px)'/>", "inset(1px)"},
    {"<rect x='4' y='4' width='8' height='4' clip-path='circle(2px at 5px 5px)'/>", "circle("},
    {"<style>rect{clip-path:polygon(0 0,8px 0,8px 4px)}</style>" SEEN, "polygon("},
    {"<rect x='4' y='4' width='8' height='4' style='-webkit-clip-path:ellipse(2px 1px)'/>",
     "ellipse("},
    {"<rect x='4' y='4' width='8' height='4' style='clip-path:path(\"M0 0h1v1z\")'/>", "path("},
    {"<rect x='4' y='4' width='8' height='4' style='clip-path:fill-box'/>", "fill-box"},
    {"<rect x='4' y='4' width='8' height='4' style='mask:linear-gradient(#000,#fff)'/>",
     "linear-gradient("},
    {"<rect x='4' y='4' width='8' height='4' style='mask-image:url(#m)'/>", "mask-image"},
    {"<rect x='4' y='4' width='8' height='4' style='-webkit-mask-image:url(#m)'/>", "mask-image"},
    {"<rect x='4' y='4' width='8' height='4' style='transform:rotateX(60deg)'/>", "rotatex("},
    {"<rect x='4' y='4' width='8' height='4' style='transform:translate(1em,0)'/>",
     "translate(1em,0)"},
    {"<symbol id='s'/><rect x='4' y='4' width='8' height='4' "
     "style='transform:translate(10%,0)'/>",
     "translate(10%,0)"},
    {"<style>.t{transform:scale(1)}</style><rect class='t' x='2' y='2' width='4' height='2' "
     "transform='scale(2)'/>",
     "transform of their own"},
    {"<style>.u{x:9px}</style><defs><rect id='r' x='4' y='4' width='8' height='4'/></defs>"
     "<use class='u' href='#r'/>",
     "sets x, which is not followed here for <use>"},
    {"<path d='M4 4h8v4h-8z' style='d:none'/>", "sets d"},
    {"<svg style='width:30px'>" SEEN "</svg>", "its <svg> has a width in its style"},
    {"<style>@namespace url(http://www.w3.org/1999/xhtml);rect{fill:none}</style>" SEEN,
     "another namespace"},
    {"<style>@namespace x url(http://www.w3.org/1999/xlink);[x|href]{fill:none}</style>" SEEN,
     "x|"},
};

}  // namespace

TEST_CASE("what of CSS a window, a font or a box decides is said", "[svg][svg-cases]") {
    for (const Said& one : decided_elsewhere) {
        INFO(one.body);
        const Shape shape = shape_of_body(one.body);
        INFO(remarks_of(shape));
        CHECK(shape.area == Approx(half).epsilon(1e-6));
        CHECK(remarks_of(shape).find(one.words) != std::string::npos);
        CHECK(remarks_of(shape).find("option strokes") == std::string::npos);
        SvgSettings settings;
        settings.strict = true;
        const std::string text = std::string("<svg viewBox='0 0 40 40'>") + one.body + "</svg>";
        CHECK_THROWS_AS(parse_svg("strict.svg", text, settings), lod::Error);
    }
}

TEST_CASE("a refusal names the unit that it cannot follow", "[svg][svg-cases]") {
    for (const char* unit : {"vw", "ch"}) {
        try {
            (void)shape_of_body(std::string("<rect width='9") + unit + "' height='9'/>");
            FAIL("accepted");
        } catch (const lod::Error& error) {
            CHECK(std::string(error.what()).find(std::string("is in ") + unit) !=
                  std::string::npos);
        }
    }
}
