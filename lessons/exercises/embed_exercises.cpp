// Build tool: writes exercises as C++: their words, and the reference solution with every mistake
// and every two of them in it, each in a namespace of its own.
//     lodlab_embed_exercises OUTPUT ROOT PART/NAME...
// An exercise is ROOT/lessons/exercises/tasks/PART/NAME.md, and the function make_NAME of NAME.cpp
// beside it.

#include <set>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/embed/tool.hpp"
#include "lessons/exercises/words.hpp"

namespace {

using exercises::Words;
using lessons::literal;

/// Takes the includes out of the code.
std::string without_includes(const std::string& code, std::set<std::string>& includes) {
    std::string rest;
    for (const std::string& line : lessons::lines_of(code)) {
        if (line.starts_with("#include"))
            includes.insert(line);
        else
            rest += line + "\n";
    }
    return rest;
}

/// The variants of one exercise; `table` becomes their list.
std::string variants_of(const Words& words, std::set<std::string>& includes, std::string& table) {
    std::ostringstream code;
    int number = 0;
    for (const std::vector<int>& mistakes : exercises::mixtures_of(words)) {
        const std::string space = words.name + "_" + std::to_string(number++);
        code << "namespace " << space << " {\n"
             << without_includes(exercises::code_with(words, mistakes), includes) << words.harness
             << "Numbers answer_in_numbers(const Numbers& asked) {\n"
             << "    return wire::Call<" << exercises::signature_of(words) << ">::answer("
             << words.name << ", {asked.data(), asked.data() + asked.size()});\n}\n}  // namespace "
             << space << "\n\n";
        table += "        {{";
        for (const int mistake : mistakes) table += std::to_string(mistake) + ",";
        table += "}, " + space + "::answer_in_numbers},\n";
    }
    return code.str();
}

void embed(const std::vector<std::string>& arguments) {
    const std::string& root = arguments.at(1);
    std::set<std::string> includes;
    std::ostringstream spaces;
    std::ostringstream declared;
    std::ostringstream listed;
    for (std::size_t i = 2; i < arguments.size(); ++i) {
        const std::string& path = arguments[i];
        const std::string markdown =
            lessons::read(root + "/lessons/exercises/tasks/" + path + ".md");
        const Words words = exercises::read_words(path, markdown);
        std::string table;
        spaces << variants_of(words, includes, table);
        declared << "Task make_" << words.name << "();\n";
        listed << "    {" << i - 1 << ", read_words(\"" << path << "\", " << literal(markdown)
               << "), make_" << words.name << "(), {\n"
               << table << "    }},\n";
    }
    std::ostringstream file;
    file << "// Written by lodlab_embed_exercises; do not edit.\n";
    for (const std::string& include : includes) file << include << "\n";
    file << "#include \"lessons/exercises/embedded.hpp\"\n"
         << "#include \"lessons/exercises/wire.hpp\"\n\nnamespace exercises {\nnamespace {\n\n"
         << spaces.str() << "}  // namespace\n\n"
         << declared.str() << "\nconst std::vector<Exercise>& all() {\n"
         << "    static const std::vector<Exercise> exercises{\n"
         << listed.str() << "    };\n    return exercises;\n}\n\nconst std::string& wire_text() {\n"
         << "    static const std::string text = "
         << literal(lessons::read(root + "/lessons/exercises/wire.hpp"))
         << ";\n    return text;\n}\n\n}  // namespace exercises\n";
    lessons::write(arguments.at(0), file.str());
}

}  // namespace

int main(int count, char** values) {
    return lessons::run_tool(count, values, embed);
}
