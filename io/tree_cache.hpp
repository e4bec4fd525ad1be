#pragma once

/// \file
/// A folder of built trees, so that none is built twice.

#include <filesystem>
#include <functional>
#include <string>

#include "lodlab/core/tree/tree.hpp"

namespace io {

/// Trees that were built before, a file each. A file is named by a hash of all that decides its
/// tree, so it is right or it is not found; and it holds a hash of its own text, so that a damaged
/// one is built again. The folder may be deleted at any time.
class TreeCache {
  public:
    TreeCache() = default;  ///< remembers nothing
    /// `folder`: where they lie.
    explicit TreeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Of the user: $XDG_CACHE_HOME/lodlab where that is an absolute path, else ~/.cache/lodlab;
    /// where there is no home it remembers nothing.
    [[nodiscard]] static TreeCache of_user();

    /// Empty: remembers nothing.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// The tree of that key: what was kept, else what `build` returns, which is kept for the next
    /// time. A folder that cannot be read or written costs the next building, no more.
    template <int Dim>
    [[nodiscard]] lod::SphereTree<Dim> tree(
        const std::string& key, const std::function<lod::SphereTree<Dim>()>& build) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace io
