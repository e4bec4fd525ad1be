#include "tests/lod2d/source/svg_case.hpp"

#include <numbers>

using namespace lod2d;
using namespace lod2d::svg_cases;
using std::numbers::pi;

TEST_CASE("style sheets decide by any selector, after any rule", "[svg][svg-cases]") {
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
    };
    check(cases);
}

TEST_CASE("style sheets decide by order, weight and spelling", "[svg][svg-cases]") {
    const Case cases[] = {
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
    };
    check(cases);
}

TEST_CASE("style sheets have media, variables and keywords as in a browser", "[svg][svg-cases]") {
    const Case cases[] = {
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
        {"<mask id='m'><rect width='8' height='40' fill='#fff'/></mask><clipPath id='c'><rect "
         "width='40' height='4'/></clipPath><g mask='url(#m)' clip-path='url(#c)'><rect width='40' "
         "height='40'/></g><rect width='40' height='40' mask='url(#m)' clip-path='url(#c)'/>",
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
