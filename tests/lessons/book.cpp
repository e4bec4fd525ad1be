#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "lessons/book/book.hpp"
#include "lessons/book/page.hpp"
#include "lessons/engine/lessons.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/live/page/page.hpp"
#include "tests/catch.hpp"
#include "tests/lessons/scratch.hpp"

using namespace lessons;
namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

BookOptions lesson_one() {
    BookOptions options;
    options.lessons = {1};
    options.video = false;
    return options;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
        found.push_back(it->str());
    return found;
}

std::size_t entries_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("every picture of a page has an alt text, both colour schemes and a file that exists",
          "[lessons]") {
    const Scratch folder;
    write_book(folder.path() / "book", lesson_one());
    const fs::path page = folder.path() / "book" / "distance_test" / "index.html";
    const std::string html = content(page);
    const auto images = matches(html, "<img [^>]*>");
    REQUIRE(images.size() == run(1).steps.size() + 1);  // the steps and the figure of the text
    for (const std::string& image : images) {
        CHECK(std::regex_search(image, std::regex("alt=\"[^\"]{20,}\"")));
        const std::size_t name = image.find("src=\"") + 5;
        const std::string svg =
            content(page.parent_path() / image.substr(name, image.find('"', name) - name));
        CHECK(svg.find("prefers-color-scheme:dark") != std::string::npos);
    }
    for (const std::string& link : matches(html, "(src|srcset|href)=\"[^\"#]+\"")) {
        const std::string target = link.substr(link.find('"') + 1);
        INFO(link);
        CHECK(fs::exists(page.parent_path() / target.substr(0, target.size() - 1)));
    }
    CHECK(html.find("<math") != std::string::npos);
    CHECK(html.find("{{") == std::string::npos);
    CHECK(html.find("$$") == std::string::npos);
}

TEST_CASE("a live part is hidden until a script shows it, its files are the book's and a scene",
          "[lessons]") {
    const Scratch folder;
    const fs::path book = folder.path() / "book";
    write_book(book, lesson_one());
    const std::string html = content(book / "distance_test" / "index.html");
    const auto parts = matches(html, "<section class=\"live\"[^>]*>");
    CHECK(fs::exists(book / "lodlab.js") == live::has_module());
    if (!live::has_module()) {
        CHECK(parts.empty());
        CHECK(html.find("live_part") == std::string::npos);
        CHECK_FALSE(fs::exists(book / "live.js"));
        return;
    }
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].ends_with(" hidden>"));
    CHECK(html.find("lodlab.js") == std::string::npos);  // is not read before its reader is there
    const std::string scene = content(book / "distance_test" / "scene.js");
    CHECK(scene.starts_with("var lodlabScene = \"{"));
    CHECK(content(book / "live.js").find("lodlabLive") != std::string::npos);
}

TEST_CASE("a figure of many columns, or a tall one, has a second layout for narrow windows",
          "[lessons]") {
    viz::Figure figure;
    figure.panels.resize(3);
    figure.columns = 2;
    CHECK_FALSE(narrow_picture(figure));
    figure.columns = 3;
    REQUIRE(narrow_picture(figure));
    CHECK(narrow_picture(figure)->figure.columns == 2);
    CHECK_FALSE(narrow_picture(figure)->is_strip);
    figure.panels.resize(6);
    REQUIRE(narrow_picture(figure));
    CHECK(narrow_picture(figure)->is_strip);
    CHECK(narrow_picture(figure)->figure.columns == 6);
    figure.columns = 1;
    figure.aspect = 1;
    REQUIRE(narrow_picture(figure));
    CHECK(narrow_picture(figure)->figure.columns == 1);
    CHECK(narrow_picture(figure)->figure.aspect > 1.2);
}

TEST_CASE("no file of the book names a resource on a network", "[lessons]") {
    const Scratch folder;
    write_book(folder.path() / "book", lesson_one());
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "book")) {
        if (!entry.is_regular_file()) continue;
        INFO(entry.path());
        const std::string text = content(entry.path());
        CHECK(matches(text, "(src|href|srcset|url\\(|@import|fetch\\()[=\\s\"'(]*(https?:)?//")
                  .empty());
    }
}

TEST_CASE("a book replaces a book but no other folder", "[lessons]") {
    const Scratch folder;
    const fs::path book = folder.path() / "book";
    write_book(book, lesson_one());
    const std::string before = content(book / "index.html");
    fs::create_directory(book / "empty");
    write_book(book, lesson_one());
    CHECK(content(book / "index.html") == before);
    CHECK(entries_in(folder.path()) == 1);

    const fs::path other = folder.path() / "other";
    fs::create_directory(other);
    std::ofstream(other / "letter.txt") << "mine";
    CHECK_THROWS_AS(write_book(other, lesson_one()), lod::Error);
    CHECK(content(other / "letter.txt") == "mine");
    CHECK(entries_in(folder.path()) == 2);
}

TEST_CASE("what a reader put into a book, or changed in it, is not lost", "[lessons]") {
    const Scratch folder;
    const fs::path book = folder.path() / "book";
    write_book(book, lesson_one());
    const auto check_refused = [&](const std::string& name, const BookOptions& options) {
        try {
            write_book(book, options);
            FAIL("a file of the reader's was lost");
        } catch (const lod::Error& error) {
            CHECK(error.kind() == lod::ErrorKind::output_failed);
            CHECK_THAT(error.what(), lodtest::contains("holds " + name));
        }
        CHECK(content(book / name) == "mine");
        CHECK(entries_in(folder.path()) == 1);
    };
    for (const std::string name : {"notes.txt", "distance_test/notes.txt"}) {
        std::ofstream(book / name) << "mine";
        check_refused(name, lesson_one());
        fs::remove(book / name);
    }
    BookOptions during = lesson_one();  // while the pages are made
    during.progress = [&](const BookProgress&) { std::ofstream(book / "late.txt") << "mine"; };
    check_refused("late.txt", during);
    fs::remove(book / "late.txt");
    std::ofstream(book / "book.css") << "mine";
    check_refused("book.css", lesson_one());
}

TEST_CASE("what a book that was killed left half-written goes with the next one", "[lessons]") {
    const Scratch folder;
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    const auto part = [&](pid_t process) {
        return folder.path() / ("book.lodlab-part" + std::to_string(process) + "-0");
    };
    for (const pid_t process : {dead, ::getppid()}) {
        fs::create_directory(part(process));
        std::ofstream(part(process) / "index.html") << "half";
    }
    write_book(folder.path() / "book", lesson_one());
    CHECK_FALSE(fs::exists(part(dead)));
    CHECK(fs::exists(part(::getppid())));
}

TEST_CASE("a book that is stopped leaves nothing behind", "[lessons]") {
    const Scratch folder;
    BookOptions options = lesson_one();
    int pictures = 0;
    options.progress = [&](const BookProgress& progress) {
        CHECK(progress.share > 0);
        CHECK(progress.share <= 1);
        if (++pictures == 3) lod::stop_requested = true;
    };
    CHECK_THROWS_AS(write_book(folder.path() / "book", options), lod::Interrupted);
    lod::stop_requested = false;
    CHECK(entries_in(folder.path()) == 0);
}

TEST_CASE("a book below a file is refused", "[lessons]") {
    const Scratch folder;
    std::ofstream(folder.path() / "file") << "x";
    try {
        write_book(folder.path() / "file" / "book", lesson_one());
        FAIL("a book was written below a file");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::output_failed);
    }
}

TEST_CASE("the index names every lesson of the book and no other", "[lessons]") {
    const Scratch folder;
    write_book(folder.path() / "book", lesson_one());
    const std::string html = content(folder.path() / "book" / "index.html");
    CHECK(html.find("Do two circles touch?") != std::string::npos);
    CHECK(html.find("circle_tree") == std::string::npos);
}

TEST_CASE("a listing is escaped and its comments and keywords are marked", "[lessons]") {
    const std::string html = listing_html("return a < b;  // less & \"more\"\n");
    CHECK(html.find("<span class=\"keyword\">return</span> a &lt; b;") != std::string::npos);
    CHECK(html.find("<span class=\"comment\">// less &amp; &quot;more&quot;</span>") !=
          std::string::npos);
}
