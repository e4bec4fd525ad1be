#include "lodlab/core/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "lodlab/core/error.hpp"

namespace lod {
namespace {

constexpr int most_names = 100;

std::string mend(int error_number) {
    switch (error_number) {
        case ENOSPC:
        case EDQUOT:
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

}  // namespace

OutputFile::OutputFile(std::filesystem::path final_path) : final_(std::move(final_path)) {
    if (std::filesystem::is_directory(final_)) fail(EISDIR);
    for (int attempt = 0; attempt < most_names && descriptor_ < 0; ++attempt) {
        temporary_ = final_;
        temporary_ += ".part" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
        descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) fail(errno);
    }
    if (descriptor_ < 0) fail(EEXIST);
}

OutputFile::~OutputFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
}

void OutputFile::write(const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = ::pwrite(descriptor_, next, count, static_cast<off_t>(position_));
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
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
    if (::close(descriptor_) != 0) {
        descriptor_ = -1;
        const int why = errno;
        ::unlink(temporary_.c_str());
        fail(why);
    }
    descriptor_ = -1;
    if (::rename(temporary_.c_str(), final_.c_str()) != 0) {
        const int why = errno;
        ::unlink(temporary_.c_str());
        fail(why);
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
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0)
        throw Error(ErrorKind::input_refused, "cannot read " + path.string() + ": " +
                                                  std::strerror(errno) + "; check the name");
    if (!S_ISREG(status.st_mode))
        throw Error(ErrorKind::input_refused,
                    "cannot read " + path.string() + ": not a regular file; name a file");
    const auto bytes = static_cast<std::size_t>(status.st_size);
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
