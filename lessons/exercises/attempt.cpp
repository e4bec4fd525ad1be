#include "lessons/exercises/attempt.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/exercises/child.hpp"
#include "lessons/exercises/compiler_errors.hpp"
#include "lessons/exercises/embedded.hpp"
#include "lessons/exercises/wire.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/find_program.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/temporary_folder.hpp"

namespace exercises {
namespace {

namespace fs = std::filesystem;

constexpr double compile_seconds = 60;
constexpr double answer_seconds = 2;  // of all cases, which take milliseconds
constexpr std::size_t answer_memory = std::size_t{1} << 30;
constexpr std::size_t most_shown = 3;
constexpr const char* folder_for = "the compiler's work";

/// What a program that includes core/base/bits.hpp asks of the library that it is not linked to.
constexpr const char* without_library =
    "namespace lod::layout {\n"
    "const char LOD_LAYOUT = 0;\n"
    "}\n";

/// The student's file and what asks it.
std::string program_of(const Words& words, const std::string& file) {
    std::string text = "#include <asking.hpp>\n#define main students_main\n#include \"" + file;
    text += "\"\n#undef main\n" + words.harness + without_library;
    text += "int main(int, char** paths) {\n    return exercises::wire::serve<";
    text += signature_of(words) + ">(paths, [](auto&... each) { return ";
    return text + words.name + "(each...); });\n}\n";
}

std::vector<std::string> compiler_with(const std::vector<std::string>& more) {
    std::vector<std::string> words = compiler();
    for (const char* word : {"-std=c++20", "-O0", "-ffp-contract=off", "-D_GLIBCXX_ASSERTIONS",
                             "-Werror=return-type", "-fdiagnostics-color=never"})
        words.emplace_back(word);
    words.insert(words.end(), more.begin(), more.end());
    words.push_back("-I" + headers().string());
    return words;
}

/// The header of questions and answers that every program includes first. Who tries many files,
/// watching one or all of them, has it compiled when the second comes: then a file takes half the
/// time.
class Asking {
  public:
    Asking() { lod::write_text_file(folder_.path() / "asking.hpp", wire_text()); }

    const fs::path& folder() {
        const std::lock_guard lock(mutex_);
        if (++attempts_ == 2) precompile();
        return folder_.path();
    }

  private:
    void precompile() {
        const fs::path header = folder_.path() / "asking.hpp";
        const fs::path compiled = folder_.path() / "asking.hpp.gch";
        const std::string widest = "#include <lodlab/core/contact/contact.hpp>\n";
        lod::write_text_file(header, wire_text() + widest);
        const ChildEnd end = run_child(
            {compiler_with({"-x", "c++-header", header.string(), "-o", compiled.string()}),
             folder_.path() / "printed", compile_seconds});
        if (end.code == 0 && end.signal == 0) return;
        std::error_code ignored;  // it does without
        fs::remove(compiled, ignored);
        lod::write_text_file(header, wire_text());
    }

    lod::TemporaryFolder folder_{folder_for};
    std::mutex mutex_;
    int attempts_ = 0;
};

void write_cases(const fs::path& path, std::span<const Case> cases) {
    std::string bytes;
    const auto add = [&](double number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    for (const Case& one : cases) {
        add(static_cast<double>(one.numbers.size()));
        for (const double number : one.numbers) add(number);
    }
    lod::write_text_file(path, bytes);
}

/// Those that are whole: a program that broke down may have left half a one.
std::vector<Numbers> read_answers(const fs::path& path) {
    std::vector<Numbers> answers;
    std::ifstream file(path, std::ios::binary);
    const auto read = [&](double* numbers, std::size_t count) {
        const auto bytes = static_cast<std::streamsize>(count * sizeof(double));
        return bool(file.read(reinterpret_cast<char*>(numbers), bytes));
    };
    constexpr double most_numbers = 1e6;
    for (double size = 0; read(&size, 1) && size >= 0 && size <= most_numbers;) {
        Numbers answer(static_cast<std::size_t>(size));
        if (!read(answer.data(), answer.size())) break;
        answers.push_back(std::move(answer));
    }
    return answers;
}

std::string beginning_of(const fs::path& path) {
    std::string text(20'000, ' ');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

std::vector<std::string> printed(const fs::path& path) {
    std::vector<std::string> lines;
    for (const std::string& line : lessons::lines_of(beginning_of(path)))
        if (!lessons::trimmed(line).empty() && lines.size() < most_shown)
            lines.push_back(lessons::trimmed(line));
    return lines;
}

/// Empty where it compiled.
std::vector<std::string> compile(const Words& words, const fs::path& work, const fs::path& folder) {
    static Asking asking;
    const ChildCommand command{
        compiler_with({"-I" + asking.folder().string(), "-I" + work.string(),
                       "-I" + folder.string(), (work / "asking.cpp").string(), "-o",
                       (work / "program").string()}),
        work / "errors", compile_seconds};
    const ChildEnd end = run_child(command);
    if (end.late) return {"the compiler took longer than a minute"};
    if (end.signal == 0 && end.code == 0) return {};
    return compiler_errors(beginning_of(command.output), words);
}

Attempt::End end_of(const ChildEnd& end) {
    if (end.late) return Attempt::End::endless;
    if (end.signal != 0) return Attempt::End::crashed;
    return end.code == wire::threw_code ? Attempt::End::threw : Attempt::End::left;
}

}  // namespace

std::vector<std::string> compiler() {
    const char* chosen = std::getenv("CXX");
    std::istringstream in(chosen != nullptr && *chosen != 0 ? chosen : "c++");
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (words.empty()) words.emplace_back("c++");
    const fs::path program = lod::find_program(words.front());
    if (program.empty())
        throw lod::Error(lod::ErrorKind::not_installed,
                         "no C++ compiler: there is no program " + words.front() +
                             " in $PATH; sudo apt-get install -y g++, or set CXX to yours");
    words.front() = program.string();
    return words;
}

fs::path headers() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path() / LODLAB_INSTALLED_HEADERS;
    for (const fs::path& place : {installed, fs::path(LODLAB_BUILT_HEADERS)})
        if (fs::exists(place / "lodlab/core/math/sphere.hpp", ignored)) return place;
    throw lod::Error(lod::ErrorKind::not_installed,
                     "the headers of lodlab are missing: there is no " +
                         (installed.lexically_normal() / "lodlab").string() +
                         "; install lodlab again");
}

Attempt attempt(const Exercise& exercise, const std::string& code, std::span<const Case> cases,
                const fs::path& folder) {
    const lod::TemporaryFolder work(folder_for);
    const std::string file = exercise.words.name + ".cpp";
    lod::write_text_file(work.path() / file, code);
    lod::write_text_file(work.path() / "asking.cpp", program_of(exercise.words, file));
    write_cases(work.path() / "cases", cases);
    Attempt made;
    made.lines = compile(exercise.words, work.path(), folder);
    if (!made.lines.empty()) {
        made.end = Attempt::End::did_not_compile;
        return made;
    }
    const ChildEnd end =
        run_child({{(work.path() / "program").string(), (work.path() / "cases").string(),
                    (work.path() / "answers").string()},
                   work.path() / "printed",
                   answer_seconds,
                   answer_memory});
    made.answers = read_answers(work.path() / "answers");
    made.lines = printed(work.path() / "printed");
    made.signal = end.signal;
    if (made.answers.size() != cases.size() || end.signal != 0 || end.late) made.end = end_of(end);
    return made;
}

}  // namespace exercises
