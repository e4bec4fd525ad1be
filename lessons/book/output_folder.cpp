#include "lessons/book/output_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <sstream>
#include <string>
#include <system_error>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/output_part.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/sha256.hpp"

namespace lessons {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_file = "made-by-lodlab-book";
constexpr const char* list_title =
    "Written by `lodlab book`, which replaces this folder as long as it holds no other file.\n";
constexpr std::size_t most_bytes = std::size_t{1} << 30;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw lod::Error(lod::ErrorKind::output_failed, path.string() + ": " + why);
}

using Hashes = std::map<std::string, std::string>;  ///< of files, by their names in the folder

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

/// Calls visit(path, name in the folder) for all but folders.
template <class Visit>
void each_file(const fs::path& folder, const Visit& visit) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.symlink_status().type() != fs::file_type::directory)
            visit(entry.path(), entry.path().lexically_relative(folder).generic_string());
}

std::string list_of(const fs::path& folder) {
    std::string list = list_title;
    each_file(folder, [&](const fs::path& path, const std::string& name) {
        list += io::sha256(lod::read_text_file(path, most_bytes)) + " " + name + "\n";
    });
    return list;
}

Hashes listed_in(const fs::path& folder) {
    Hashes hashes;
    if (!is_there(folder / list_file)) return hashes;
    std::istringstream list(lod::read_text_file(folder / list_file, most_bytes));
    std::string hash;
    std::string name;
    std::getline(list, name);
    while (list >> hash && std::getline(list.ignore(), name)) hashes[name] = hash;
    return hashes;
}

/// The first file of a folder that lodlab did not write, or that was changed since; empty where
/// there is none.
std::string foreign_file(const fs::path& folder) {
    const Hashes ours = listed_in(folder);
    std::string foreign;
    each_file(folder, [&](const fs::path& path, const std::string& name) {
        if (!foreign.empty() || name == list_file) return;
        const auto known = ours.find(name);
        const bool is_ours = known != ours.end() && !fs::is_symlink(path) &&
                             fs::is_regular_file(path) &&
                             io::sha256(lod::read_text_file(path, most_bytes)) == known->second;
        if (!is_ours) foreign = name;
    });
    return foreign;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& final_path) : final_(fs::absolute(final_path)) {
    if (!final_.has_filename()) final_ = final_.parent_path();
    if (is_there(final_)) check_replaceable(final_);
    std::error_code failed;
    fs::create_directories(final_.parent_path(), failed);
    lod::sweep_parts(final_.parent_path());
    make_part();
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFolder::make_part() {
    int made = -1;
    for (int attempt = 0; attempt < lod::most_parts && made != 0; ++attempt) {
        temporary_ = lod::part_of(final_, attempt);
        made = ::mkdir(temporary_.c_str(), 0755);
        if (made != 0 && errno != EEXIST) break;
    }
    if (made != 0) {
        temporary_.clear();
        fail(final_, "its folder cannot be written; choose another directory");
    }
    descriptor_ = ::open(temporary_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    lod::hold_part(descriptor_);
}

/// `there`: final_, or where it was moved to.
void OutputFolder::check_replaceable(const fs::path& there) const {
    std::string foreign;
    try {
        if (fs::symlink_status(there).type() != fs::file_type::directory)
            fail(final_, "exists and is not a book; choose another directory");
        foreign = foreign_file(there);
    } catch (const fs::filesystem_error& error) {
        fail(final_,
             "cannot be looked into: " + error.code().message() + "; choose another directory");
    }
    if (!foreign.empty())
        fail(final_, "holds " + foreign +
                         ", which `lodlab book` did not write, or which was changed since; move "
                         "it elsewhere, or choose another directory");
}

void OutputFolder::commit() {
    lod::write_text_file(temporary_ / list_file, list_of(temporary_));
    std::error_code failed;
    std::error_code ignored;
    fs::path old;
    if (is_there(final_)) {
        old = temporary_;
        old += "-old";  // no part's name: if we die now, it stays
        fs::rename(final_, old, failed);
        if (failed) fail(final_, "cannot be replaced: " + failed.message());
        try {
            check_replaceable(old);
        } catch (const lod::Error&) {
            fs::rename(old, final_, ignored);
            throw;
        }
    }
    fs::rename(temporary_, final_, failed);
    if (failed) {
        if (!old.empty()) fs::rename(old, final_, ignored);
        fail(final_, "cannot be written: " + failed.message());
    }
    if (old.empty())
        temporary_.clear();
    else
        fs::rename(old, temporary_, ignored);  // the destructor removes what was ours
}

}  // namespace lessons
