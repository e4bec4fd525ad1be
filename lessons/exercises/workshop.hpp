#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "lessons/exercises/exercise.hpp"
#include "lessons/exercises/judge.hpp"

namespace exercises {

/// How far a student is with an exercise.
enum class Progress { not_begun, fails, passes };

/// A student's folder of exercises: a file each, which lodlab writes once and then only reads, and
/// notes of which hints were shown and which files passed.
class Workshop {
  public:
    explicit Workshop(std::filesystem::path folder = "exercises");

    [[nodiscard]] std::filesystem::path file(const Exercise& exercise) const;
    [[nodiscard]] bool is_begun(const Exercise& exercise) const;

    /// Writes the starter file. Throws lod::Error (output failed) where it cannot, or where
    /// something stands there.
    void begin(const Exercise& exercise);
    /// Begins anew; what was there keeps another name, which is returned (empty: nothing was
    /// there).
    std::filesystem::path reset(const Exercise& exercise);

    /// Compiles the student's file and asks it every case. Throws lod::Error: not installed; input
    /// refused where the file cannot be read.
    Judgement check(const Exercise& exercise);

    /// As the notes have it, where the file is as it was then; else it is checked.
    Progress progress(const Exercise& exercise);

    /// Which hint comes next, from 0; the last one comes again. Throws lod::Error (output failed)
    /// where that cannot be noted.
    std::size_t next_hint(const Exercise& exercise);

  private:
    struct Note {
        std::size_t hints = 0;  ///< shown
        bool passes = false;
        std::string key;  ///< of the file that this is about, and of the exercise; - where it was
                          ///< not checked
    };

    void read_notes();
    void write_notes() const;
    [[nodiscard]] std::string text_of(const Exercise& exercise) const;
    Judgement check(const Exercise& exercise, const std::string& code);

    std::filesystem::path folder_;
    std::map<std::string, Note> notes_;  ///< by the exercise's name
};

/// The whole file that a student begins with.
[[nodiscard]] std::string starter_file(const Exercise& exercise);

}  // namespace exercises
