#include "lodlab/io/tree_cache.hpp"

#include <cstdlib>
#include <fstream>
#include <vector>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/sha256.hpp"
#include "lodlab/io/tree_json.hpp"
#include "tests/catch.hpp"

namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "lodlab-cache-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~TemporaryFolder() { fs::remove_all(path_); }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

template <int Dim>
lod::SphereTree<Dim> sample(double radius = 1) {
    std::vector<lod::TreeNode<Dim>> nodes(3);
    nodes[0].sphere.radius = radius;
    nodes[0].children = {1, 2};
    nodes[1].sphere = {0.3 * lod::Vector<Dim>::Unit(0), 0.5};
    nodes[2].sphere = {-1.0 / 3 * lod::Vector<Dim>::Unit(1), 0.1};
    nodes[2].mean_normal = 0.7 * lod::Vector<Dim>::Unit(1);
    return lod::lay_out<Dim>(nodes);
}

/// Asks a cache, and counts how often it builds.
template <int Dim>
struct Asked {
    io::TreeCache cache;
    int built = 0;

    std::uint64_t hash(const std::string& key) {
        return lod::tree_hash(cache.tree<Dim>(key, [this] {
            ++built;
            return sample<Dim>();
        }));
    }
};

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a tree is built once and comes back to the same bits", "[cache]",
                       ((int Dim), Dim), 2, 3) {
    const TemporaryFolder folder;
    Asked<Dim> asked{io::TreeCache(folder.path() / "made" / "here")};
    CHECK(asked.hash("key") == lod::tree_hash(sample<Dim>()));
    CHECK(asked.hash("key") == lod::tree_hash(sample<Dim>()));
    CHECK(asked.built == 1);
    (void)asked.hash("other");
    CHECK(asked.built == 2);
}

TEST_CASE("a cache without a folder builds every time") {
    Asked<2> asked;
    (void)asked.hash("key");
    (void)asked.hash("key");
    CHECK(asked.built == 2);
}

TEST_CASE("a kept tree that was damaged is built again and mended") {
    const TemporaryFolder folder;
    Asked<3> asked{io::TreeCache(folder.path())};
    const auto right = asked.hash("key");
    const fs::path file = files_in(folder.path()).at(0);
    const std::string text = lod::read_text_file(file, 100'000);
    std::vector<std::string> damaged{"",
                                     "\n",
                                     "x",
                                     text.substr(0, text.size() - 1),
                                     text.substr(0, text.size() / 2),
                                     text + " ",
                                     text.substr(text.find('\n') + 1)};
    std::string changed = text;
    changed[text.rfind('7')] = '8';  // still a tree, but another one
    damaged.push_back(changed);
    for (const std::string& bad : damaged) {
        std::ofstream(file, std::ios::trunc) << bad;
        const int before = asked.built;
        CHECK(asked.hash("key") == right);
        CHECK(asked.built == before + 1);
        CHECK(lod::read_text_file(file, 100'000) == text);
    }
}

TEST_CASE("a tree that was kept under another name or for the other dimension is not taken") {
    const TemporaryFolder folder;
    Asked<3> asked{io::TreeCache(folder.path())};
    (void)asked.hash("key");
    const fs::path file = files_in(folder.path()).at(0);
    fs::path other = file;
    fs::copy_file(file, other.replace_filename("other.tree"));
    (void)asked.hash("other");
    CHECK(asked.built == 2);
    Asked<2> flat{io::TreeCache(folder.path())};
    CHECK(flat.hash("key") == lod::tree_hash(sample<2>()));
    CHECK(flat.built == 1);
}

TEST_CASE("a folder that cannot be written costs the next building, no more") {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "not a folder";
    Asked<2> asked{io::TreeCache(folder.path() / "file" / "cache")};
    CHECK(asked.hash("key") == lod::tree_hash(sample<2>()));
    CHECK(asked.hash("key") == lod::tree_hash(sample<2>()));
    CHECK(asked.built == 2);
}

TEST_CASE("a building that a signal stops leaves nothing behind") {
    const TemporaryFolder folder;
    const io::TreeCache cache(folder.path());
    CHECK_THROWS_AS(cache.tree<2>("key",
                                  []() -> lod::SphereTree<2> {
                                      lod::stop_requested = true;
                                      lod::check_interrupted();
                                      return sample<2>();
                                  }),
                    lod::Interrupted);
    lod::stop_requested = false;
    CHECK(files_in(folder.path()).empty());
}
