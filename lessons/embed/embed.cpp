// Build tool: writes lessons (text, listings, equations as MathML) and the files of the book as
// C++.
//     lodlab_embed OUTPUT BLAHTEXML ROOT SLUG... -- FILE...
// Lessons are ROOT/lessons/course/SLUG/lesson.{md,cpp}; listings may also name a file below ROOT.

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/embed/markdown.hpp"
#include "lessons/embed/script.hpp"
#include "lessons/embed/source.hpp"
#include "lessons/embed/tool.hpp"
#include "lodlab/core/base/error.hpp"

extern char** environ;

namespace {

using lessons::literal;
using lessons::Source;

[[noreturn]] void refuse(const std::string& why) {
    throw lod::Error(lod::ErrorKind::input_refused, why);
}

/// A child's standard output for a short standard input.
std::string run(const std::string& program, std::vector<std::string> arguments,
                const std::string& input) {
    int to_child[2];
    int from_child[2];
    if (pipe(to_child) != 0 || pipe(from_child) != 0) refuse("no pipe to " + program);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to_child[0], 0);
    posix_spawn_file_actions_adddup2(&actions, from_child[1], 1);
    for (int descriptor : {to_child[0], to_child[1], from_child[0], from_child[1]})
        posix_spawn_file_actions_addclose(&actions, descriptor);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int failed =
        posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(to_child[0]);
    close(from_child[1]);
    if (failed != 0) refuse(program + " cannot be started; install the package blahtexml");
    if (write(to_child[1], input.data(), input.size()) != static_cast<ssize_t>(input.size()))
        refuse(program + " does not read");
    close(to_child[1]);
    std::string output;
    char buffer[4096];
    for (ssize_t count; (count = ::read(from_child[0], buffer, sizeof buffer)) > 0;)
        output.append(buffer, static_cast<std::size_t>(count));
    close(from_child[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return output;
}

std::string between(const std::string& text, const std::string& open, const std::string& close) {
    const std::size_t begin = text.find(open);
    if (begin == std::string::npos) return {};
    const std::size_t inside = begin + open.size();
    std::string found = text.substr(inside, text.find(close, inside) - inside);
    while (!found.empty() && found.front() == '\n') found.erase(0, 1);
    while (!found.empty() && found.back() == '\n') found.pop_back();
    return found;
}

/// Hyphens as operators become minus signs, for browsers without a mathematical font.
std::string with_minus_signs(std::string mathml) {
    for (std::size_t at = mathml.find(">-<"); at != std::string::npos; at = mathml.find(">-<", at))
        mathml.replace(at, 3, ">\u2212<");
    return mathml;
}

std::string to_mathml(const std::string& blahtexml, const lessons::Equation& equation,
                      const std::string& where) {
    if (equation.latex.find("{{") != std::string::npos)
        refuse(where + ": a tag stands inside the equation " + equation.key());
    std::vector<std::string> arguments{
        "blahtexml",         "--mathml", "--spacing",        "moderate",
        "--mathml-encoding", "raw",      "--other-encoding", "raw"};
    if (equation.display) arguments.push_back("--displaymath");
    const std::string answer = run(blahtexml, arguments, equation.latex);
    const std::string error = between(answer, "<message>", "</message>");
    const std::string markup = with_minus_signs(between(answer, "<markup>", "</markup>"));
    if (!error.empty() || markup.empty())
        refuse(where + ": equation " + equation.key() + ": " + error);
    return std::string("<math") + (equation.display ? " display=\"block\"" : "") + ">" + markup +
           "</math>";
}

/// The listings of all sources of a lesson.
std::map<std::string, std::string> own_listings(const std::string& folder) {
    std::map<std::string, std::string> listings;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string file = entry.path().string();
        if (entry.path().extension() == ".cpp")
            listings.merge(lessons::find_listings(lessons::read(file), file));
    }
    return listings;
}

/// The definition in a file, or in the one file of a folder ("core/"), or below it, that has it.
std::string definition_in(const std::string& place, const std::string& name) {
    if (!place.ends_with("/")) return lessons::find_definition(lessons::read(place), name, place);
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
            files.insert(entry.path().string());
    for (const std::string& file : files) {
        const std::string code = lessons::read(file);
        if (lessons::has_definition(code, name)) return lessons::find_definition(code, name, file);
    }
    refuse(place + ": no definition of '" + name + "' in this folder");
}

/// One text of a lesson: the whole without its steps, a step's, or words of a question.
struct Text {
    std::string file;
    std::string markdown;
    int lines_before;  ///< in the file
};

std::vector<Text> texts_of(const lessons::Script& script) {
    std::vector<Text> texts{{script.where, script.text, 0}};
    for (const auto& [key, said] : script.live)
        texts.push_back({script.where, said.text, said.line - 1});
    for (const lessons::StepScript& step : script.steps)
        texts.push_back({script.where, step.text, step.line});
    for (const lessons::StepScript& step : script.steps)
        for (const lessons::QuestionScript& question : step.questions) {
            texts.push_back({script.where, question.prose.text, question.prose.line - 1});
            for (const lessons::QuestionLine& line : question.lines)
                texts.push_back({script.where, line.said.text, line.said.line - 1});
        }
    return texts;
}

/// The listings that a text names, from the lesson's own (which are struck off) or from a library.
void find_named_listings(const std::string& root, const Text& text,
                         std::map<std::string, std::string>& unnamed, Source& source) {
    for (const lessons::Tag& tag :
         lessons::find_tags(text.markdown, text.file, text.lines_before)) {
        if (tag.kind != "listing" || source.listings.count(tag.name)) continue;
        const std::size_t space = tag.name.find(' ');
        if (tag.name.find('/') < space && space != std::string::npos) {
            source.listings[tag.name] =
                definition_in(root + "/" + tag.name.substr(0, space), tag.name.substr(space + 1));
        } else if (const auto found = unnamed.find(tag.name); found != unnamed.end()) {
            source.listings.insert(unnamed.extract(found));
        } else {
            lessons::refuse_line(text.file,
                                 text.lines_before + lessons::line_of(text.markdown, tag.begin),
                                 "no listing '" + tag.name + "' in the sources beside it");
        }
    }
}

Source read_lesson(const std::string& root, const std::string& slug, const std::string& blahtexml) {
    const std::string folder = root + "/lessons/course/" + slug;
    const std::string where = folder + "/lesson.md";
    Source source{slug, lessons::read(where), {}, {}};
    const lessons::Script script = lessons::read_script(source.markdown, where);
    auto unnamed = own_listings(folder);
    for (const Text& text : texts_of(script)) {
        find_named_listings(root, text, unnamed, source);
        for (const lessons::Equation& equation : lessons::find_equations(text.markdown))
            if (!source.equations.count(equation.key()))
                source.equations[equation.key()] = to_mathml(blahtexml, equation, where);
    }
    if (!unnamed.empty())
        refuse(where + ": no text shows the listing '" + unnamed.begin()->first + "' of its code");
    return source;
}

std::string literal(const std::map<std::string, std::string>& table) {
    std::ostringstream code;
    code << "{";
    for (const auto& [name, text] : table)
        code << "{" << literal(name) << ", " << literal(text) << "},\n";
    code << "}";
    return code.str();
}

std::string function_of(const std::string& slug) {
    return "make_" + slug.substr(slug.find('_') + 1);
}

void embed(const std::vector<std::string>& arguments) {
    const std::string& blahtexml = arguments.at(1);
    const std::string& root = arguments.at(2);
    std::ostringstream declared;
    std::ostringstream listed;
    std::size_t i = 3;
    for (; i < arguments.size() && arguments[i] != "--"; ++i) {
        const Source source = read_lesson(root, arguments[i], blahtexml);
        declared << "void " << function_of(source.slug) << "(Lesson&);\n";
        listed << "    {{" << literal(source.slug) << ", " << literal(source.markdown) << ", "
               << literal(source.listings) << ", " << literal(source.equations) << "}, "
               << function_of(source.slug) << "},\n";
    }
    std::ostringstream file;
    file << "// Written by lodlab_embed; do not edit.\n#include \"lessons/engine/embedded.hpp\"\n\n"
         << "namespace lessons {\n"
         << declared.str() << "\nconst std::vector<EmbeddedLesson>& embedded_lessons() {\n"
         << "    static const std::vector<EmbeddedLesson> lessons{\n"
         << listed.str() << "    };\n    return lessons;\n}\n\n"
         << "const std::map<std::string, std::string>& embedded_files() {\n"
         << "    static const std::map<std::string, std::string> files{\n";
    for (++i; i < arguments.size(); ++i)
        file << "{" << literal(arguments[i].substr(arguments[i].rfind('/') + 1)) << ", "
             << literal(lessons::read(arguments[i])) << "},\n";
    file << "    };\n    return files;\n}\n\n}  // namespace lessons\n";
    lessons::write(arguments.at(0), file.str());
}

}  // namespace

int main(int count, char** values) {
    return lessons::run_tool(count, values, embed);
}
