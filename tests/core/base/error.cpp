#include "lodlab/core/base/error.hpp"

#include "tests/catch.hpp"

TEST_CASE("an error is one line, whatever a file brings into it") {
    const lod::Error error(lod::ErrorKind::input_refused, "a\nb\r\nc\td\x1b[31m\x7f \xc3\xa4");
    CHECK(std::string(error.what()) == "a b  c d [31m  \xc3\xa4");
}
