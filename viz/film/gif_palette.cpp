#include "lodlab/viz/film/gif_palette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace viz {
namespace {

constexpr std::array<double, 3> eye{0.6, 1.2, 1.0};  ///< how much a channel's step is seen
constexpr int flat_inks = 12;

double channel(std::uint32_t entry, std::size_t axis) {
    return static_cast<double>(entry >> (8 * axis) & 0xFF);
}

std::uint32_t packed(const std::array<double, 3>& at) {
    std::uint32_t entry = 0xFF;
    for (const std::size_t axis : {2u, 1u, 0u})
        entry = entry << 8 | static_cast<std::uint32_t>(std::lround(at[axis]));
    return entry;
}

/// Colours that share an entry.
struct Part {
    std::span<WeighedColour> colours;
    std::size_t axis = 0;  ///< the widest
    double spread = 0;     ///< weighted variance along it, times their weight
    std::array<double, 3> mean{};

    explicit Part(std::span<WeighedColour> of) : colours(of) {
        double weight = 0;
        for (const WeighedColour& c : colours) weight += c.weight;
        for (std::size_t a = 0; a < 3; ++a) {
            double along = 0;
            for (const WeighedColour& c : colours) mean[a] += c.weight * c.at[a] / weight;
            for (const WeighedColour& c : colours)
                along += eye[a] * c.weight * (c.at[a] - mean[a]) * (c.at[a] - mean[a]);
            if (along <= spread) continue;
            spread = along;
            axis = a;
        }
    }
};

/// Parts the colours that are furthest from their mean; false when nothing is left to part.
bool cut_widest(std::vector<Part>& parts) {
    const auto widest =
        std::max_element(parts.begin(), parts.end(),
                         [](const Part& a, const Part& b) { return a.spread < b.spread; });
    if (widest->spread <= 0) return false;
    const Part part = *widest;
    const auto middle = std::partition(
        part.colours.begin(), part.colours.end(),
        [&](const WeighedColour& c) { return c.at[part.axis] <= part.mean[part.axis]; });
    const auto low = static_cast<std::size_t>(middle - part.colours.begin());
    if (low == 0 || low == part.colours.size()) {
        widest->spread = 0;  // rounding: all lie on one side
        return true;
    }
    *widest = Part(part.colours.first(low));
    parts.emplace_back(part.colours.subspan(low));
    return true;
}

}  // namespace

std::size_t GifPalette::bin_of(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
    constexpr int drop = 8 - bits;
    return (static_cast<std::size_t>(blue >> drop) << (2 * bits)) |
           (static_cast<std::size_t>(green >> drop) << bits) |
           static_cast<std::size_t>(red >> drop);
}

void GifPalette::sample(const Image& image) {
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* pixel =
            image.pixels.data() +
            static_cast<std::size_t>(y) * static_cast<std::size_t>(image.stride);
        for (int x = 0; x < image.width; ++x, pixel += 4) {
            Bin& bin = bins_[bin_of(pixel[0], pixel[1], pixel[2])];
            ++bin.count;
            bin.blue += pixel[0];
            bin.green += pixel[1];
            bin.red += pixel[2];
        }
    }
}

std::vector<WeighedColour> GifPalette::counted() const {
    std::vector<WeighedColour> found;
    for (const Bin& bin : bins_) {
        if (bin.count == 0) continue;
        const auto n = static_cast<double>(bin.count);
        found.push_back({{static_cast<double>(bin.blue) / n, static_cast<double>(bin.green) / n,
                          static_cast<double>(bin.red) / n},
                         std::sqrt(n)});
    }
    return found;
}

void GifPalette::choose() {
    std::vector<WeighedColour> all = counted();
    std::vector<Part> parts;
    if (!all.empty()) parts.emplace_back(all);
    while (!parts.empty() && parts.size() < colours && cut_widest(parts)) continue;
    entries_.fill(0xFF000000);
    for (std::size_t i = 0; i < parts.size(); ++i) entries_[i] = packed(parts[i].mean);

    // The flat inks themselves, exactly: most pixels are theirs.
    const auto flat = std::min<std::ptrdiff_t>(flat_inks, static_cast<std::ptrdiff_t>(all.size()));
    std::partial_sort(all.begin(), all.begin() + flat, all.end(),
                      [](const WeighedColour& a, const WeighedColour& b) {
                          return a.weight > b.weight || (a.weight == b.weight && a.at < b.at);
                      });
    for (auto ink = all.begin(); ink != all.begin() + flat; ++ink) {
        const std::uint32_t exact = packed(ink->at);
        entries_[nearest_entry(exact)] = exact;
    }
}

std::size_t GifPalette::nearest_entry(std::uint32_t colour) const {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < colours; ++i) {
        double distance = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double step = channel(entries_[i], axis) - channel(colour, axis);
            distance += eye[axis] * step * step;
        }
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void GifPalette::map(const Image& image, std::uint8_t* out, int stride) {
    const std::uint8_t* row = image.pixels.data();
    for (int y = 0; y < image.height; ++y, row += image.stride, out += stride) {
        const std::uint8_t* pixel = row;
        for (int x = 0; x < image.width; ++x, pixel += 4)
            out[x] = index(pixel[0], pixel[1], pixel[2]);
    }
}

std::uint8_t GifPalette::index(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
    std::int16_t& known = nearest_[bin_of(blue, green, red)];
    if (known < 0)
        known = static_cast<std::int16_t>(nearest_entry(
            static_cast<std::uint32_t>(red) << 16 | static_cast<std::uint32_t>(green) << 8 | blue));
    return static_cast<std::uint8_t>(known);
}

}  // namespace viz
