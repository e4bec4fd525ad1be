// Live pages: what is written, and what is refused.
#include <filesystem>

#include "tests/catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/text.hpp"

namespace {

/// Whether this build has the module that a page runs.
bool has_module() {
    const Scratch scratch;
    return lodlab({"page", "offset_boxes", "--out", scratch / "p.html"}).code == 0;
}

}  // namespace

TEST_CASE("a scene of the plane becomes a page, or a line says what the build lacks") {
    const Scratch scratch;
    const std::string out = scratch / "p.html";
    const Outcome outcome = lodlab({"page", "offset_boxes", "--level", "1", "--out", out});
    if (!has_module()) {
        check_failure(outcome, 6, "scripts/wasm builds it");
        CHECK(scratch.files().empty());
        return;
    }
    CHECK(outcome.code == 0);
    CHECK(outcome.out.empty());
    const std::string page = lodtest::bytes_of(out);
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(contains(page, "\"deepest_level\":1"));
    CHECK(lodlab({"page", "offset_boxes", "--level", "1", "--out", scratch / "again.html"}).code ==
          0);
    CHECK(lodtest::bytes_of(scratch / "again.html") == page);
}

TEST_CASE("a page that cannot be made is refused in one line") {
    const Scratch scratch;
    const std::string out = scratch / "p.html";
    check_failure(lodlab({"page", "no_such_scene", "--out", out}), 3, "no_such_scene");
    check_failure(lodlab({"page", "tumbling_box", "--out", out}), 3, "a scene in space");
    check_failure(lodlab({"page", "offset_boxes"}), 2, "--out is required");
    check_failure(lodlab({"page", "--out", out}), 2, "no scene given");
    check_failure(lodlab({"page", "offset_boxes", "--playground", "--out", out}), 2, "drop SCENE");
    check_failure(lodlab({"page", "offset_boxes", "--out", scratch / "p.png"}), 2,
                  "lodlab does this as html");
    check_failure(lodlab({"page", "offset_boxes", "--out", scratch / "none/p.html"}), 4, "none");
    check_failure(lodlab({"page", "offset_boxes", "--out", "/proc/p.html"}), 4, "/proc");
    if (has_module())
        check_failure(lodlab({"page", "gas:101", "--out", out}), 5, "at most 100 bodies");
    CHECK(scratch.files().empty());
}

TEST_CASE("the scene that a lesson's reader plays with becomes a page of its own") {
    const Scratch scratch;
    const std::string out = scratch / "p.html";
    check_failure(lodlab({"page", "lesson:no_such_lesson", "--out", out}), 2,
                  "no lesson no_such_lesson");
    check_failure(lodlab({"page", "lesson:inertia", "--out", out}), 2, "no scene to play with");
    check_failure(lodlab({"page", "lesson:circle_tree", "--level", "2", "--out", out}), 2,
                  "--level does not go with the page of a lesson");
    check_failure(lodlab({"page", "lesson:circle_tree", "--out", scratch / "p.png"}), 2,
                  "lodlab does this as html");
    CHECK(scratch.files().empty());
    if (!has_module()) return;
    for (const char* name : {"lesson:circle_tree", "lesson:3", "lesson:tree"}) {
        CHECK(lodlab({"page", name, "--out", out}).code == 0);
        CHECK(contains(lodtest::bytes_of(out), "\"name\":\"circle_tree\""));
    }
}
