#include "lodlab/io/tree_cache.hpp"

#include <algorithm>
#include <optional>
#include <system_error>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/files/user_folder.hpp"
#include "lodlab/io/sha256.hpp"
#include "lodlab/io/tree_json.hpp"

namespace io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 1'000'000'000;

/// The first line of a file of the cache.
std::string head_of(const std::string& key, std::string_view tree) {
    return "lodlab tree cache 1 " + key + " " + sha256(tree) + "\n";
}

template <int Dim>
std::optional<lod::SphereTree<Dim>> kept(const fs::path& file, const std::string& key) {
    try {
        const std::string text = lod::read_text_file(file, most_bytes);
        const std::string_view tree =
            std::string_view(text).substr(std::min(text.find('\n'), text.size() - 1) + 1);
        if (!text.starts_with(head_of(key, tree))) return {};
        return tree_from_json<Dim>(tree, file.string());
    } catch (const lod::Error&) {
        return {};
    }
}

template <int Dim>
void keep(const fs::path& file, const std::string& key, const lod::SphereTree<Dim>& tree) {
    try {
        std::error_code ignored;
        fs::create_directories(file.parent_path(), ignored);
        const std::string text = tree_to_json(tree);
        lod::write_text_file(file, head_of(key, text) + text);
    } catch (const lod::Error&) {  // built again next time
    } catch (const fs::filesystem_error&) {
    }
}

}  // namespace

TreeCache TreeCache::of_user() {
    return TreeCache(lod::user_folder("XDG_CACHE_HOME", ".cache"));
}

template <int Dim>
lod::SphereTree<Dim> TreeCache::tree(const std::string& key,
                                     const std::function<lod::SphereTree<Dim>()>& build) const {
    if (folder_.empty()) return build();
    const fs::path file = folder_ / (key + ".tree");
    if (auto known = kept<Dim>(file, key)) return std::move(*known);
    lod::SphereTree<Dim> tree = build();
    keep(file, key, tree);
    return tree;
}

template lod::SphereTree<2> TreeCache::tree(const std::string&,
                                            const std::function<lod::SphereTree<2>()>&) const;
template lod::SphereTree<3> TreeCache::tree(const std::string&,
                                            const std::function<lod::SphereTree<3>()>&) const;

}  // namespace io
