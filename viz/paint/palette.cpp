#include "lodlab/viz/paint/palette.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace viz {
namespace {

constexpr Rgb rgb(std::uint32_t hex) {
    return {static_cast<double>(hex >> 16 & 0xff) / 255, static_cast<double>(hex >> 8 & 0xff) / 255,
            static_cast<double>(hex & 0xff) / 255};
}

struct Inks {
    PageInks page;
    std::array<Rgb, 3> bodies;
    Rgb wall;
    Rgb node;
    Rgb true_collision;
    Rgb contact;
    Rgb impulse;
    Rgb reference;
    Rgb unreached;
    std::array<Rgb, deepest_ink + 1> levels;
};

// A and B start from the blue and the vermilion (light), the sky blue and the orange (dark) of
// Okabe and Ito's set, moved apart in lightness so that grey print and tritanopes tell them apart,
// from each other and from the green of impulses. The third body is a violet far from both in
// lightness. Levels follow viridis, which grey print and common deficiencies keep in order, from
// what is near the ground's lightness (coarse) to what is far from it.
constexpr Inks light{
    .page = {.ground = rgb(0xFFFFFF),
             .panel = rgb(0xF5F6F8),
             .text = rgb(0x1B1E23),
             .muted = rgb(0x555B64),
             .grid = rgb(0xDDE1E6)},
    .bodies = {rgb(0x00609C), rgb(0xD55E00), rgb(0x3F2352)},
    .wall = rgb(0x5F6670),
    .node = rgb(0x9AA0A6),
    .true_collision = rgb(0xB00020),
    .contact = rgb(0x111111),
    .impulse = rgb(0x009F74),
    .reference = rgb(0x6E6E6E),
    .unreached = rgb(0xDDE1E6),
    .levels = {rgb(0xFDE725), rgb(0x86D549), rgb(0x2FB47C), rgb(0x26828E), rgb(0x3E4989),
               rgb(0x440154)},
};

constexpr Inks dark{
    .page = {.ground = rgb(0x14171C),
             .panel = rgb(0x1C2027),
             .text = rgb(0xF0F2F5),
             .muted = rgb(0xAEB5BE),
             .grid = rgb(0x343A43)},
    .bodies = {rgb(0x4A9FE0), rgb(0xF0AD2E), rgb(0xDCC6F5)},
    .wall = rgb(0x98A1AC),
    .node = rgb(0x5F6368),
    .true_collision = rgb(0xFF6B6B),
    .contact = rgb(0xF5F5F5),
    .impulse = rgb(0x3CE0B4),
    .reference = rgb(0xAAAAAA),
    .unreached = rgb(0x343A43),
    .levels = {rgb(0x5E1A93), rgb(0x4B6191), rgb(0x38936F), rgb(0x12D073), rgb(0xABE75C),
               rgb(0xFFFE25)},
};

const Inks& inks(Theme theme) {
    return theme == Theme::light ? light : dark;
}

/// The tones of a bar's parts, each weaker than the one before, and at last none.
Pen share_pen(const PageInks& page, int part) {
    constexpr std::array<double, 4> tones{0.85, 0.45, 0.15, 0};
    const double tone = tones[std::min(static_cast<std::size_t>(std::abs(part)), tones.size() - 1)];
    return {.ink = page.muted,
            .width = 1,
            .fill = tone > 0 ? 1.0 : 0.0,
            .inside = mixed(page.ground, page.text, tone)};
}

/// Whether all inks of bodies have been used once, or thrice.
bool is_second_turn(int body) {
    return std::abs(body) / 3 % 2 == 1;
}

}  // namespace

PageInks page_inks(Theme theme) {
    return inks(theme).page;
}

Rgb body_ink(Theme theme, int body) {
    const auto& bodies = inks(theme).bodies;
    return bodies[static_cast<std::size_t>(std::abs(body)) % bodies.size()];
}

Pen pen(Theme theme, Role role, int body) {
    const Inks& of = inks(theme);
    const Rgb own = body_ink(theme, body);
    switch (role) {
        case Role::body:
            return {.ink = own, .width = 2, .fill = 0.15};
        case Role::wall:
            return {.ink = of.wall, .width = 2, .fill = 0.18};
        case Role::ghost:
            return {.ink = own, .width = 1.25, .fill = 0.03};
        case Role::node:
            return {.ink = of.node, .width = 1};
        case Role::level_node:
            return {.ink = own, .width = 1.75, .fill = 0.1};
        case Role::meeting_node:
            return {.ink = own, .width = 3, .fill = 0.25};
        case Role::true_collision:
            return {.ink = of.true_collision, .width = 3, .fill = 0.2, .doubled = true};
        case Role::dropped_node:
            return {.ink = own, .width = 1.5, .dashed = true};
        case Role::contact:
            return {.ink = of.contact, .width = 2.5, .fill = 1};
        case Role::normal:
            return {.ink = of.contact, .width = 2.5};
        case Role::impulse:
            return {.ink = of.impulse, .width = 3};
        case Role::velocity:
            return {.ink = own, .width = 2.5};
        case Role::trajectory:
            return {.ink = own, .width = 2};
        case Role::reference:
            return {.ink = of.reference, .width = 1.5, .dashed = true};
        case Role::curve:
            return {.ink = own, .width = 2.5, .dashed = is_second_turn(body)};
        case Role::band:
            return {.ink = own, .width = 0, .fill = 0.18};
        case Role::construction:
            return {.ink = of.page.muted, .width = 1.25};
        case Role::reached:
            return {.ink = of.page.muted, .width = 0.75, .fill = 1, .inside = of.unreached};
        case Role::share:
            return share_pen(of.page, body);
        case Role::excess:
            return {.ink = of.true_collision, .width = 1, .fill = 1};
        case Role::note:
            return {.ink = of.page.text, .width = 1.25};
    }
    return {.ink = of.page.text};
}

Pen pen(Theme theme, const Style& style) {
    Pen of = pen(theme, style.role, style.body);
    if (style.role != Role::reached) return of;
    if (style.level < 0)
        of.ink = inks(theme).node;
    else
        of.inside =
            inks(theme).levels[static_cast<std::size_t>(std::min(style.level, deepest_ink))];
    return of;
}

bool same_pen(const Style& a, const Style& b) {
    return a.role == b.role && a.body == b.body && a.opacity == b.opacity &&
           (a.role != Role::reached || a.level == b.level);
}

Rgb mixed(Rgb a, Rgb b, double share) {
    return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b)};
}

}  // namespace viz
