// Trees in files, and what is asked of a tree that was read.
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/core/frame/sweep.hpp"
#include "lodlab/io/tree_json.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

template <int Dim>
int try_tree(const std::uint8_t* bytes, std::size_t size) {
    return try_reading(bytes, size, [](std::string_view text) {
        const auto tree = io::tree_from_json<Dim>(text, "tree.json");
        static_cast<void>(lod::tree_hash(tree));
        static_cast<void>(lod::thickness(tree));
        lod::Body<Dim> body;
        body.tree = std::make_shared<lod::SphereTree<Dim>>(tree);
        static_cast<void>(lod::traverse_levels(body, body, 2));
        const std::string again = io::tree_to_json(tree);
        if (io::tree_to_json(io::tree_from_json<Dim>(again, "again")) != again) std::abort();
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try_tree<2>(bytes, size);
    return try_tree<3>(bytes, size);
}
