#include "lodlab/lod3d/solid/generators.hpp"

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using namespace lod3d;

TEST_CASE("every named solid is closed, manifold, turned outwards and in one piece",
          "[generators]") {
    for (const auto& generator : generators()) {
        INFO(generator.name);
        std::vector<double> values;
        for (const auto& parameter : generator.parameters) values.push_back(parameter.standard);
        const Mesh mesh = generator.make(values);
        CHECK(find_bad_edges(mesh).none());
        CHECK(find_parts(mesh).count == 1);
        CHECK(integrate(mesh).volume > 0);
        const Box box = bounding_box(mesh);
        CHECK((box.high - box.low).maxCoeff() == Approx(1).epsilon(0.06));
        const Solid solid = generate(generator.name);
        CHECK(solid.mended.empty());
        CHECK_FALSE(solid.approximate);
    }
}

TEST_CASE("the extremes that a named solid allows are solids, or refused with a reason",
          "[generators]") {
    for (const auto& generator : generators())
        for (std::size_t which = 0; which < generator.parameters.size(); ++which)
            for (const double value :
                 {generator.parameters[which].least, generator.parameters[which].most}) {
                INFO(generator.name << " " << generator.parameters[which].name << " " << value);
                std::vector<double> values;
                for (const auto& parameter : generator.parameters)
                    values.push_back(parameter.standard);
                values[which] = value;
                try {
                    const Mesh mesh = generator.make(values);
                    CHECK(find_bad_edges(mesh).none());
                    CHECK(integrate(mesh).volume > 0);
                } catch (const lod::Error& error) {
                    CHECK(error.kind() == lod::ErrorKind::input_refused);
                }
            }
}

TEST_CASE("volumes of the straight solids are those worked by hand", "[generators]") {
    CHECK(generate("box:1,2,3").volume == Approx(6).epsilon(1e-14));
    CHECK(generate("L:0.3").volume == Approx((0.3 + 0.7 * 0.3) * 0.3).epsilon(1e-13));
    CHECK(generate("cross:0.25").volume ==
          Approx(3 * 0.0625 - 2 * 0.015625).epsilon(1e-13));  // three bars share one cube
    CHECK(generate("tetrahedron").volume == Approx(1.0 / 3).epsilon(1e-14));
    // A gear of land 0.5 and root 0.375 is at least the root's polygon, at most the land's.
    const double gear = generate("gear:9").volume;
    CHECK(gear > 0.2 * 3.0 * 0.375 * 0.375);
    CHECK(gear < 0.2 * 3.1416 * 0.25);
    CHECK(generate("gear:9,0.25,0.4").volume < gear);
}

TEST_CASE("the same seed gives the same blob, another seed another", "[generators]") {
    CHECK(generate("blob:7").mesh.vertices == generate("blob:7").mesh.vertices);
    CHECK(generate("blob:7").mesh.vertices != generate("blob:8").mesh.vertices);
}

TEST_CASE("a spec of a solid that is not understood names what is", "[generators]") {
    CHECK_THROWS_WITH(generate("dodo"), lodtest::contains("box, rod, L, cross"));
    CHECK_THROWS_WITH(generate("gear:2"), lodtest::contains("from 3 to 200"));
    CHECK_THROWS_WITH(generate("knot:2,4"), lodtest::contains("share a factor"));
    CHECK_THROWS_WITH(generate("gear:9,0.5,0.6"), lodtest::contains("BORE"));
}
