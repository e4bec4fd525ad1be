#pragma once

/// \file
/// The stored organisation of section 4.3: every level that detection finishes is kept, and which
/// of them is answered is decided afterwards.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lod {

/// How detection and response share a frame (section 4.3). Without a quota both give the same bits.
enum class Organisation {
    interleaved,  ///< detection reserves what the response to its fronts will cost (the paper's)
    /// Half of the quota, less the entry levels, is the response's. Detection refines in the other
    /// half, whatever it finds, and keeps every level; then the stored levels are gone through in
    /// the same order, and each pair is answered at the last one for which there is enough.
    stored,
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 2> names_of(Organisation) {
    return {"interleaved", "stored"};
}
static_assert(names_of(Organisation{}).size() ==
              static_cast<std::size_t>(Organisation::stored) + 1);

/// The finished levels of a frame's candidate pairs. Keeps its storage.
class CollisionTree {
  public:
    /// Forgets all levels.
    void clear();
    /// Keeps a level that a pair has just finished, its entry level first.
    void add(std::int32_t pair, const ListedFront& front, std::span<const NodePair> node_pairs);

    /// Goes through the levels in the order in which they were kept, and replaces every pair's
    /// front by its last level that is within `most_pairs` node pairs of all fronts together; entry
    /// levels are taken whatever they cost. Returns whether all levels were.
    bool resolve(std::uint64_t most_pairs, std::vector<ListedFront>& fronts, FrontList& list);

    /// Levels that are kept.
    [[nodiscard]] std::size_t size() const { return levels_.size(); }

  private:
    struct Stored {
        std::int32_t pair = 0;
        ListedFront front;  ///< its pairs being a part of node_pairs_
    };
    std::vector<Stored> levels_;
    std::vector<NodePair> node_pairs_;
    std::vector<std::int32_t> chosen_;  ///< of each pair: into levels_; -1: none yet
};

}  // namespace lod
