#include "lessons/exercises/workshop.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/sha256.hpp"

namespace exercises {
namespace {

namespace fs = std::filesystem;

constexpr const char* notes_file = ".lodlab-exercises";
constexpr std::size_t most_bytes = 1 << 20;

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw lod::Error(lod::ErrorKind::output_failed, path.string() + ": " + why);
}

void make(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
        fail(folder,
             "this folder cannot be made: " + failed.message() + "; go into a folder of your own");
}

/// A new file, or none.
void write_new(const fs::path& path, const std::string& text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0)
        fail(path, std::string("cannot be written: ") + std::strerror(errno) +
                       "; go into a folder of your own");
    const ssize_t written = ::write(file, text.data(), text.size());
    const int why = written < 0 ? errno : ENOSPC;
    const bool whole = written == static_cast<ssize_t>(text.size());
    if (::close(file) == 0 && whole) return;
    std::error_code ignored;
    fs::remove(path, ignored);
    fail(path, std::string("cannot be written: ") + std::strerror(why) + "; make room");
}

/// As comments of at most so many letters.
std::string commented(const std::string& text) {
    constexpr std::size_t width = 96;
    std::string lines;
    std::string line = "//";
    const auto end_line = [&] {
        lines += line + "\n";
        line = "//";
    };
    for (const std::string& given : lessons::lines_of(text)) {
        const bool stands_alone = given.empty() || given.starts_with("    ");
        if (stands_alone && line != "//") end_line();
        if (stands_alone) {
            line += given.empty() ? "" : " " + given;
            end_line();
            continue;
        }
        std::istringstream words(given);
        for (std::string word; words >> word;) {
            if (line.size() + word.size() >= width) end_line();
            line += " " + word;
        }
    }
    if (line != "//") end_line();
    return lines;
}

std::string key_of(const Exercise& exercise, const std::string& code) {
    io::Sha256 hash;
    hash.add(std::string_view(code));
    hash.add(std::string_view(starter_file(exercise)));
    hash.add(std::string_view(code_with(exercise.words, {})));
    return hash.hexadecimal();
}

}  // namespace

std::string starter_file(const Exercise& exercise) {
    const Words& words = exercise.words;
    return "// Exercise " + std::to_string(exercise.number) + ": " + words.title + "\n//\n" +
           commented(words.task) + "//\n// Check it: lodlab exercise " + words.name +
           "    The next hint: lodlab exercise " + words.name + " --hint\n\n" + starter_code(words);
}

Workshop::Workshop(fs::path folder) : folder_(std::move(folder)) {
    read_notes();
}

fs::path Workshop::file(const Exercise& exercise) const {
    return folder_ / (exercise.words.name + ".cpp");
}

bool Workshop::is_begun(const Exercise& exercise) const {
    return is_there(file(exercise));
}

void Workshop::begin(const Exercise& exercise) {
    make(folder_);
    write_new(file(exercise), starter_file(exercise));
}

fs::path Workshop::reset(const Exercise& exercise) {
    fs::path kept;
    if (is_begun(exercise)) {
        int number = 1;
        do kept = file(exercise).string() + ".backup-" + std::to_string(number++);
        while (is_there(kept));
        std::error_code failed;
        fs::rename(file(exercise), kept, failed);
        if (failed)
            fail(file(exercise), "cannot be kept as " + kept.filename().string() + ": " +
                                     failed.message() + "; go into a folder of your own");
    }
    begin(exercise);
    if (notes_.erase(exercise.words.name) > 0) write_notes();
    return kept;
}

std::string Workshop::text_of(const Exercise& exercise) const {
    return lod::read_text_file(file(exercise), most_bytes);
}

Judgement Workshop::check(const Exercise& exercise) {
    const std::string code = text_of(exercise);
    if (code != starter_file(exercise)) return check(exercise, code);
    Judgement unchanged;
    unchanged.cases = cases_of(exercise).size();
    unchanged.verdict = "it is as it was begun";
    unchanged.lines = {"Complete the function " + exercise.words.name +
                       " in this file: " + declaration_of(exercise.words)};
    return unchanged;
}

Judgement Workshop::check(const Exercise& exercise, const std::string& code) {
    const std::vector<Case> cases = cases_of(exercise);
    const Judgement found =
        judge(exercise, cases, attempt(exercise, code, cases, fs::absolute(folder_)));
    Note& note = notes_[exercise.words.name];
    note.passes = found.passes;
    note.key = key_of(exercise, code);
    try {
        write_notes();
    } catch (const lod::Error&) {  // then the list checks it again
    }
    return found;
}

Progress Workshop::progress(const Exercise& exercise) {
    if (!is_begun(exercise)) return Progress::not_begun;
    const std::string code = text_of(exercise);
    if (code == starter_file(exercise)) return Progress::fails;
    const Note& note = notes_[exercise.words.name];
    const bool passes =
        note.key == key_of(exercise, code) ? note.passes : check(exercise, code).passes;
    return passes ? Progress::passes : Progress::fails;
}

std::size_t Workshop::next_hint(const Exercise& exercise) {
    Note& note = notes_[exercise.words.name];
    const std::size_t hint = std::min(note.hints, exercise.words.hints.size() - 1);
    note.hints = hint + 1;
    make(folder_);
    write_notes();
    return hint;
}

void Workshop::read_notes() {
    std::ifstream in(folder_ / notes_file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        Note note;
        if (words >> name >> note.hints >> note.passes >> note.key) notes_[name] = note;
    }
}

void Workshop::write_notes() const {
    std::string text;
    for (const auto& [name, note] : notes_)
        text += name + " " + std::to_string(note.hints) + (note.passes ? " 1 " : " 0 ") +
                (note.key.empty() ? "-" : note.key) + "\n";
    lod::write_text_file(folder_ / notes_file, text);
}

}  // namespace exercises
