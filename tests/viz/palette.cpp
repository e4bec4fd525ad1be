#include "lodlab/viz/paint/palette.hpp"

#include <array>
#include <cmath>
#include <string>

#include "tests/catch.hpp"

using namespace viz;

namespace {

using Triple = std::array<double, 3>;
using Matrix3 = std::array<Triple, 3>;

// Linear sRGB as seen by a reader with full colour deficiency: the matrices of severity 1.0 of
// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A Physiologically-based Model for Simulation
// of Color Vision Deficiency", IEEE TVCG 15 (2009), 1291-1298.
struct Eye {
    const char* name;
    Matrix3 sees;
};
const std::array<Eye, 4> eyes{{
    {"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}},
}};

double linear(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
Triple linear(Rgb ink) {
    return {linear(ink.r), linear(ink.g), linear(ink.b)};
}

Triple times(const Matrix3& m, const Triple& v) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) out[i] += m[i][k] * v[k];
    return out;
}

/// CIE L*a*b* (D65) of linear sRGB: a distance of 2.3 is about the least that is seen.
Triple lab(Triple rgb) {
    for (double& c : rgb) c = std::min(1.0, std::max(0.0, c));
    const Matrix3 to_xyz{{{0.4124564, 0.3575761, 0.1804375},
                          {0.2126729, 0.7151522, 0.0721750},
                          {0.0193339, 0.1191920, 0.9503041}}};
    Triple xyz = times(to_xyz, rgb);
    const Triple white{0.95047, 1, 1.08883};
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    for (std::size_t i = 0; i < 3; ++i) xyz[i] = f(xyz[i] / white[i]);
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

double distance(const Eye& eye, Rgb a, Rgb b) {
    const Triple p = lab(times(eye.sees, linear(a)));
    const Triple q = lab(times(eye.sees, linear(b)));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Lightness on grey paper.
double lightness(Rgb ink) {
    return lab(linear(ink))[0];
}

double luminance(Rgb ink) {
    const Triple c = linear(ink);
    return 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2];
}

/// Contrast ratio of WCAG 2: 1 to 21.
double contrast(Rgb a, Rgb b) {
    const double x = luminance(a) + 0.05;
    const double y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

const std::array<Theme, 2> themes{Theme::light, Theme::dark};
const char* name(Theme theme) {
    return theme == Theme::light ? "light" : "dark";
}

}  // namespace

TEST_CASE("inks that must be told apart are, with every common colour deficiency", "[palette]") {
    for (const Theme theme : themes) {
        const auto ink = [&](Role role, int body) { return pen(theme, role, body).ink; };
        const Rgb a = ink(Role::meeting_node, 0);
        const Rgb b = ink(Role::meeting_node, 1);
        const Rgb third = ink(Role::meeting_node, 2);
        const Rgb grey = ink(Role::node, 0);
        const Rgb impulse = ink(Role::impulse, 0);
        const Rgb contact = ink(Role::contact, 0);
        const std::array<std::array<Rgb, 2>, 9> pairs{{{a, b},
                                                       {a, third},
                                                       {b, third},
                                                       {a, grey},
                                                       {b, grey},
                                                       {a, impulse},
                                                       {b, impulse},
                                                       {b, ink(Role::true_collision, 0)},
                                                       {contact, impulse}}};
        for (const Eye& eye : eyes) {
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                INFO(name(theme) << ", " << eye.name << ", pair " << i);
                CHECK(distance(eye, pairs[i][0], pairs[i][1]) > 18);
            }
        }
    }
}

TEST_CASE("grey print tells body A from body B and both from nodes that end", "[palette]") {
    for (const Theme theme : themes) {
        const double a = lightness(body_ink(theme, 0));
        const double b = lightness(body_ink(theme, 1));
        const double node = lightness(pen(theme, Role::node, 0).ink);
        INFO(name(theme));
        CHECK(std::abs(a - b) > 10);
        CHECK(std::abs(a - node) > 10);
        CHECK(std::abs(b - node) > 10);
    }
}

TEST_CASE("what grey print cannot tell by ink, line and fill tell", "[palette]") {
    for (const Theme theme : themes) {
        CHECK(pen(theme, Role::meeting_node, 0).width >= 3 * pen(theme, Role::node, 0).width);
        CHECK(pen(theme, Role::node, 0).fill == 0);
        CHECK(pen(theme, Role::true_collision, 0).doubled);
        CHECK(pen(theme, Role::reference, 0).dashed);
    }
}

TEST_CASE("levels are told apart by ink, with every common colour deficiency and in grey",
          "[palette]") {
    for (const Theme theme : themes) {
        const auto ink = [&](int level) {
            return *pen(theme, Style{.role = Role::reached, .level = level}).inside;
        };
        double before = lightness(ink(0));
        const double way = lightness(ink(deepest_ink)) - before;
        for (int level = 1; level <= deepest_ink; ++level) {
            INFO(name(theme) << ", level " << level);
            const double here = lightness(ink(level));
            CHECK(std::abs(here - before) > 7);
            CHECK((here - before) * way > 0);  // grey print keeps their order
            before = here;
            for (const Eye& eye : eyes)
                for (int other = -1; other < level; ++other)
                    CHECK(distance(eye, ink(level), ink(other)) > 14);
        }
        CHECK(ink(deepest_ink + 3) == ink(deepest_ink));
        CHECK(distance(eyes[0], ink(-1), ink(0)) > 18);
    }
}

TEST_CASE("six curves are told apart by ink or by dashes", "[palette]") {
    for (const Theme theme : themes)
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < i; ++j) {
                const Pen a = pen(theme, Role::curve, i);
                const Pen b = pen(theme, Role::curve, j);
                INFO(name(theme) << ", " << i << " and " << j);
                CHECK((a.dashed != b.dashed || !(a.ink == b.ink)));
            }
}

TEST_CASE("the parts of a bar are told apart by tone, the overrun by ink", "[palette]") {
    for (const Theme theme : themes) {
        const auto tone = [&](int part) { return *pen(theme, Role::share, part).inside; };
        for (int part = 1; part < 4; ++part)
            CHECK(std::abs(lightness(tone(part)) - lightness(tone(part - 1))) > 10);
        CHECK(contrast(pen(theme, Role::excess, 0).ink, page_inks(theme).ground) > 3);
    }
}

TEST_CASE("every ink stands out from the ground, and words can be read", "[palette]") {
    for (const Theme theme : themes) {
        const PageInks page = page_inks(theme);
        INFO(name(theme));
        CHECK(contrast(page.text, page.ground) > 7);
        CHECK(contrast(page.muted, page.ground) > 4.5);
        for (const Rgb ground : {page.ground, page.panel}) {
            for (const Role role : {Role::body, Role::meeting_node, Role::true_collision,
                                    Role::contact, Role::impulse, Role::velocity})
                for (const int body : {0, 1, 2})
                    CHECK(contrast(pen(theme, role, body).ink, ground) > 3);
            CHECK(contrast(pen(theme, Role::node, 0).ink, ground) > 2);  // meant to stand back
        }
    }
}
