// Build tool: writes exercises as C++: their words, and the reference solution with every mistake
// and every two of them in it, each in a namespace of its own. What stands above the function is
// compiled once for all of them.
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

/// What every variant of the code begins with: all that stands above its function, unless a mistake
/// does, too.
std::string common_beginning(const Words& words) {
    const std::string declaration = exercises::declaration_of(words);
    const auto above = [&](const std::string& code) {
        return code.substr(0, code.find(declaration));
    };
    const std::string beginning = above(exercises::code_with(words, {}));
    for (const std::vector<int>& mistakes : exercises::mixtures_of(words))
        if (above(exercises::code_with(words, mistakes)) != beginning) return {};
    return beginning;
}

/// The variants of one exercise, in a namespace of its name, and the list of their answers there.
std::string variants_of(const Words& words, std::set<std::string>& includes) {
    const std::string beginning = common_beginning(words);
    const std::string harness = without_includes(words.harness, includes);
    std::ostringstream code;
    std::string list;
    code << "namespace " << words.name << " {\n";
    if (!beginning.empty()) code << without_includes(beginning, includes) << harness;
    int number = 0;
    for (const std::vector<int>& mistakes : exercises::mixtures_of(words)) {
        const std::string space = "variant_" + std::to_string(number++);
        const std::string variant = exercises::code_with(words, mistakes).substr(beginning.size());
        code << "namespace " << space << " {\n" << without_includes(variant, includes);
        if (beginning.empty()) code << harness;
        code << "Numbers answer(const Numbers& asked) {\n"
             << "    return wire::Call<" << exercises::signature_of(words) << ">::answer("
             << words.name << ", {asked.data(), asked.data() + asked.size()});\n}\n}  // namespace "
             << space << "\n";
        list += "    " + space + "::answer,\n";
    }
    code << "constexpr Numbers (*answers[])(const Numbers&) = {\n"
         << list << "};\n}  // namespace " << words.name << "\n\n";
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
        spaces << variants_of(words, includes);
        declared << "Task make_" << words.name << "();\n";
        listed << "    {\"" << path << "\", " << literal(markdown) << ", make_" << words.name
               << ", " << words.name << "::answers},\n";
    }
    std::ostringstream file;
    file << "// Written by lodlab_embed_exercises; do not edit.\n";
    for (const std::string& include : includes) file << include << "\n";
    file << "#include \"lessons/exercises/embedded.hpp\"\n"
         << "#include \"lessons/exercises/wire.hpp\"\n\nnamespace exercises {\n\n"
         << declared.str() << "\nnamespace {\n\n"
         << spaces.str() << "}  // namespace\n\n"
         << "std::span<const Embedded> all_embedded() {\n    static const Embedded embedded[] = {\n"
         << listed.str() << "    };\n    return embedded;\n}\n\n"
         << "const std::string& wire_text() {\n    static const std::string text = "
         << literal(lessons::read(root + "/lessons/exercises/wire.hpp"))
         << ";\n    return text;\n}\n\n}  // namespace exercises\n";
    lessons::write(arguments.at(0), file.str());
}

}  // namespace

int main(int count, char** values) {
    return lessons::run_tool(count, values, embed);
}
