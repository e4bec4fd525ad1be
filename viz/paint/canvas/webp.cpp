// The one file that includes libwebp.

#include "lodlab/viz/paint/canvas/webp.hpp"

#include <glib.h>
#include <webp/encode.h>

#include <array>
#include <cmath>
#include <new>
#include <string>

namespace viz {

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
    gchar* const text = g_base64_encode(encoded, size);
    WebPFree(encoded);
    const std::string link = std::string("data:image/webp;base64,") + text;
    g_free(text);
    return link;
}

}  // namespace viz
