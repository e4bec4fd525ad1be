#include "lessons/plain.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "lessons/source.hpp"

namespace lessons {
namespace {

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
    const bool emphasis = word.find('*') != word.rfind('*');
    if (emphasis) std::erase(word, '*');
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

std::string text_for_terminal(const Lesson& lesson, int columns, bool styled) {
    std::string text;
    std::size_t done = 0;
    for (const Tag& tag : find_tags(lesson.markdown, lesson.entry.slug)) {
        text += lesson.markdown.substr(done, tag.begin - done);
        done = tag.end;
        if (tag.kind == "number") text += lesson.numbers.at(tag.name).text;
        if (tag.kind == "figure") text += "[Figure: " + lesson.figures.at(tag.name).alt + "]";
        if (tag.kind == "steps") text += "[Here come the steps.]";
        if (tag.kind == "video") text += "[Here the book shows a video.]";
        if (tag.kind == "listing") {
            std::istringstream lines(lesson.listings.at(tag.name));
            for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
        }
    }
    text += lesson.markdown.substr(done);
    return wrapped(text, columns, styled);
}

}  // namespace lessons
