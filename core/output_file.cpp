#include "lodlab/core/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#if defined(_WIN32)
#include <io.h>
#include <sys/stat.h>
#endif

#include "lodlab/core/error.hpp"

namespace lod {
namespace {

constexpr int most_names = 100;

std::string mend(int error_number) {
    switch (error_number) {
        case ENOSPC:
#if defined(EDQUOT)
        case EDQUOT:
#endif
            return "free some space or choose another disk";
        case EACCES:
        case EPERM:
        case EROFS:
            return "choose a folder that you may write to";
        case ENOENT:
        case ENOTDIR:
            return "make the folder first, or choose another";
        default:
            return "choose another place";
    }
}

#if defined(_WIN32)
int open_new(const std::filesystem::path& path) {
    return ::_wopen(path.c_str(), _O_RDWR | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT,
                    _S_IREAD | _S_IWRITE);
}

std::ptrdiff_t write_at(int descriptor, const char* bytes, std::size_t count,
                        std::size_t position) {
    constexpr std::size_t most_bytes = 1u << 30;
    if (::_lseeki64(descriptor, static_cast<long long>(position), SEEK_SET) < 0) return -1;
    return ::_write(descriptor, bytes, static_cast<unsigned>(std::min(count, most_bytes)));
}

int flush(int descriptor) {
    return ::_commit(descriptor);
}
#else
int open_new(const std::filesystem::path& path) {
    return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

std::ptrdiff_t write_at(int descriptor, const char* bytes, std::size_t count,
                        std::size_t position) {
    return ::pwrite(descriptor, bytes, count, static_cast<off_t>(position));
}

int flush(int descriptor) {
    return ::fsync(descriptor);
}
#endif

void remove_quietly(const std::filesystem::path& path) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path final_path) : final_(std::move(final_path)) {
    std::error_code ignored;  // opening a file there says what is wrong
    if (std::filesystem::is_directory(final_, ignored)) fail(EISDIR);
    for (int attempt = 0; attempt < most_names && descriptor_ < 0; ++attempt) {
        temporary_ = final_;
        temporary_ += ".part" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
        descriptor_ = open_new(temporary_);
        if (descriptor_ < 0 && errno != EEXIST) fail(errno);
    }
    if (descriptor_ < 0) fail(EEXIST);
}

OutputFile::~OutputFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    remove_quietly(temporary_);
}

void OutputFile::write(const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const std::ptrdiff_t written = write_at(descriptor_, next, count, position_);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail(written < 0 ? errno : ENOSPC);
        next += written;
        count -= static_cast<std::size_t>(written);
        position_ += static_cast<std::size_t>(written);
        if (position_ > size_) size_ = position_;
    }
}

void OutputFile::seek(std::size_t position) {
    position_ = position;
}

void OutputFile::commit() {
    // A pipe or a device cannot be synchronised; a full disk says so here at the latest.
    if (flush(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
    if (::close(descriptor_) != 0) {
        descriptor_ = -1;
        const int why = errno;
        remove_quietly(temporary_);
        fail(why);
    }
    descriptor_ = -1;
    std::error_code error;
    std::filesystem::rename(temporary_, final_, error);
    if (error) {
        remove_quietly(temporary_);
        fail(error.default_error_condition().value());
    }
}

void OutputFile::fail(int error_number) const {
    throw Error(ErrorKind::output_failed, "cannot write " + final_.string() + ": " +
                                              std::strerror(error_number) + "; " +
                                              mend(error_number));
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
}

std::string read_text_file(const std::filesystem::path& path, std::size_t most_bytes) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
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
    std::string text(bytes, '\0');
    if (!in.read(text.data(), static_cast<std::streamsize>(bytes)))
        throw Error(ErrorKind::input_refused, "cannot read " + path.string() + ": " +
                                                  std::strerror(errno) + "; check its permissions");
    return text;
}

}  // namespace lod
