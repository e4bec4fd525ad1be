#include "lodlab/io/files/output_part.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>
#if !defined(_WIN32)
#include <sys/file.h>

#include <csignal>
#endif

namespace lod {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 255;  // of a file, in bytes, as the system has it
constexpr std::string_view part_mark = ".lodlab-part";

/// The number of the process that made a part, -1 where the name is not one of a part.
long process_of(const std::string& name) {
    const std::size_t mark = name.rfind(part_mark);
    if (mark == std::string::npos) return -1;
    const std::string rest = name.substr(mark + part_mark.size());
    const std::size_t dash = rest.find('-');
    const auto digits = [](std::string_view text) {
        return !text.empty() && text.size() < 10 &&
               text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (dash == std::string::npos || !digits(std::string_view(rest).substr(0, dash)) ||
        !digits(std::string_view(rest).substr(dash + 1)))
        return -1;
    return std::stol(rest.substr(0, dash));
}

#if defined(_WIN32)
bool is_alive(long process) {
    return process >= 0;
}
bool is_held(const fs::path&) {
    return true;  // nobody knows
}
#else
bool is_alive(long process) {
    return ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

/// Whether some process, perhaps of another machine, still writes this part.
bool is_held(const fs::path& part) {
    int descriptor = ::open(part.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0 && errno == EISDIR)
        descriptor = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) return true;
    const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}
#endif

}  // namespace

fs::path part_of(const fs::path& path, int attempt) {
    const std::string mark =
        std::string(part_mark) + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const std::string name = path.filename().string();
    return path.parent_path() / (name.substr(0, longest_name - mark.size()) + mark);
}

void hold_part([[maybe_unused]] int descriptor) {
#if !defined(_WIN32)
    ::flock(descriptor, LOCK_EX | LOCK_NB);
#endif
}

void sweep_parts(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const long process = process_of(entry.path().filename().string());
        if (process <= 0 || is_alive(process)) continue;
        const fs::file_type type = entry.symlink_status(ignored).type();
        if (type == fs::file_type::regular || type == fs::file_type::directory)
            old.push_back(entry.path());
    }
    for (const fs::path& part : old)
        if (!is_held(part)) fs::remove_all(part, ignored);
}

}  // namespace lod
