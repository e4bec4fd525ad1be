#include "lessons/embed/question.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "lessons/embed/lines.hpp"

namespace lessons {
namespace {

constexpr std::array<std::string_view, 7> keys{"answer",  "within", "choice", "pick",
                                               "mistake", "reply",  "told in"};

}  // namespace

std::string_view key_of(std::string_view line) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos || colon == 0) return {};
    for (const char c : line.substr(0, colon))
        if (!std::islower(static_cast<unsigned char>(c)) && c != ' ') return {};
    return line.substr(0, colon);
}

void take_line(QuestionScript& question, const std::string& line, const std::string& where,
               int number) {
    const std::string_view key = key_of(line);
    if (!key.empty()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            refuse_line(where, number,
                        "a question has no '" + std::string(key) +
                            "'; it has answer, within, choice, pick, mistake, reply and told in");
        question.lines.push_back(
            {std::string(key), {trimmed(std::string_view(line).substr(key.size() + 2)), number}});
        return;
    }
    KeyText& text = question.lines.empty() ? question.prose : question.lines.back().said;
    if (text.line == 0) text.line = number;
    text.text += (text.text.empty() ? "" : " ") + line;
}

}  // namespace lessons
