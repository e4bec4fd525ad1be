#include "lodlab/lod2d/shape/generators.hpp"

#include <cstring>

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

using namespace lod2d;

namespace {

lod::ErrorKind kind_of_failure(std::string_view spec, std::string_view must_name) {
    try {
        (void)generate(spec);
    } catch (const lod::Error& error) {
        INFO(error.what());
        CHECK(std::string_view(error.what()).find(must_name) != std::string_view::npos);
        CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
        return error.kind();
    }
    FAIL("'" << spec << "' was accepted");
    return lod::ErrorKind::usage;
}

}  // namespace

TEST_CASE("every generator makes a shape of about one metre at its ranges' ends", "[generators]") {
    for (const Generator& generator : generators()) {
        INFO(generator.name);
        const Shape shape = generate(generator.name);
        const double extent = bounds(shape.polygon).size().maxCoeff();
        CHECK(extent > 0.9);
        CHECK(extent < 1.0 + 1e-12);
        CHECK(!generator.description.empty());
        for (std::size_t i = 0; i < generator.parameters.size(); ++i) {
            std::vector<double> values;
            for (const GeneratorParameter& p : generator.parameters) values.push_back(p.standard);
            for (double value : {generator.parameters[i].least, generator.parameters[i].most}) {
                if (generator.name == "capsule") continue;  // its two lengths depend on each other
                values[i] = value;
                CHECK(make_shape("end", generator.make(values)).area > 0);
            }
        }
    }
}

TEST_CASE("a spec sets the parameters in order and leaves the rest at their defaults",
          "[generators]") {
    CHECK(generate("box:2,0.5").area == 1.0);
    CHECK(generate("box:2").area == 2.0);
    CHECK(generate("polygon:4").polygon.rings[0].size() == 4);
    CHECK(generate("gear:9").polygon.rings.size() == 2);
    CHECK(generate("gear:9,0.26,0").polygon.rings.size() == 1);
    CHECK(generate("comb:6").polygon.rings[0].size() == 24);
    CHECK(generate("gear:9").name == "gear:9");
}

TEST_CASE("the same blob has the same points everywhere and other seeds others", "[generators]") {
    const Shape blob = generate("blob:7");
    CHECK(blob.polygon.rings[0] == generate("blob:7").polygon.rings[0]);
    CHECK(blob.polygon.rings[0] != generate("blob:8").polygon.rings[0]);
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a over the coordinates' bits
    for (const Point& p : blob.polygon.rings[0])
        for (double coordinate : {p.x(), p.y()}) {
            unsigned char bytes[sizeof coordinate];
            std::memcpy(bytes, &coordinate, sizeof coordinate);
            for (unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211u;
        }
    CHECK(hash == 0xe0bb87a40530683bu);
}

TEST_CASE("a spec that is not understood names what is", "[generators]") {
    using enum lod::ErrorKind;
    CHECK(kind_of_failure("dodo", "gear") == usage);
    CHECK(kind_of_failure("", "gear") == usage);
    CHECK(kind_of_failure("gear:", "gear:TEETH,DEPTH,BORE") == usage);
    CHECK(kind_of_failure("gear:x", "gear:TEETH,DEPTH,BORE") == usage);
    CHECK(kind_of_failure("gear:9,", "gear:TEETH,DEPTH,BORE") == usage);
    CHECK(kind_of_failure("box:1,2,3", "box:WIDTH,HEIGHT") == usage);
    CHECK(kind_of_failure("box:1 ,2", "box:WIDTH,HEIGHT") == usage);
}

TEST_CASE("a number out of its range is refused with the range", "[generators]") {
    using enum lod::ErrorKind;
    CHECK(kind_of_failure("gear:2", "3 to 1000") == input_refused);
    CHECK(kind_of_failure("gear:9.5", "whole number") == input_refused);
    CHECK(kind_of_failure("box:0", "0.001 to 1000") == input_refused);
    CHECK(kind_of_failure("box:-1", "WIDTH") == input_refused);
    CHECK(kind_of_failure("box:nan", "WIDTH") == input_refused);
    CHECK(kind_of_failure("box:inf", "WIDTH") == input_refused);
    CHECK(kind_of_failure("box:1e300", "WIDTH") == input_refused);
    CHECK(kind_of_failure("capsule:1,1", "less than LENGTH") == input_refused);
}
