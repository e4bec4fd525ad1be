#include "lodlab/core/frame/schedule/entries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lodlab/core/base/lists.hpp"

namespace lod {

void Entries::choose(std::uint64_t most, std::span<const double> weights,
                     std::span<ListedFront> fronts) {
    meeting_.clear();
    for (std::size_t i = 0; i < fronts.size(); ++i)
        if (fronts[i].pairs.count > 0) meeting_.push_back(static_cast<std::int32_t>(i));
    const auto chosen = meeting_.begin() +
                        static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(most, meeting_.size()));
    const auto weight = [&](std::int32_t pair) {
        const double value = weights[at(pair)];
        return std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;
    };
    if (!weights.empty() && chosen != meeting_.begin() && chosen != meeting_.end())
        std::nth_element(meeting_.begin(), chosen, meeting_.end(),
                         [&](std::int32_t x, std::int32_t y) {
                             const double weight_x = weight(x);
                             const double weight_y = weight(y);
                             return weight_x != weight_y ? weight_x > weight_y : x < y;
                         });
    for (auto left_out = chosen; left_out != meeting_.end(); ++left_out)
        fronts[at(*left_out)].by_roots = true;
}

}  // namespace lod
