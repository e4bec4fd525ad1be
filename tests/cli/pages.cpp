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
