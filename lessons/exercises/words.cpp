#include "lessons/exercises/words.hpp"

#include <algorithm>

#include "lessons/embed/lines.hpp"

namespace exercises {
namespace {

/// The text of an exercise, section by section.
class WordsReader {
  public:
    WordsReader(const std::string& path, std::string_view markdown)
        : where_("lessons/exercises/tasks/" + path + ".md"), lines_(lessons::lines_of(markdown)) {
        words_.name = path.substr(path.rfind('/') + 1);
    }

    Words read() {
        for (; line_ < lines_.size(); ++line_) read_line(lines_[line_]);
        words_.task = lessons::trimmed(words_.task);
        check();
        return words_;
    }

  private:
    [[noreturn]] void refuse(const std::string& why) const {
        lessons::refuse_line(where_, static_cast<int>(std::min(line_ + 1, lines_.size())), why);
    }

    void read_line(const std::string& line) {
        if (line.starts_with("```")) {
            in_fence_ = !in_fence_;
        } else if (in_fence_) {
            section_ == "Harness" ? void(words_.harness += line + "\n") : read_code(line);
        } else if (line.starts_with("## ")) {
            section_ = line.substr(3);
        } else if (section_.empty()) {
            read_head(line);
        } else if (section_ == "Hints" || section_ == "Mistakes") {
            read_item(line);
        } else if (!lessons::trimmed(line).empty()) {
            refuse("no text belongs into the section " + section_);
        }
    }

    void read_head(const std::string& line) {
        const auto value = [&](std::string_view key, std::string& into) {
            if (!line.starts_with(key)) return false;
            into = lessons::trimmed(line.substr(key.size()));
            return true;
        };
        if (!value("# ", words_.title) && !value("lesson:", words_.lesson) &&
            !value("case:", words_.told_case) && !value("answer:", words_.told_answer))
            words_.task += line + "\n";
    }

    void read_item(const std::string& line) {
        const bool hints = section_ == "Hints";
        if (line.starts_with("- ")) {
            const std::size_t colon = line.find(": ");
            if (hints) {
                words_.hints.push_back(line.substr(2));
            } else if (colon == std::string::npos) {
                refuse("a mistake is NAME: reply");
            } else {
                words_.mistakes.push_back({line.substr(2, colon - 2), line.substr(colon + 2)});
            }
        } else if (!lessons::trimmed(line).empty()) {
            if (hints ? words_.hints.empty() : words_.mistakes.empty())
                refuse("a list begins by -");
            (hints ? words_.hints.back() : words_.mistakes.back().reply) +=
                " " + lessons::trimmed(line);
        }
    }

    void read_code(const std::string& line) {
        if (line.starts_with("//[")) {
            gap_ = true;
            words_.in_starter.push_back(line.substr(3));
        } else if (line.starts_with("//]")) {
            gap_ = false;
        } else if (line.starts_with("//!")) {
            const std::size_t bar = line.find('|');
            if (bar == std::string::npos || words_.code.empty()) refuse("write //! NAME| text");
            auto& mistakes = words_.code.back().mistakes;
            const std::string name = lessons::trimmed(line.substr(3, bar - 3));
            const std::string text = line.substr(bar + 1);
            if (!mistakes.empty() && mistakes.back().first == name)
                mistakes.back().second += "\n" + text;
            else
                mistakes.emplace_back(name, text);
        } else {
            words_.code.push_back({line, gap_, {}});
        }
    }

    void check() const {
        if (words_.title.empty() || words_.lesson.empty() || words_.task.empty() ||
            words_.told_case.empty() || words_.told_answer.empty())
            refuse("it needs a title, lesson:, case:, answer: and a task");
        if (words_.in_starter.empty() || words_.hints.empty()) refuse("it needs a gap and a hint");
        if (signature_of(words_).empty()) refuse("no function " + words_.name + " in its code");
        std::set<std::string> in_code;
        for (const CodeLine& line : words_.code)
            for (const auto& [name, text] : line.mistakes)
                if (!in_code.insert(name).second) refuse("the mistake " + name + " stands twice");
        for (const Mistake& mistake : words_.mistakes)
            if (in_code.erase(mistake.name) == 0)
                refuse("no line of the code has the mistake " + mistake.name);
        if (!in_code.empty()) refuse("no reply names the mistake " + *in_code.begin());
    }

    std::string where_;
    std::vector<std::string> lines_;
    std::size_t line_ = 0;
    std::string section_;
    bool in_fence_ = false;
    bool gap_ = false;
    Words words_;
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Which line a mistake replaces.
std::size_t line_of_mistake(const Words& words, int mistake) {
    const std::string& name = words.mistakes[static_cast<std::size_t>(mistake)].name;
    for (std::size_t line = 0; line < words.code.size(); ++line)
        for (const auto& [wrong, text] : words.code[line].mistakes)
            if (wrong == name) return line;
    return words.code.size();
}

/// Where the function's declaration begins and ends in the solution.
std::pair<std::size_t, std::size_t> declaration_in(const Words& words, const std::string& code) {
    const std::string call = " " + words.name + "(";
    for (std::size_t at = code.find(call); at != std::string::npos; at = code.find(call, at + 1)) {
        const std::size_t brace = code.find(" {", at);
        const std::size_t line = code.rfind('\n', at) + 1;
        if (brace == std::string::npos || code[line] == ' ' || code[line] == '/') continue;
        return {line, brace};
    }
    return {0, 0};
}

}  // namespace

Words read_words(const std::string& path, std::string_view markdown) {
    return WordsReader(path, markdown).read();
}

std::string code_with(const Words& words, const std::vector<int>& mistakes) {
    std::vector<std::string> lines;
    for (const CodeLine& line : words.code) {
        lines.push_back(line.text);
        for (const int mistake : mistakes)
            for (const auto& [name, text] : line.mistakes)
                if (name == words.mistakes[static_cast<std::size_t>(mistake)].name)
                    lines.back() = text;
    }
    return joined(lines);
}

std::string starter_code(const Words& words) {
    std::vector<std::string> lines;
    bool open = false;
    for (const CodeLine& line : words.code) {
        if (line.in_gap && !open)
            lines.insert(lines.end(), words.in_starter.begin(), words.in_starter.end());
        if (!line.in_gap) lines.push_back(line.text);
        open = line.in_gap;
    }
    return joined(lines);
}

std::string declaration_of(const Words& words) {
    const std::string code = code_with(words, {});
    const auto [begin, end] = declaration_in(words, code);
    return code.substr(begin, end - begin);
}

std::string signature_of(const Words& words) {
    std::string declaration = declaration_of(words);
    const std::size_t name = declaration.find(" " + words.name + "(");
    if (name == std::string::npos) return {};
    return declaration.erase(name, words.name.size() + 1);
}

std::vector<std::vector<int>> mixtures_of(const Words& words) {
    const int count = static_cast<int>(words.mistakes.size());
    std::vector<std::vector<int>> mixtures{{}};
    for (int one = 0; one < count; ++one) mixtures.push_back({one});
    for (int one = 0; one < count; ++one)
        for (int other = one + 1; other < count; ++other)
            if (line_of_mistake(words, one) != line_of_mistake(words, other))
                mixtures.push_back({one, other});
    return mixtures;
}

}  // namespace exercises
