#include "lessons/engine/terminal/bookmarks.hpp"

#include <nlohmann/json.hpp>
#include <system_error>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/files/user_folder.hpp"

namespace lessons {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// An object; an empty one where the file holds none.
Json kept_in(const fs::path& file) {
    constexpr std::size_t most_bytes = 1 << 16;
    try {
        Json kept = Json::parse(lod::read_text_file(file, most_bytes), nullptr, false);
        if (kept.is_object()) return kept;
    } catch (const lod::Error&) {  // it is not there yet
    }
    return Json::object();
}

}  // namespace

Bookmarks Bookmarks::of_user() {
    const fs::path folder = lod::user_folder("XDG_STATE_HOME", fs::path(".local") / "state");
    return Bookmarks(folder.empty() ? folder : folder / "lessons.json");
}

int Bookmarks::step(const std::string& lesson) const {
    if (file_.empty()) return 1;
    const Json kept = kept_in(file_);
    const auto found = kept.find(lesson);
    return found != kept.end() && found->is_number_integer() ? found->get<int>() : 1;
}

void Bookmarks::keep(const std::string& lesson, int step) const {
    if (file_.empty()) return;
    Json kept = kept_in(file_);
    kept[lesson] = step;
    std::error_code ignored;  // the writer says what is wrong
    fs::create_directories(file_.parent_path(), ignored);
    lod::write_text_file(file_, kept.dump(1) + "\n");
}

}  // namespace lessons
