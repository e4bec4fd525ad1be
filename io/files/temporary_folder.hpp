#pragma once

#include <filesystem>
#include <string_view>

namespace lod {

/// A folder for what lives no longer than this object.
class TemporaryFolder {
  public:
    /// `purpose` ends the sentence "no folder can be made for ...". Throws Error (output failed).
    explicit TemporaryFolder(std::string_view purpose);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace lod
