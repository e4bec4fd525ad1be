#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "lodlab/scenes/scene.hpp"
#include "tests/catch.hpp"

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" `");
    const auto last = text.find_last_not_of(" `");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The rows "| `key` | unit | default | meaning |" of the page, by the section they stand in: a
/// heading "## The scene", "## A body: `[[body]]`" or "## The camera: `[camera]`".
std::vector<scenes::KeyNote> documented() {
    const std::map<std::string, std::string> sections{
        {"## The scene", "scene"}, {"## A body", "body"}, {"## The camera", "camera"}};
    std::ifstream page(LODLAB_SOURCE_DIR "/scenes/README.md");
    std::vector<scenes::KeyNote> notes;
    std::string section;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) {
            section.clear();
            for (const auto& [heading, name] : sections)
                if (line.starts_with(heading)) section = name;
        }
        if (section.empty() || !line.starts_with("| `")) continue;
        std::istringstream cells(line.substr(1));
        std::vector<std::string> cell;
        for (std::string one; std::getline(cells, one, '|');) cell.push_back(trimmed(one));
        REQUIRE(cell.size() == 4);
        CHECK_FALSE(cell[3].empty());
        notes.push_back({section, cell[0], cell[1], cell[2]});
    }
    return notes;
}

std::string shown(const scenes::KeyNote& note) {
    return note.section + " | " + note.name + " | " + note.unit + " | " + note.otherwise;
}

std::vector<std::string> shown(const std::vector<scenes::KeyNote>& notes) {
    std::vector<std::string> lines;
    for (const scenes::KeyNote& note : notes) lines.push_back(shown(note));
    std::sort(lines.begin(), lines.end());
    return lines;
}

}  // namespace

TEST_CASE("the page of keys and the loader name the same keys, units and defaults") {
    const auto page = shown(documented());
    const auto loader = shown(scenes::key_notes());
    std::vector<std::string> only_on_page;
    std::vector<std::string> only_in_loader;
    std::set_difference(page.begin(), page.end(), loader.begin(), loader.end(),
                        std::back_inserter(only_on_page));
    std::set_difference(loader.begin(), loader.end(), page.begin(), page.end(),
                        std::back_inserter(only_in_loader));
    CHECK(only_on_page == std::vector<std::string>{});
    CHECK(only_in_loader == std::vector<std::string>{});
    CHECK(page.size() > 20);
}
