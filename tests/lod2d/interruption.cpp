// Detection interrupted after every test, in the plane: shapes with and without holes, and an exact
// overlap of polygons as the oracle.
#include "tests/interruption.hpp"

#include <initializer_list>

#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/overlap.hpp"

using namespace lod;

namespace {

/// Real shapes, convex and not, with holes and without, each with the trees of these builders.
struct Shapes {
    std::vector<lod2d::Shape> shapes;
    std::vector<lodtest::Model<2>> models;

    Shapes(int depth, std::initializer_list<lod2d::Builder> builders) {
        for (const char* spec :
             {"box",      "rod",     "triangle", "disc:24", "ring:0.7", "L",        "U",
              "cross",    "star:5",  "star:9",   "gear:7",  "arrow",    "crescent", "comb:5",
              "spiral:2", "capsule", "blob:1",   "blob:17", "blob:23",  "blob:99",  "box:2,0.3"})
            for (const lod2d::Builder builder : builders) {
                const lod2d::Shape shape = lod2d::generate(spec);
                lod2d::TreeSettings settings;
                settings.builder = builder;
                settings.depth = depth;
                Body<2> body;
                set_mass<2>(body, shape.area, Inertia<2>::Constant(shape.second_moment));
                body.tree = std::make_shared<SphereTree<2>>(lod2d::build_tree(shape, settings));
                models.push_back({shape.name, body});
                shapes.push_back(shape);
            }
    }

    [[nodiscard]] lodtest::Touching<2> touching() const {
        return [this](std::size_t i, const Body<2>& a, std::size_t j, const Body<2>& b) {
            return lod2d::overlap(shapes[i], {a.position, a.orientation}, shapes[j],
                                  {b.position, b.orientation});
        };
    }
};

}  // namespace

TEST_CASE("a thousand pairs interrupted after every test stand at their last finished level",
          "[interruption]") {
    const Shapes shapes(3, {lod2d::Builder::quadtree, lod2d::Builder::pieces});
    const auto count = lodtest::check_pairs<2>(shapes.models, shapes.touching(), 1000, 1000, 1.1);
    // All kinds of pairs were met.
    CHECK(count.touching > 300);
    CHECK(count.apart > 300);
    CHECK(count.refuted_late > 100);
}

TEST_CASE("deep trees interrupted after every test stand at their last finished level",
          "[interruption]") {
    const Shapes shapes(5, {lod2d::Builder::quadtree});
    const auto count = lodtest::check_pairs<2>(shapes.models, shapes.touching(), 20, 5000, 1.1);
    CHECK(count.touching > 5);
}
