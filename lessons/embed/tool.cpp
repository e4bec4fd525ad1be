#include "lessons/embed/tool.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "lodlab/core/base/error.hpp"

namespace lessons {

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) lod::refuse_input(path, "cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) lod::refuse_input(path, "cannot be written");
}

std::string literal(const std::string& text) {
    constexpr std::size_t most = 8000;
    std::ostringstream code;
    code << "std::string(";
    for (std::size_t begin = 0; begin < text.size() || begin == 0; begin += most)
        code << "R\"lodlab(" << text.substr(begin, most) << ")lodlab\"\n";
    code << ", " << text.size() << ")";
    return code.str();
}

int run_tool(int count, char** values, void (*work)(const std::vector<std::string>& arguments)) {
    try {
        work({values + 1, values + count});
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << "\n";
        return 1;
    }
}

}  // namespace lessons
