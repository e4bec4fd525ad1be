#include "tests/lod2d/source/svg_case.hpp"

using namespace lod2d;
using namespace lod2d::svg_cases;

#define WHITE "<rect width='40' height='40' fill='#fff'/>"
#define STRIPE "<clipPath id='a'><rect width='8' height='40'/></clipPath>"

TEST_CASE("a mask cuts by its own region, too", "[svg][svg-cases]") {
    const Case cases[] = {
        {"<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='8' height='4'>" WHITE
         "</mask><rect width='40' height='40' mask='url(#m)'/>",
         half},
        {"<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='20%' height='10%'>" WHITE
         "</mask><rect width='40' height='40' mask='url(#m)'/>",
         half},
        {"<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='8' height='4'>" WHITE
         "</mask><g transform='scale(2)' mask='url(#m)'><rect width='40' height='40'/></g>",
         half},
        {"<mask id='m' maskUnits='userSpaceOnUse' width='24' height='24'><rect width='8' "
         "height='4' fill='#fff'/></mask><g mask='url(#m)'><rect width='40' height='40'/></g>",
         half},
        {"<mask id='m' x='0' y='0' width='.5' height='.25'>" WHITE
         "</mask><rect width='16' height='16' mask='url(#m)'/>",
         half},
        {"<mask id='m' x='0' y='0' width='50%' height='25%'>" WHITE
         "</mask><rect width='16' height='16' mask='url(#m)'/>",
         half},
        // A tenth beyond the box of 20 x 10: a frame of 24 x 12 less a hole of 12 x 2.
        {"<mask id='m'>" WHITE "</mask><path d='M10 10H30V20H10z' fill='none' stroke='#000' "
         "stroke-width='8' mask='url(#m)'/>",
         (24 * 12 - 12 * 2) / 576.0},
        // Where a `use` draws what is masked and clipped.
        {"<mask id='m'><rect width='8' height='40' fill='#fff'/></mask><clipPath id='c'><rect "
         "width='40' height='4'/></clipPath><defs><rect id='r' width='40' height='40' "
         "mask='url(#m)' clip-path='url(#c)'/></defs><use href='#r'/>",
         half},
    };
    check(cases);
    for (const Case& one : cases) {
        INFO(one.body);
        CHECK(shape_of_body(one.body).remarks.size() == 1);
    }
}

TEST_CASE("a clip that is clipped itself cuts by both", "[svg][svg-cases]") {
    const Case cases[] = {
        {STRIPE "<clipPath id='c' clip-path='url(#a)'><rect width='40' height='4'/></clipPath>"
                "<rect width='40' height='40' clip-path='url(#c)'/>",
         half},
        {STRIPE "<clipPath id='c' style='clip-path:url(#a)'><rect width='40' height='4'/>"
                "</clipPath><g transform='scale(.5)' style='clip-path:url(#c)'><rect width='99' "
                "height='99'/></g>",
         half},
        {STRIPE "<clipPath id='c'><rect width='40' height='4' clip-path='url(#a)'/></clipPath>"
                "<rect width='40' height='40' clip-path='url(#c)'/>",
         half},
        {STRIPE "<clipPath id='b' clip-path='url(#a)'><rect width='40' height='4'/></clipPath>"
                "<clipPath id='c' clip-path='url(#b)'><rect width='40' height='40'/></clipPath>"
                "<rect width='40' height='40' clip-path='url(#c)'/>",
         half},
    };
    check(cases);
    for (const Case& one : cases) {
        INFO(one.body);
        CHECK(shape_of_body(one.body).remarks.size() == 1);
    }
}

namespace {

const Said not_followed[] = {
    {"<mask id='m'><rect width='9' height='9' fill='transparent'/></mask>"
     "<rect width='8' height='4' mask='url(#m)'/>",
     "1 mask"},
    {"<mask id='m'><rect width='9' height='9' fill='#ffffff00'/></mask>"
     "<rect width='8' height='4' mask='url(#m)'/>",
     "1 mask"},
    {"<mask id='m'><rect width='9' height='9' fill='rgba(255,255,255,0)'/></mask>"
     "<rect width='8' height='4' mask='url(#m)'/>",
     "1 mask"},
    {"<defs><rect id='u' width='9' height='9' fill='black'/></defs><mask id='m' fill='white'>"
     "<use href='#u'/></mask><rect width='8' height='4' mask='url(#m)'/>",
     "1 mask"},
    {"<style>g>rect{fill:red}</style><mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' "
     "width='8' height='4'>" WHITE "</mask><rect width='8' height='4' mask='url(#m)'/>",
     "1 mask"},
    {STRIPE "<defs><rect id='r' width='8' height='4' clip-path='url(#a)'/></defs>"
            "<clipPath id='c'><use href='#r'/></clipPath><rect width='8' height='4' "
            "clip-path='url(#c)'/>",
     "1 clip of a clip"},
    {STRIPE "<style>.k{clip-path:url(#c)}</style><clipPath id='c' clip-path='url(#a)'><rect "
            "width='40' height='4'/></clipPath><rect class='k' width='8' height='4'/>",
     "1 clip of a clip"},
    {STRIPE "<clipPath id='c' clip-path='url(#a)'><rect width='40' height='4'/></clipPath>"
            "<symbol id='s' clip-path='url(#c)'><rect width='8' height='4'/></symbol>"
            "<use href='#s'/>",
     "1 clip of a clip"},
    {"<symbol id='s' viewBox='0 0 8 4' preserveAspectRatio='xMidYMid slice'><rect width='8' "
     "height='4'/></symbol><use href='#s' width='16' height='8'/>",
     "<symbol> that it uses is cut off by a slice"},
    {"<symbol id='s'><rect width='8' height='4'/></symbol><use href='#s' width='8' "
     "height='4'/>",
     "has a size and no viewBox"},
    {"<marker id='m' markerUnits='userSpaceOnUse' viewBox='0 0 8 4' markerWidth='8' "
     "markerHeight='8'><rect width='8' height='4'/></marker><path d='M9 5h0' "
     "marker-start='url(#m)'/>",
     "of another shape than its viewBox"},
    {"<style>:root{transform:scale(1)}</style>" SEEN, "transform of its outermost <svg>"},
};

}  // namespace

TEST_CASE("a mask, clip or window that is not followed is said", "[svg][svg-cases]") {
    for (const Said& one : not_followed) {
        INFO(one.body);
        const Shape shape = shape_of_body(one.body);
        INFO(remarks_of(shape));
        CHECK(shape.area == Approx(half).epsilon(1e-6));
        CHECK(remarks_of(shape).find(one.words) != std::string::npos);
    }
}

TEST_CASE("an outermost element with a mask or a clip of a clip is said", "[svg][svg-cases]") {
    for (const char* attribute : {"mask='url(#m)'", "clip-path='url(#c)'"}) {
        INFO(attribute);
        const Shape shape = parse_svg(
            "root.svg", std::string("<svg viewBox='0 0 40 40' ") + attribute +
                            ">" STRIPE
                            "<clipPath id='c' clip-path='url(#a)'><rect width='40' "
                            "height='40'/></clipPath><mask id='m' maskUnits='userSpaceOnUse' x='0' "
                            "y='0' width='4' height='4'>" WHITE "</mask>" SEEN "</svg>");
        CHECK(remarks_of(shape).find("left out 1 ") != std::string::npos);
    }
}
