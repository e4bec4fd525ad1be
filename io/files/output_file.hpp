#pragma once

/// \file
/// Files that are complete or absent: nothing is half-written under a final name.

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace lod {

/// A file that is complete or absent: bytes go to a part, a temporary name in the same folder, and
/// commit() flushes them to the disk and renames. Without commit() nothing is left behind; what
/// processes left in that folder that had no time to do so is removed by the next one.
/// A file that is there already keeps its permissions; one that is read-only, or no regular file,
/// is not replaced. A link is followed: what it leads to is written. Every failure (unwritable
/// folder, full disk) throws Error (output failed) naming the final file.
class OutputFile {
  public:
    /// Begins the part; what the final path names stays as it is until commit().
    explicit OutputFile(std::filesystem::path final_path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends bytes, or writes over them after seek().
    void write(const void* bytes, std::size_t count);
    /// Appends a text.
    void write(std::string_view text) { write(text.data(), text.size()); }
    /// Moves the write position, for formats that go back to fill in their header.
    void seek(std::size_t position);
    /// Bytes so far.
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Gives the file its final name.
    void commit();

    /// Where the bytes are after commit(): the file itself, no link.
    [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }
    /// Where the bytes are until commit(), for libraries that must write to a path themselves.
    [[nodiscard]] const std::filesystem::path& temporary_path() const { return temporary_; }

  private:
    [[noreturn]] void refuse(const std::string& why) const;
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path named_;  ///< as the caller has it, for messages
    std::filesystem::path final_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    std::size_t position_ = 0;
    std::size_t size_ = 0;
};

/// The whole text under a final name, or nothing.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace lod
