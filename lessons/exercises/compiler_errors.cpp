#include "lessons/exercises/compiler_errors.hpp"

#include <algorithm>

#include "lessons/embed/lines.hpp"

namespace exercises {
namespace {

constexpr std::size_t most_lines = 3;
constexpr std::size_t most_letters = 200;

std::string cut(std::string line) {
    if (line.size() > most_letters) line.replace(most_letters, std::string::npos, " ...");
    return line;
}

/// From the file's name on: "meet.cpp:3:5: error: ...".
std::string without_folder(const std::string& line, const std::string& file) {
    const std::size_t at = line.find(file + ":");
    return at == std::string::npos ? line : line.substr(at);
}

bool is_error(const std::string& line) {
    return line.find(": error: ") != std::string::npos ||
           line.find(": fatal error: ") != std::string::npos;
}

bool begins_in(const std::string& line, const std::string& file) {
    const std::size_t at = line.find(file + ":");
    if (at == std::string::npos) return false;
    return at == 0 || (line[at - 1] == '/' && line.find(' ') > at);
}

/// Whether it is of the code that calls the student's function.
bool asks(const std::string& line) {
    return line.find("asking.cpp:") != std::string::npos ||
           line.find("asking.hpp:") != std::string::npos;
}

/// The word between the linker's quotes: "lod::single_impulse<2>(...)".
std::string undefined_name(const std::string& line) {
    const std::size_t begin = line.find("undefined reference to `");
    if (begin == std::string::npos) return {};
    const std::size_t name = begin + std::string_view("undefined reference to `").size();
    return line.substr(name, line.rfind('\'') - name);
}

/// The errors that begin in her file.
std::vector<std::string> own_errors(const std::vector<std::string>& lines,
                                    const std::string& file) {
    std::vector<std::string> own;
    for (const std::string& line : lines)
        if (is_error(line) && begins_in(line, file) && own.size() < most_lines)
            own.push_back(cut(without_folder(line, file)));
    return own;
}

/// The place in her file that asked for a template of a header: "meet.cpp:7:20:"; empty: none did.
std::string asking_place(const std::vector<std::string>& lines, const std::string& file) {
    for (const std::string& line : lines) {
        if (!begins_in(line, file) || line.find("required from") == std::string::npos) continue;
        const std::string place = without_folder(line, file);
        return place.substr(0, place.find(' '));
    }
    return {};
}

}  // namespace

std::vector<std::string> compiler_errors(std::string_view output, const Words& words) {
    const std::string file = words.name + ".cpp";
    const std::vector<std::string> lines = lessons::lines_of(output);
    if (const std::vector<std::string> own = own_errors(lines, file); !own.empty()) return own;
    for (const std::string& line : lines)
        if (const std::string name = undefined_name(line); !name.empty())
            return {cut(name) +
                    " is neither in the file nor in a header of lodlab, whose library an exercise "
                    "does without; write it yourself"};
    const auto error = std::find_if(lines.begin(), lines.end(), is_error);
    if (error == lines.end())
        return {lines.empty() ? "the compiler said nothing" : cut(lines.front())};
    const std::string what = error->substr(error->find("error: "));
    if (const std::string place = asking_place(lines, file); !place.empty())
        return {cut(place + " " + what)};
    if (!asks(*error)) return {cut(*error)};
    return {"the function must stay as it was: " + cut(declaration_of(words)), cut(what)};
}

}  // namespace exercises
