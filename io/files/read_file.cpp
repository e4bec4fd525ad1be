#include "lodlab/io/files/read_file.hpp"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "lodlab/core/base/error.hpp"

namespace lod {

namespace fs = std::filesystem;

std::string read_text_file(const fs::path& path, std::size_t most_bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    const std::uintmax_t bytes = is_regular_file(status) ? file_size(path, error) : 0;
    if (error)
        throw Error(ErrorKind::input_refused,
                    "cannot read " + path.string() + ": " + error.message() + "; check the name");
    if (!is_regular_file(status))
        throw Error(ErrorKind::input_refused,
                    "cannot read " + path.string() + ": not a regular file; name a file");
    if (bytes > most_bytes)
        throw Error(ErrorKind::limit_exceeded, "cannot read " + path.string() + ": " +
                                                   std::to_string(bytes) + " bytes, the limit is " +
                                                   std::to_string(most_bytes) +
                                                   "; simplify the file or raise the limit");
    std::ifstream in(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    if (!in.read(text.data(), static_cast<std::streamsize>(bytes)))
        throw Error(ErrorKind::input_refused, "cannot read " + path.string() + ": " +
                                                  std::strerror(errno) + "; check its permissions");
    return text;
}

}  // namespace lod
