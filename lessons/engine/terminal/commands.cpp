#include "lessons/engine/terminal/commands.hpp"

#include <istream>
#include <ostream>

#include "lessons/engine/questions/answer_mode.hpp"
#include "lessons/engine/terminal/viewer.hpp"

namespace lessons {

const std::string_view help_text =
    "Enter, n, space, right  next step\n"
    "b, p, left              one step back\n"
    "5 or g5                 go to step 5\n"
    "t                       the text of the lesson\n"
    "?                       this help\n"
    "q                       quit\n";

const std::string_view answer_help =
    "A number may have a decimal comma or point, and a unit or none; a choice is a letter.\n"
    ":p   pass this question     :b   one step back     :5   go to step 5\n"
    ":t   the lesson's text      :h   this help         :q   quit\n";

namespace {

/// A whole line of input, as a pipe or a terminal in line mode gives it.
Command parse_line(std::string line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
    while (!line.empty() && line.front() == ' ') line.erase(0, 1);
    using Kind = Command::Kind;
    if (line.empty() || line == "n" || line == "next" || line == "right" || line == "\033[C")
        return {Kind::next, 0, {}};
    if (line == "b" || line == "p" || line == "back" || line == "left" || line == "\033[D")
        return {Kind::back, 0, {}};
    if (line == "t") return {Kind::text, 0, {}};
    if (line == "?" || line == "h" || line == "help") return {Kind::help, 0, {}};
    if (line == "q" || line == "quit") return {Kind::quit, 0, {}};
    std::string digits = line.starts_with("g") ? line.substr(1) : line;
    while (!digits.empty() && digits.front() == ' ') digits.erase(0, 1);
    constexpr std::size_t most_digits = 6;
    if (!digits.empty() && digits.size() <= most_digits &&
        digits.find_first_not_of("0123456789") == std::string::npos)
        return {Kind::go, std::stoi(digits), {}};
    return {Kind::unknown, 0, line};
}

/// A line typed to a question: an answer, or a command after a colon.
Command parse_answer(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos || line[first] != ':') return {Command::Kind::answer, 0, line};
    const std::string word = line.substr(first + 1);
    if (word == "p" || word == "p\r" || word == "pass") return {Command::Kind::pass, 0, {}};
    if (word.empty() || word == "\r") return {Command::Kind::help, 0, {}};
    return parse_line(word);
}

/// Single keys of a terminal; digits are gathered until Enter.
Command read_command_from_keys(int terminal, std::ostream& output) {
    std::string digits;
    for (;;) {
        const int key = read_key(terminal);
        if (key < 0 || key == 4) return {Command::Kind::quit, 0, {}};  // 4: Ctrl-D
        const char letter = static_cast<char>(key);
        if ((letter >= '0' && letter <= '9') || (letter == 'g' && digits.empty())) {
            digits += letter;
            output << letter << std::flush;
        } else if (key == 127 && !digits.empty()) {
            digits.pop_back();
            output << "\b \b" << std::flush;
        } else if (letter == '\n' || letter == '\r') {
            return parse_line(digits);
        } else if (letter == ' ') {
            return {Command::Kind::next, 0, {}};
        } else if (key == 27) {
            std::string sequence(1, letter);
            while (sequence.size() < 3 && key_waiting(terminal))
                sequence += static_cast<char>(read_key(terminal));
            if (sequence[1 % sequence.size()] == 'O' && sequence.size() == 3) sequence[1] = '[';
            return parse_line(sequence);
        } else {
            return parse_line(std::string(1, letter));
        }
    }
}

}  // namespace

std::optional<Command> read_command(bool is_asking, std::istream& input, std::ostream& output,
                                    int keyboard) {
    if (keyboard >= 0 && !is_asking) return read_command_from_keys(keyboard, output);
    std::optional<std::string> line;
    if (keyboard >= 0)
        line = read_line_from_keys(keyboard, output);
    else if (std::string typed; std::getline(input, typed))
        line = typed;
    if (!line) return {};
    if (is_asking) return parse_answer(*line);
    const bool has_colon = line->starts_with(":") && *line != ":p";  // as in answer to a question
    return parse_line(has_colon ? line->substr(1) : *line);
}

}  // namespace lessons
