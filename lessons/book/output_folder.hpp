#pragma once

#include <filesystem>

namespace lessons {

/// A folder in the making: complete under its final name, or absent. Files go to path(), a part
/// beside it; commit() adds a list of them with their hashes and renames. A folder that is there
/// already is replaced only where it is empty, or such a list names all that it holds, unchanged.
/// Any other is refused (output failed), before there is any work and again before it would go.
class OutputFolder {
  public:
    explicit OutputFolder(const std::filesystem::path& final_path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
    void commit();

  private:
    void check_replaceable(const std::filesystem::path& there) const;
    void make_part();

    std::filesystem::path final_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

}  // namespace lessons
