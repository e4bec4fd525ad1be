#include "cli/exit_code.hpp"

#include <map>
#include <regex>
#include <sstream>

#include "lodlab/io/files/read_file.hpp"
#include "tests/catch.hpp"

namespace {

/// The rows of the manual's table: a code and what it means, up to a colon or semicolon.
std::map<std::string, std::string> documented_codes() {
    const std::string manual = lod::read_text_file(LODLAB_SOURCE_DIR "/cli/README.md", 1 << 20);
    std::istringstream lines(manual.substr(manual.find("| exit code |")));
    std::map<std::string, std::string> rows;
    const std::regex row(R"(\| ([0-9]+) \| ([^|:;]*[^|:; ]).*)");
    std::smatch cells;
    for (std::string line; std::getline(lines, line) && !line.empty();)
        if (std::regex_match(line, cells, row)) rows[cells[1]] = cells[2];
    return rows;
}

}  // namespace

TEST_CASE("every kind of error has the exit code that the manual says, and no other has one",
          "[errors]") {
    using enum lod::ErrorKind;
    const auto code = [](lod::ErrorKind kind) { return std::to_string(cli::exit_code(kind)); };
    const std::map<std::string, std::string> made{
        {std::to_string(cli::done_code), "done"},
        {std::to_string(cli::internal_error_code), "an error of lodlab itself"},
        {code(usage), "usage"},
        {code(input_refused), "input refused"},
        {code(output_failed), "output failed"},
        {code(limit_exceeded), "limit exceeded"},
        {code(not_installed), "something is not installed"}};
    CHECK(made.size() == 7);
    CHECK(made == documented_codes());
    CHECK(std::pair{cli::exit_code(usage), cli::exit_code(not_installed)} == std::pair{2, 6});
    CHECK(cli::signal_code(2) == 130);
}
