// Trees that were built before are found in the cache by the version of the builders.

#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/scenes/shapes.hpp"
#include "lodlab/scenes/trace/trace.hpp"
#include "tests/catch.hpp"

namespace {

template <int Dim>
void add_trees(const std::vector<std::string>& specs, std::optional<double> effort,
               io::Sha256& version) {
    using Shapes = scenes::Shapes<Dim>;
    for (const std::string& spec : specs)
        for (const std::string_view builder : Shapes::builders()) {
            scenes::TreeChoice choice{std::string(builder), {}, 2, {}, {}, {}};
            if (builder == "cover") choice.effort = effort;
            const auto settings = Shapes::settings(choice);
            const auto tree = Shapes::build(Shapes::named(spec, {}), settings);
            version.add(std::string_view(scenes::hexadecimal(lod::tree_hash(tree))));
        }
}

template <int Dim>
std::string key_of(const std::string& spec, const scenes::TreeChoice& choice) {
    using Shapes = scenes::Shapes<Dim>;
    io::Sha256 key;
    Shapes::identify(Shapes::named(spec, {}), Shapes::settings(choice), key);
    return key.hexadecimal();
}

}  // namespace

TEST_CASE("the version of the builders is the hash of the trees that they make") {
    io::Sha256 version;
    add_trees<2>({"star:5", "gear:5", "blob:7"}, {}, version);
    add_trees<3>({"tetrahedron", "L"}, 0.05, version);
    INFO(
        "The builders make other trees than before. Where that is meant, write the hash that they "
        "have now into scenes/shapes.hpp, builders_version: then no cache gives out old trees.");
    CHECK(std::string(scenes::builders_version) == version.hexadecimal());
}

TEST_CASE("whatever decides a tree decides its key") {
    const scenes::TreeChoice usual{"", {}, {}, {}, {}, {}};
    std::vector<std::string> keys{
        key_of<2>("box", usual),
        key_of<2>("box:2", usual),
        key_of<2>("box", {"pieces", {}, {}, {}, {}, {}}),
        key_of<2>("box", {"", 5, {}, {}, {}, {}}),
        key_of<2>("box", {"", {}, 5, {}, {}, {}}),
        key_of<2>("box", {"", {}, {}, 0.1, {}, {}}),
        key_of<2>("box", {"", {}, {}, {}, 50, {}}),
        key_of<3>("box", usual),
        key_of<3>("box:2", usual),
        key_of<3>("box", {"octree", {}, {}, {}, {}, {}}),
        key_of<3>("box", {"", 5, {}, {}, {}, {}}),
        key_of<3>("box", {"", {}, 5, {}, {}, {}}),
        key_of<3>("box", {"", {}, {}, 0.1, {}, {}}),
        key_of<3>("box", {"", {}, {}, {}, 50, {}}),
        key_of<3>("box", {"", {}, {}, {}, {}, 0.1}),
    };
    CHECK(keys[0] == key_of<2>("box:1,1", usual));  // the same numbers under another name
    std::sort(keys.begin(), keys.end());
    CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
}
