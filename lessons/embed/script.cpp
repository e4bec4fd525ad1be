#include "lessons/embed/script.hpp"

#include "lessons/embed/lines.hpp"
#include "lessons/embed/source.hpp"

namespace lessons {
namespace {

constexpr std::string_view step_heading = "### Step:";

/// Takes a text apart, line by line.
class Reader {
  public:
    explicit Reader(const std::string& where) : where_(where) { script_.where = where; }

    void take(const std::string& line) {
        ++number_;
        const std::string text = trimmed(line);
        if (text.starts_with(step_heading))
            begin_step(trimmed(std::string_view(text).substr(step_heading.size())));
        else if (text.starts_with("#"))
            end_steps(line);
        else if (text.empty())
            end_words();
        else if (text.starts_with("{{") && text.find("}}") == text.size() - 2)
            take_tag(line, find_tags(line, where_, number_ - 1).front());
        else if (question_)
            take_question_line(text);
        else if (words_)
            take_word(text);
        else
            keep(line);
    }

    Script take_script() {
        check_last_step();
        check_tags();
        return std::move(script_);
    }

  private:
    [[noreturn]] void refuse(const std::string& why) const { refuse_line(where_, number_, why); }
    [[nodiscard]] bool in_step() const { return !script_.steps.empty() && !ended_; }

    void keep(const std::string& line) {
        script_.text += (in_step() ? "" : line) + "\n";
        if (in_step()) script_.steps.back().text += line + "\n";
    }

    void end_words() {
        words_ = nullptr;
        question_ = nullptr;
        keep("");
    }

    void begin_step(const std::string& title) {
        if (ended_) refuse("the steps stand one after another; this one comes after a heading");
        if (title.empty()) refuse("a step needs a title");
        check_last_step();
        script_.text += script_.steps.empty() ? "{{steps}}\n" : "\n";
        script_.steps.push_back({title, {}, {}, 0, {}, {}, number_});
        words_ = nullptr;
        question_ = nullptr;
    }

    void end_steps(const std::string& heading) {
        ended_ = !script_.steps.empty();
        words_ = nullptr;
        question_ = nullptr;
        keep(heading);
    }

    void check_last_step() const {
        if (script_.steps.empty()) return;
        const StepScript& step = script_.steps.back();
        const std::string name = "step '" + step.title + "' has no ";
        if (trimmed(step.text).empty()) refuse_line(where_, step.line, name + "text");
        if (step.figure.empty())
            refuse_line(where_, step.line, name + "figure; add a line {{figure: NAME}}");
        for (const QuestionScript& question : step.questions)
            if (question.prose.text.empty())
                refuse_line(where_, question.line,
                            "question '" + question.name +
                                "' asks nothing; write its prose below the tag, then its answer");
    }

    /// A tag on a line of its own.
    void take_tag(const std::string& line, const Tag& tag) {
        words_ = nullptr;
        question_ = nullptr;
        if (tag.kind == "ask") return take_question(tag);
        if (tag.kind == "steps") refuse("steps are sections '### Step: TITLE', not a tag");
        if (tag.kind == "shown") return take_shown(tag);
        if (tag.kind == "video" && in_step()) refuse("a video stands outside the steps");
        if (tag.kind == "video") words_ = &script_.video;
        if (tag.kind == "live") take_live();
        if (tag.kind == "figure") {
            words_ = &script_.words[tag.name];
            script_.figures.emplace(tag.name, number_);
        }
        if (tag.kind != "figure" || !in_step()) return keep(line);
        StepScript& step = script_.steps.back();
        if (!step.figure.empty()) refuse("the step has a figure already, '" + step.figure + "'");
        step.figure = tag.name;
        step.figure_line = number_;
        keep("");
    }

    /// Stands between the steps and the text after them, or in that text.
    void take_live() {
        if (script_.live_line > 0)
            refuse("the lesson has a live part already, in line " +
                   std::to_string(script_.live_line));
        ended_ = !script_.steps.empty();
        words_ = &script_.live;
        script_.live_line = number_;
    }

    void take_shown(const Tag& tag) {
        if (!in_step()) refuse("only a step shows numbers in a list; use {{number: NAME}}");
        script_.steps.back().shown.push_back({tag.told, tag.name, tag.format, number_});
        keep("");
    }

    void take_question(const Tag& tag) {
        if (!in_step()) refuse("a question stands in a step, which it keeps the reader in");
        for (const StepScript& step : script_.steps)
            for (const QuestionScript& other : step.questions)
                if (other.name == tag.name)
                    refuse("question '" + tag.name + "' is asked already, in line " +
                           std::to_string(other.line));
        script_.steps.back().questions.push_back({tag.name, number_, {}, {}});
        question_ = &script_.steps.back().questions.back();
        keep("");
    }

    void take_question_line(const std::string& text) {
        take_line(*question_, text, where_, number_);
        keep("");
    }

    void take_word(const std::string& text) {
        const std::string key(key_of(text));
        if (!key.empty()) {
            const auto [place, is_new] =
                words_->emplace(key, KeyText{trimmed(text.substr(key.size() + 2)), number_});
            if (!is_new)
                refuse("'" + key + "' is said twice, here and in line " +
                       std::to_string(place->second.line));
            word_ = &place->second;
        } else if (words_->empty() || !word_) {
            refuse("below such a tag stand lines 'title: ...'; begin a text with a blank line");
        } else {
            word_->text += " " + text;
        }
        keep("");
    }

    /// Whether a tag stands within a sentence.
    [[nodiscard]] static bool is_in_sentence(const Tag& tag) {
        return tag.kind == "number" || tag.kind == "lesson";
    }

    /// Words below a tag, which hold words alone.
    void check_words(const KeyText& said) const {
        for (const Tag& tag : find_tags(said.text, where_, said.line - 1))
            if (!is_in_sentence(tag))
                refuse_line(where_, said.line, "a " + tag.kind + " stands on a line of its own");
    }

    void check_tags() const {
        for (const Tag& tag : find_tags(script_.text, where_))
            if (tag.kind == "shown")
                refuse_line(where_, line_of(script_.text, tag.begin),
                            "a shown number stands on a line of its own, in a step");
        for (const StepScript& step : script_.steps)
            for (const Tag& tag : find_tags(step.text, where_, step.line))
                if (!is_in_sentence(tag) && tag.kind != "listing")
                    refuse_line(where_, step.line + line_of(step.text, tag.begin),
                                std::string("a ") + (tag.kind == "ask" ? "question" : tag.kind) +
                                    " stands on a line of its own");
        for (const auto& [figure, words] : script_.words)
            for (const auto& [key, said] : words) (void)find_tags(said.text, where_, said.line - 1);
        for (const StepScript& step : script_.steps)
            for (const QuestionScript& question : step.questions) {
                check_words(question.prose);
                for (const QuestionLine& line : question.lines) check_words(line.said);
            }
    }

    std::string where_;
    Script script_;
    int number_ = 0;
    bool ended_ = false;                  ///< a heading came after the steps
    Words* words_ = nullptr;              ///< to which the next lines belong
    KeyText* word_ = nullptr;             ///< that goes on where a line has no key
    QuestionScript* question_ = nullptr;  ///< to which the next lines belong
};

}  // namespace

Script read_script(std::string_view markdown, const std::string& where) {
    Reader reader(where);
    for (const std::string& line : lines_of(markdown)) reader.take(line);
    return reader.take_script();
}

}  // namespace lessons
