#include "lodlab/io/files/read_file.hpp"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>

#include "lodlab/core/base/error.hpp"

namespace lod {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw Error(ErrorKind::input_refused, "cannot read " + path.string() + ": " + why);
}

}  // namespace

OpenFile open_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    OpenFile file;
    if (is_regular_file(status)) file.bytes = file_size(path, error);
    if (error) refuse(path, error.message() + "; check the name");
    if (!is_regular_file(status)) refuse(path, "not a regular file; name a file");
    file.in.open(path, std::ios::binary);
    if (!file.in) refuse(path, std::string(std::strerror(errno)) + "; check its permissions");
    return file;
}

std::string read_text_file(const fs::path& path, std::size_t most_bytes) {
    OpenFile file = open_file(path);
    if (file.bytes > most_bytes)
        throw Error(ErrorKind::limit_exceeded,
                    "cannot read " + path.string() + ": " + std::to_string(file.bytes) +
                        " bytes, the limit is " + std::to_string(most_bytes) +
                        "; simplify the file or raise the limit");
    std::string text(static_cast<std::size_t>(file.bytes), '\0');
    if (!file.in.read(text.data(), static_cast<std::streamsize>(text.size())))
        refuse(path, std::string(std::strerror(errno)) + "; check its permissions");
    return text;
}

}  // namespace lod
