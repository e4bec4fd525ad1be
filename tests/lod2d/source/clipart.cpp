#include <algorithm>
#include <filesystem>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/paths/clean_work.hpp"
#include "lodlab/lod2d/source/svg.hpp"
#include "tests/catch.hpp"

using namespace lod2d;

// Drawings that nobody here made (Debian's openclipart-svg): all of the folder `shapes`, and every
// twentieth of its many stars, which differ little.
TEST_CASE("clip art gives a clean shape or is refused in one line that names the file",
          "[svg][clipart]") {
    const std::filesystem::path folder = "/usr/share/openclipart/svg/shapes";
    if (!std::filesystem::exists(folder)) {
        WARN("openclipart-svg is not installed; nothing tested");
        return;
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".svg") files.push_back(entry.path());
    std::ranges::sort(files);
    std::size_t shapes = 0, refused = 0, stars = 0;
    for (const auto& file : files) {
        if (file.parent_path().filename() == "stars" && stars++ % 20 != 0) continue;
        INFO(file.string());
        try {
            const Shape shape = load_svg(file);
            ++shapes;
            CHECK(bounds(shape.polygon).size().maxCoeff() == Approx(1).epsilon(1e-5));
            CHECK(shape.area > 0);
            CHECK_FALSE(crosses_itself(shape.polygon));
        } catch (const lod::Error& error) {
            ++refused;
            const std::string line = error.what();
            WARN(line);
            CHECK(line.find(file.string()) != std::string::npos);
            CHECK(line.find('\n') == std::string::npos);
        }
    }
    INFO(shapes << " shapes, " << refused << " refused");
    CHECK(shapes > 300);
    CHECK(refused == 0);
}
