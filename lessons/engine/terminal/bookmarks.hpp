#pragma once

#include <filesystem>
#include <string>

namespace lessons {

/// The step at which a student left each lesson, in a file.
class Bookmarks {
  public:
    explicit Bookmarks(std::filesystem::path file) : file_(std::move(file)) {}
    /// lodlab/lessons.json in $XDG_STATE_HOME, or in ~/.local/state. Where neither is there,
    /// nothing is kept.
    [[nodiscard]] static Bookmarks of_user();

    /// 1 where none is kept, or the file cannot be read.
    [[nodiscard]] int step(const std::string& lesson) const;
    /// Throws lod::Error (output failed).
    void keep(const std::string& lesson, int step) const;

  private:
    std::filesystem::path file_;
};

}  // namespace lessons
