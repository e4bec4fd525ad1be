#include "lessons/engine/plain.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "lessons/embed/source.hpp"

namespace lessons {
namespace {

/// The end of the group that opens at `open` with '{'.
std::size_t group_end(const std::string& latex, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < latex.size(); ++i) {
        if (latex[i] == '{') ++depth;
        if (latex[i] == '}' && --depth == 0) return i;
    }
    return latex.size();
}

/// An equation as one line of plain characters: "j = −((1 + e) v_c) / (K)".
std::string plain_equation(std::string latex) {
    constexpr std::string_view fraction = "\\frac{";
    for (std::size_t at = latex.find(fraction); at != std::string::npos;
         at = latex.find(fraction)) {
        const std::size_t top = at + fraction.size() - 1;
        const std::size_t top_end = group_end(latex, top);
        const std::size_t bottom_end = group_end(latex, top_end + 1);
        if (bottom_end >= latex.size()) break;
        const auto part = [&](std::size_t open, std::size_t end) {
            const std::string text = latex.substr(open + 1, end - open - 1);
            const bool single = text.find_first_of(" +-") == std::string::npos;
            return single ? text : "(" + text + ")";
        };
        latex.replace(at, bottom_end + 1 - at,
                      part(top, top_end) + " / " + part(top_end + 1, bottom_end));
    }
    constexpr std::pair<std::string_view, std::string_view> words[] = {
        {"\\left", ""},   {"\\right", ""},  {"\\qquad", "  "}, {"\\cdot", "·"},
        {"\\times", "×"}, {"\\omega", "ω"}, {"\\le", "≤"},     {"\\,", " "},
        {"^2", "²"},      {"{", ""},        {"}", ""},         {"-", "−"}};
    for (const auto& [word, sign] : words)
        for (std::size_t at = latex.find(word); at != std::string::npos; at = latex.find(word, at))
            latex.replace(at, word.size(), sign);
    return latex;
}

/// Every $...$ of a text in plain characters; those between $$ on a line of their own.
std::string with_plain_equations(const std::string& markdown) {
    std::string text;
    for (std::size_t done = 0; done < markdown.size();) {
        const std::size_t open = markdown.find('$', done);
        text += markdown.substr(done, open - done);
        if (open == std::string::npos) break;
        const std::string fence = markdown.compare(open, 2, "$$") == 0 ? "$$" : "$";
        const std::size_t inside = open + fence.size();
        const std::size_t close = markdown.find(fence, inside);
        if (close == std::string::npos) return text + markdown.substr(open);
        text += (fence.size() == 2 ? "    " : "") +
                plain_equation(markdown.substr(inside, close - inside));
        done = close + fence.size();
    }
    return text;
}

/// Characters, not bytes: UTF-8 continuation bytes do not count.
int width_of(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// A word without the marks of emphasis and code.
std::string without_marks(std::string word) {
    for (const std::string mark : {"**", "`"})
        for (std::size_t at = word.find(mark); at != std::string::npos; at = word.find(mark))
            word.erase(at, mark.size());
    if (word != "*") std::erase(word, '*');
    return word;
}

class Wrapper {
  public:
    Wrapper(int columns, bool styled, std::string_view indent)
        : columns_(std::max(columns, 20)), styled_(styled), indent_(indent) {}

    void add_word(const std::string& word) {
        const std::string shown = without_marks(word);
        const int width = width_of(shown);
        if (column_ > 0 && column_ + 1 + width > columns_) end_line();
        if (column_ == 0) {
            text_ += indent_ + hanging_;
            column_ = width_of(indent_ + hanging_);
        } else {
            text_ += ' ';
            ++column_;
        }
        const std::size_t marks = count_of(word, "**");
        const bool begins_bold = word.starts_with("**");
        if (styled_ && marks > 0 && begins_bold) text_ += "\033[1m";
        text_ += shown;
        if (styled_ && marks > 0 && (!begins_bold || marks > 1)) text_ += "\033[0m";
        column_ += width;
    }

    void end_line() {
        if (column_ == 0) return;
        text_ += '\n';
        column_ = 0;
    }

    void blank_line() {
        end_line();
        hanging_.clear();
        if (!text_.ends_with("\n\n") && !text_.empty()) text_ += '\n';
    }

    void begin_item() {
        end_line();
        hanging_.clear();
        add_word("-");
        hanging_ = "  ";
    }

    void verbatim(const std::string& line) {
        end_line();
        text_ += indent_ + line + "\n";
    }

    std::string take() {
        end_line();
        return std::move(text_);
    }

  private:
    static std::size_t count_of(const std::string& word, const std::string& mark) {
        std::size_t count = 0;
        for (std::size_t at = word.find(mark); at != std::string::npos;
             at = word.find(mark, at + mark.size()))
            ++count;
        return count;
    }

    int columns_;
    bool styled_;
    std::string indent_;
    std::string hanging_;
    std::string text_;
    int column_ = 0;
};

}  // namespace

std::string wrapped(std::string_view markdown, int columns, bool styled, std::string_view indent) {
    Wrapper wrapper(columns, styled, indent);
    std::istringstream lines{std::string(markdown)};
    for (std::string line; std::getline(lines, line);) {
        const bool is_table = line.starts_with("|");
        if (line.find_first_not_of(' ') == std::string::npos) {
            wrapper.blank_line();
            continue;
        }
        if (line.starts_with("    ") || line.starts_with("#") || is_table) {
            wrapper.verbatim(line);
            continue;
        }
        if (line.starts_with("> ")) line.erase(0, 2);
        std::istringstream words(line);
        bool first = true;
        for (std::string word; words >> word; first = false) {
            if (first && word == "-")
                wrapper.begin_item();
            else
                wrapper.add_word(word);
        }
    }
    return wrapper.take();
}

std::string live_line(const Lesson& lesson) {
    return "[To play with this scene in a page: `lodlab page lesson:" + lesson.entry.slug +
           " --out " + lesson.entry.slug + ".html`]";
}

std::string text_for_terminal(const Lesson& lesson, std::string_view markdown, int columns,
                              bool styled) {
    const std::string whole(markdown);
    std::string text;
    std::size_t done = 0;
    for (const Tag& tag : find_tags(markdown, lesson.script.where)) {
        text += with_plain_equations(whole.substr(done, tag.begin - done));
        done = tag.end;
        if (tag.kind == "figure") text += "[Figure: " + lesson.figures.at(tag.name).alt + "]";
        if (tag.kind == "steps") text += "[Here come the steps.]";
        if (tag.kind == "live") text += live_line(lesson);
        if (tag.kind == "video") text += "[Here the book shows a video.]";
        if (tag.kind == "listing") {
            std::istringstream lines(lesson.listings.at(tag.name));
            for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
        }
    }
    text += with_plain_equations(whole.substr(done));
    return wrapped(text, columns, styled);
}

}  // namespace lessons
