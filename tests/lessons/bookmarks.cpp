#include "lessons/engine/terminal/bookmarks.hpp"

#include <fstream>

#include "lessons/engine/lessons.hpp"
#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"
#include "tests/lessons/scratch.hpp"

using namespace lessons;

TEST_CASE("the step where a lesson was left is kept, for each lesson its own", "[lessons]") {
    const Scratch folder;
    const auto file = folder.path() / "state" / "lessons.json";
    CHECK(Bookmarks(file).step("traversal") == 1);
    Bookmarks(file).keep("traversal", 4);
    Bookmarks(file).keep("inertia", 2);
    CHECK(Bookmarks(file).step("traversal") == 4);
    CHECK(Bookmarks(file).step("inertia") == 2);
    Bookmarks(file).keep("traversal", 1);
    CHECK(Bookmarks(file).step("traversal") == 1);
}

TEST_CASE("a file of bookmarks that is none begins lessons at their start", "[lessons]") {
    const Scratch folder;
    const auto file = folder.path() / "lessons.json";
    for (const char* text :
         {"", "{", "[1, 2]", "{\"traversal\": \"four\"}", "{\"traversal\": 1.5}"}) {
        CAPTURE(text);
        std::ofstream(file) << text;
        CHECK(Bookmarks(file).step("traversal") == 1);
    }
    Bookmarks(file).keep("traversal", 3);
    CHECK(Bookmarks(file).step("traversal") == 3);
}

TEST_CASE("bookmarks in a folder that cannot be written are refused by its name", "[lessons]") {
    try {
        Bookmarks("/proc/none/lessons.json").keep("traversal", 3);
        FAIL("a file below /proc was written");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::output_failed);
        CHECK_THAT(error.what(), lodtest::contains("/proc/none"));
    }
}

TEST_CASE("a lesson is found by its number, its name, or a word that its name alone holds",
          "[lessons]") {
    for (const Entry& entry : list()) {
        CHECK(find_lesson(std::to_string(entry.number))->slug == entry.slug);
        CHECK(find_lesson(entry.slug)->number == entry.number);
    }
    CHECK(find_lesson("distance")->slug == "distance_test");
    CHECK_FALSE(find_lesson("circle"));  // of a tree, and to spheres
    CHECK_FALSE(find_lesson(""));
    CHECK_FALSE(find_lesson("0"));
    CHECK_FALSE(find_lesson("nothing of the kind"));
}
