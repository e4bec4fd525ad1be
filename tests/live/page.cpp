#include "lodlab/live/page/page.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/live/page/controls.hpp"
#include "lodlab/live/page/embedded.hpp"
#include "lodlab/live/stage.hpp"
#include "tests/catch.hpp"
#include "tests/live/sample.hpp"

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

}  // namespace

TEST_CASE("a page is whole, and asks nothing of any network") {
    if (live::embedded::module_js().empty()) {
        CHECK_THROWS_WITH(static_cast<void>(live::page_text(sample::live_scene())),
                          Catch::Contains("scripts/wasm"));
        return;
    }
    const std::string page = live::page_text(sample::live_scene());
    CHECK(page.starts_with("<!DOCTYPE html>"));
    for (const char* name : {"{{title", "{{style", "{{inks", "{{still", "{{scene", "{{module"})
        CHECK(page.find(name) == std::string::npos);
    CHECK(page.find("<svg") < page.find("class=\"stage"));  // the still picture
    CHECK(count(page, "<script") == count(page, "</script>"));
    for (const char* outside : {"src=\"", "@import", "url(", "fetch(\"http"})
        CHECK(count(page, outside) == 0);
    CHECK(page.find("<title>A star meets a gear &middot; lodlab</title>") != std::string::npos);
}

TEST_CASE("a page offers every policy, contact model and response, by its word") {
    const std::string controls(live::embedded::controls_js());
    const auto offers = [&](auto names) {
        for (const std::string_view name : names)
            CHECK(count(controls, " " + std::string(name) + ": \"") == 1);
    };
    offers(names_of(lod::Priority{}));
    offers(names_of(lod::ContactModel{}));
    offers(names_of(lod::Response{}));
    offers(names_of(live::Shown{}));
}

TEST_CASE("every control of the page has its name here, and every name a control") {
    const std::string script(live::embedded::controls_js());
    const std::size_t begin = script.find("const parts = {");
    const std::string parts = script.substr(begin, script.find("\n  };", begin) - begin);
    std::size_t controls = 0;  // lines that begin with a key
    for (std::size_t at = parts.find("\n    "); at != std::string::npos;
         at = parts.find("\n    ", at + 1))
        controls += parts[at + 5] != ' ' && parts[at + 5] != '}' ? 1 : 0;
    CHECK(controls == live::control_names.size());
    for (const std::string_view name : live::control_names)
        CHECK(count(parts, "\n    " + std::string(name) + ": ") == 1);
}

TEST_CASE("controls are asked for by name, a choice with the words that it offers") {
    CHECK_NOTHROW(live::check_controls("level, policy level_order first_come ,shown hulls"));
    CHECK_NOTHROW(live::check_controls(""));
    CHECK_THROWS_WITH(live::check_controls("level, speeed"),
                      Catch::Contains("no control 'speeed'; there are: time, speed"));
    CHECK_THROWS_WITH(live::check_controls("policy level_order, level 3"),
                      Catch::Contains("the control level offers no choice '3'"));
    CHECK_THROWS_WITH(live::check_controls("policy fastest"), Catch::Contains("fastest"));
}

TEST_CASE("a scene's words cannot break out of its page") {
    if (live::embedded::module_js().empty()) return;
    live::Scene scene = sample::live_scene();
    scene.title = "</script><b>&\"";
    scene.actors[0].visual.name = "</script><i>";
    const std::string page = live::page_text(scene);
    CHECK(page.substr(0, page.find("<script")).find("<b>") == std::string::npos);
    CHECK(count(page, "<script") == count(page, "</script>"));
}
