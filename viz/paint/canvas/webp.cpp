// The one file that includes libwebp.

#include "lodlab/viz/paint/canvas/webp.hpp"

#include <webp/encode.h>

#include <array>
#include <cmath>
#include <new>
#include <string_view>

namespace viz {
namespace {

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            three = three << 8 | (k < bytes.size() ? static_cast<std::uint8_t>(bytes[k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

}  // namespace

Image over_ground(const Image& picture, Rgb ground) {
    constexpr unsigned full = 255;
    const std::array<double, 3> inks{ground.b, ground.g, ground.r};
    Image opaque = picture;
    for (std::size_t i = 0; i + 3 < opaque.pixels.size(); i += 4) {
        const unsigned uncovered = full - opaque.pixels[i + 3];
        for (std::size_t channel = 0; channel < inks.size(); ++channel)
            opaque.pixels[i + channel] = static_cast<std::uint8_t>(
                opaque.pixels[i + channel] + std::lround(inks[channel] * uncovered));
        opaque.pixels[i + 3] = full;
    }
    return opaque;
}

std::string webp_link(const Image& opaque) {
    constexpr float quality = 75;
    std::uint8_t* encoded = nullptr;
    const std::size_t size = WebPEncodeBGRA(opaque.pixels.data(), opaque.width, opaque.height,
                                            opaque.stride, quality, &encoded);
    if (size == 0) throw std::bad_alloc();  // the one reason that is left for such a picture
    const std::string text = base64({reinterpret_cast<const char*>(encoded), size});
    WebPFree(encoded);
    return "data:image/webp;base64," + text;
}

}  // namespace viz
