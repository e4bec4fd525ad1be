#include "lodlab/live/page/page.hpp"

#include "lodlab/core/base/error.hpp"
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
    const std::string page(live::embedded::page_html());
    const auto offers = [&](auto names) {
        for (const std::string_view name : names)
            CHECK(count(page, "<option value=\"" + std::string(name) + "\">") == 1);
    };
    offers(names_of(lod::Priority{}));
    offers(names_of(lod::ContactModel{}));
    offers(names_of(lod::Response{}));
    offers(names_of(live::Shown{}));
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
