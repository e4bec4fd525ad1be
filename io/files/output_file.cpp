#include "lodlab/io/files/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <sys/stat.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>
#if defined(_WIN32)
#include <io.h>
#endif

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_part.hpp"

namespace lod {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // that stand for one file, as the system has it

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
        case ENAMETOOLONG:
            return "choose a shorter name";
        case ELOOP:
            return "remove that link, or choose another name";
        case EFBIG:
            return "raise the system's limit on the size of files (ulimit -f)";
        case ENOENT:
        case ENOTDIR:
            return "make the folder first, or choose another";
        default:
            return "choose another place";
    }
}

#if defined(_WIN32)
int open_new(const fs::path& path) {
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

void keep_mode(const fs::path&, int) {}
#else
int open_new(const fs::path& path) {
    return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

std::ptrdiff_t write_at(int descriptor, const char* bytes, std::size_t count,
                        std::size_t position) {
    return ::pwrite(descriptor, bytes, count, static_cast<off_t>(position));
}

int flush(int descriptor) {
    return ::fsync(descriptor);
}

/// Gives the new file who may do what with the old one, as far as the system lets us.
void keep_mode(const fs::path& old, int descriptor) {
    struct stat status {};
    if (::stat(old.c_str(), &status) != 0) return;
    static_cast<void>(::fchown(descriptor, status.st_uid, status.st_gid) == 0);
    static_cast<void>(::fchmod(descriptor, status.st_mode & 0777));
}
#endif

void remove_quietly(const fs::path& path) {
    std::error_code ignored;
    fs::remove(path, ignored);
}

/// Where links from `path` lead, whether or not there is something. Sets `error` where they go on
/// for ever, or a name is not to be had.
fs::path followed(fs::path path, std::error_code& error) {
    for (int links = 0; links <= most_links; ++links) {
        const fs::file_status status = fs::symlink_status(path, error);
        if (status.type() == fs::file_type::not_found) error.clear();
        if (error || !fs::is_symlink(status)) return path;
        const fs::path target = fs::read_symlink(path, error);
        path = path.parent_path() / target;
    }
    error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    return path;
}

bool is_read_only(const fs::path& path, fs::perms mode) {
    constexpr fs::perms any =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    return (mode & any) == fs::perms::none || ::access(path.string().c_str(), W_OK) != 0;
}

}  // namespace

OutputFile::OutputFile(fs::path final_path) : named_(std::move(final_path)) {
    std::error_code error;
    // A link to a pipe (/dev/stdout) leads to a name that is none.
    if (fs::is_fifo(fs::status(named_, error))) refuse("it is no regular file; name a new file");
    final_ = followed(named_, error);
    if (error) fail(error.default_error_condition().value());
    const fs::file_status status = fs::status(final_, error);
    if (fs::is_directory(status)) fail(EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status))
        refuse("it is no regular file; name a new file");
    if (fs::exists(status) && is_read_only(final_, status.permissions()))
        refuse("it is read-only; make it writable (chmod u+w), or choose another name");
    sweep_parts(final_.has_parent_path() ? final_.parent_path() : ".");
    for (int attempt = 0; attempt < most_parts && descriptor_ < 0; ++attempt) {
        temporary_ = part_of(final_, attempt);
        descriptor_ = open_new(temporary_);
        if (descriptor_ < 0 && errno != EEXIST) fail(errno);
    }
    if (descriptor_ < 0) fail(EEXIST);
    hold_part(descriptor_);
    keep_mode(final_, descriptor_);
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
    fs::rename(temporary_, final_, error);
    if (error) {
        remove_quietly(temporary_);
        fail(error.default_error_condition().value());
    }
}

void OutputFile::refuse(const std::string& why) const {
    throw Error(ErrorKind::output_failed, "cannot write " + named_.string() + ": " + why);
}

void OutputFile::fail(int error_number) const {
    refuse(std::string(std::strerror(error_number)) + "; " + mend(error_number));
}

void write_text_file(const fs::path& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
}

}  // namespace lod
