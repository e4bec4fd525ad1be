#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lodlab/viz/paint/canvas/canvas.hpp"

namespace viz {

/// A colour of the sample and how much it counts.
struct WeighedColour {
    std::array<double, 3> at;  ///< blue, green, red
    double weight = 0;
};

/// The 255 colours that serve a whole GIF best, found from a sample of its frames, and the nearest
/// one for every pixel. No dithering: flat inks stay flat, and the file small.
///
/// libavfilter's palettegen and paletteuse were tried instead (5.1, dither=none): nobody could tell
/// the pictures apart, the mean error was less (0.4 for 0.5 of 255 in the plane, 0.8 for 2.0 in
/// dark space) and the worst larger (37 for 23), but files grew by 8 % in the plane and by 26 to 32
/// % in space, and the library brings 17 packages of 59 MB that every start of the program would
/// load.
class GifPalette {
  public:
    static constexpr int colours = 255;  ///< one of 256 is left for "as before"

    /// Counts a frame's colours.
    void sample(const Image& image);

    /// Median cut over all colours counted, rare inks weighted up, so that a thin line keeps its
    /// own. Call once, after the samples and before `index`.
    void choose();

    /// Blue, green, red, opaque: as a little-endian 0xAARRGGBB.
    [[nodiscard]] const std::array<std::uint32_t, 256>& entries() const { return entries_; }

    /// Writes for every pixel the index of the nearest entry, `stride` bytes from row to row.
    void map(const Image& image, std::uint8_t* out, int stride);

  private:
    [[nodiscard]] std::uint8_t index(std::uint8_t blue, std::uint8_t green, std::uint8_t red);
    static constexpr int bits = 6;  ///< of each channel that the histogram tells apart
    struct Bin {
        std::uint64_t count = 0;
        std::uint64_t blue = 0;
        std::uint64_t green = 0;
        std::uint64_t red = 0;
    };
    [[nodiscard]] static std::size_t bin_of(std::uint8_t blue, std::uint8_t green,
                                            std::uint8_t red);
    [[nodiscard]] std::size_t nearest_entry(std::uint32_t colour) const;
    [[nodiscard]] std::vector<WeighedColour> counted() const;

    std::vector<Bin> bins_ = std::vector<Bin>(std::size_t{1} << (3 * bits));
    std::array<std::uint32_t, 256> entries_{};
    std::vector<std::int16_t> nearest_ =
        std::vector<std::int16_t>(std::size_t{1} << (3 * bits), std::int16_t{-1});
};

}  // namespace viz
