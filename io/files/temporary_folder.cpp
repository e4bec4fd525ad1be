#include "lodlab/io/files/temporary_folder.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "lodlab/core/base/error.hpp"

namespace lod {

TemporaryFolder::TemporaryFolder(std::string_view purpose) {
    std::error_code failed;
    const std::filesystem::path around = std::filesystem::temp_directory_path(failed);
    std::string name = (around / "lodlab-XXXXXX").string();
    if (failed || ::mkdtemp(name.data()) == nullptr)
        throw Error(ErrorKind::output_failed, "no folder can be made in " + around.string() +
                                                  " for " + std::string(purpose) +
                                                  "; set TMPDIR to one that can be written");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace lod
