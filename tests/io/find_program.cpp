#include "lodlab/io/files/find_program.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "lodlab/io/files/temporary_folder.hpp"
#include "tests/catch.hpp"

namespace {

namespace fs = std::filesystem;

/// $PATH is another one until the end of its life.
class PathVariable {
  public:
    explicit PathVariable(const std::string& path) : before_(std::getenv("PATH")) {
        ::setenv("PATH", path.c_str(), 1);
    }
    ~PathVariable() { ::setenv("PATH", before_.c_str(), 1); }
    PathVariable(const PathVariable&) = delete;
    PathVariable& operator=(const PathVariable&) = delete;

  private:
    std::string before_;
};

void write(const fs::path& file, fs::perms permissions) {
    std::ofstream(file) << "#!/bin/sh\n";
    fs::permissions(file, permissions);
}

}  // namespace

TEST_CASE("a program is the first file of its name in $PATH that may be run") {
    const lod::TemporaryFolder root("programs");
    const fs::path& folder = root.path();
    for (const char* name : {"is_a_folder/draw", "may_not_be_run", "first", "second"})
        fs::create_directories(folder / name);
    write(folder / "may_not_be_run/draw", fs::perms::owner_read);
    write(folder / "first/draw", fs::perms::owner_all);
    write(folder / "second/draw", fs::perms::owner_all);
    const std::string before = (folder / "is_a_folder").string() +
                               "::no/root:/nowhere:" + (folder / "may_not_be_run").string() + ":";
    const PathVariable path(before + (folder / "first").string() + ":" +
                            (folder / "second").string());

    CHECK(lod::find_program("draw") == folder / "first/draw");
    CHECK(lod::find_program("paint").empty());
    CHECK(lod::find_program((folder / "second/draw").string()) == folder / "second/draw");
    CHECK(lod::find_program((folder / "second/paint").string()).empty());
    CHECK(lod::find_program((folder / "first").string()).empty());
}
