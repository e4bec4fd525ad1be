#include "lodlab/viz/paint/palette.hpp"

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
};

// A and B start from the blue and the vermilion (light), the sky blue and the orange (dark) of
// Okabe and Ito's set, moved apart in lightness so that grey print and tritanopes tell them apart,
// from each other and from the green of impulses. The third body is a violet far from both in
// lightness.
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
};

const Inks& inks(Theme theme) {
    return theme == Theme::light ? light : dark;
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
            return {.ink = own, .width = 2.5};
        case Role::band:
            return {.ink = own, .width = 0, .fill = 0.18};
        case Role::construction:
            return {.ink = of.page.muted, .width = 1.25};
        case Role::note:
            return {.ink = of.page.text, .width = 1.25};
    }
    return {.ink = of.page.text};
}

Rgb mixed(Rgb a, Rgb b, double share) {
    return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b)};
}

}  // namespace viz
