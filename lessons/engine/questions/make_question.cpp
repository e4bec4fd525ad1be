#include <algorithm>
#include <cmath>
#include <optional>

#include "lessons/embed/source.hpp"
#include "lessons/engine/filler.hpp"
#include "lessons/engine/questions/read_number.hpp"
#include "lessons/engine/sketch.hpp"

namespace lessons {
namespace {

/// Reads terms of numbers, joined by + − × / from left to right.
class Expression {
  public:
    Expression(std::string text, int line, Filler& filler)
        : text_(std::move(text)), line_(line), filler_(filler) {}

    double value() {
        double result = term();
        while (!rest().empty()) {
            const std::string sign = take_sign();
            const double next = term();
            if (sign == "+") result += next;
            if (sign == "-") result -= next;
            if (sign == "*") result *= next;
            if (sign == "/") result /= next;
        }
        return result;
    }

  private:
    [[nodiscard]] std::string rest() const { return trimmed(std::string_view(text_).substr(at_)); }
    [[noreturn]] void refuse() const {
        refuse_line(filler_.where(), line_,
                    "'" + rest() +
                        "' is no number; write 0.5, {{number: NAME}}, or such joined by + − × /");
    }

    void skip_blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    double term() {
        skip_blanks();
        if (text_.compare(at_, 2, "{{") == 0) {
            const Tag tag = find_tags(text_.substr(at_), filler_.where(), line_ - 1).front();
            at_ += tag.end;
            return filler_.use_number(tag.name, line_).value;
        }
        std::size_t end = at_;
        while (end < text_.size() && text_[end] != ' ') ++end;
        const TypedNumber number = read_number(text_.substr(at_, end - at_));
        if (number.values.empty()) refuse();
        at_ = end;
        return number.values.front();
    }

    std::string take_sign() {
        skip_blanks();
        for (const auto& [sign, plain] :
             {std::pair{"+", "+"}, {"−", "-"}, {"-", "-"}, {"×", "*"}, {"*", "*"}, {"/", "/"}})
            if (text_.compare(at_, std::string_view(sign).size(), sign) == 0) {
                at_ += std::string_view(sign).size();
                return plain;
            }
        refuse();
    }

    std::string text_;
    int line_;
    Filler& filler_;
    std::size_t at_ = 0;
};

/// Whether "A < B and C > D" holds; = means equal but for rounding.
bool holds(std::string condition, int line, Filler& filler) {
    constexpr std::string_view joint = " and ";
    if (const std::size_t cut = condition.rfind(joint); cut != std::string::npos)
        return holds(condition.substr(0, cut), line, filler) &
               holds(condition.substr(cut + joint.size()), line, filler);
    const std::size_t sign = condition.find_first_of("<>=");
    if (sign == std::string::npos)
        refuse_line(filler.where(), line,
                    "'" + condition + "' compares nothing; write (right if A < B), A > B or A = B");
    const double left = Expression(condition.substr(0, sign), line, filler).value();
    const double right = Expression(condition.substr(sign + 1), line, filler).value();
    constexpr double rounding = 1e-9;
    if (condition[sign] == '=')
        return std::abs(left - right) <= rounding * std::max(std::abs(left), std::abs(right));
    return condition[sign] == '<' ? left < right : left > right;
}

/// Makes a question of its lines.
class Maker {
  public:
    Maker(const QuestionScript& script, Filler& filler) : script_(script), filler_(filler) {}

    Question make() {
        question_.name = script_.name;
        question_.prose = filler_.fill(script_.prose);
        for (const QuestionLine& line : script_.lines) take(line);
        if (!question_.picks.empty())
            check_picks();
        else if (question_.choices.empty())
            check_number();
        else
            check_choices();
        return std::move(question_);
    }

  private:
    [[noreturn]] void refuse(int line, const std::string& why) const {
        refuse_line(filler_.where(), line, "question '" + script_.name + "' " + why);
    }

    void take(const QuestionLine& line) {
        if (line.key == "answer") take_answer(line.said);
        if (line.key == "within") within_ = line.said;
        if (line.key == "pick") take_picks(line.said);
        if (line.key == "choice") take_choice(line.said);
        if (line.key == "mistake") take_mistake(line.said);
        if (line.key != "reply") return;
        if (!reply_to_) refuse(line.said.line, "has a reply to nothing; write it below its answer");
        *reply_to_ = filler_.fill(line.said);
    }

    void take_answer(const KeyText& said) {
        if (answer_) refuse(said.line, "has two answers");
        const std::vector<Tag> tags = find_tags(said.text, filler_.where(), said.line - 1);
        if (tags.size() != 1 || tags[0].begin != 0 || tags[0].end != said.text.size())
            refuse(said.line, "takes its answer from the code: write answer: {{number: NAME}}");
        answer_ = &filler_.use_number(tags[0].name, said.line);
        answer_line_ = said.line;
        question_.answer = filler_.number(tags[0].name, tags[0].format, said.line);
        question_.value = answer_->value;
        question_.unit = answer_->unit;
        reply_to_ = &question_.reply;
    }

    void take_picks(const KeyText& said) {
        if (!question_.picks.empty()) refuse(said.line, "has two answers");
        question_.picks = filler_.use_picks(said.text, said.line);
        question_.answer = names_of(question_.picks, true);
        reply_to_ = &question_.reply;
    }

    void take_choice(KeyText said) {
        Choice choice;
        constexpr std::string_view mark = "(right";
        const std::size_t open = said.text.rfind(mark);
        if (open != std::string::npos && said.text.ends_with(")")) {
            const std::string inside =
                said.text.substr(open + mark.size(), said.text.size() - 1 - open - mark.size());
            choice.right = inside.empty();
            if (inside.starts_with(" if "))
                choice.right = holds(inside.substr(4), said.line, filler_);
            said.text = trimmed(said.text.substr(0, open));
        }
        choice.text = filler_.fill(said);
        if (choice.text.empty()) refuse(said.line, "has a choice without words");
        question_.choices.push_back(choice);
        reply_to_ = &question_.choices.back().reply;
    }

    void take_mistake(const KeyText& said) {
        Mistake mistake;
        if (said.text == "above")
            mistake.kind = Mistake::Kind::above;
        else if (said.text == "below")
            mistake.kind = Mistake::Kind::below;
        else if (!question_.picks.empty())
            take_picks_mistake(mistake, said.text);
        else
            mistake.value = Expression(said.text, said.line, filler_).value();
        question_.mistakes.push_back(mistake);
        mistake_lines_.push_back(said.line);
        reply_to_ = &question_.mistakes.back().reply;
    }

    static void take_picks_mistake(Mistake& mistake, const std::string& said) {
        mistake.kind = said == "missing" ? Mistake::Kind::missing
                       : said == "more"  ? Mistake::Kind::more
                                         : Mistake::Kind::kind;
        mistake.picked = said;
    }

    void check_picks() {
        const auto is_right = [](const Pick& pick) { return pick.right; };
        const Picks& picks = question_.picks;
        if (answer_ || !question_.choices.empty()) refuse(script_.line, "has two answers");
        if (std::none_of(picks.begin(), picks.end(), is_right) ||
            std::all_of(picks.begin(), picks.end(), is_right))
            refuse(script_.line,
                   "has nothing to tell apart: all that may be picked is right, or none");
        if (question_.mistakes.empty())
            refuse(script_.line, "foresees no mistake; write mistake: missing, more or a kind");
        for (std::size_t i = 0; i < question_.mistakes.size(); ++i) {
            const Mistake& mistake = question_.mistakes[i];
            const int line = mistake_lines_[i];
            if (mistake.reply.empty())
                refuse(line, "has a mistake without a reply; write it below");
            if (mistake.kind == Mistake::Kind::above || mistake.kind == Mistake::Kind::below)
                refuse(line, "is no number; write missing, more or a kind");
            if (mistake.kind != Mistake::Kind::kind) continue;
            if (std::none_of(picks.begin(), picks.end(), [&](const Pick& pick) {
                    return !pick.right && pick.kind == mistake.picked;
                }))
                refuse(line, "has no wrong pick of the kind '" + mistake.picked + "'");
        }
    }

    void check_choices() {
        if (!question_.mistakes.empty())
            refuse(mistake_lines_[0], "has choices: write the reply below the wrong one");
        int right = 0;
        int foreseen = 0;
        for (Choice& choice : question_.choices) {
            if (answer_) choice.right = choice.text == answer_->text;
            right += choice.right ? 1 : 0;
            foreseen += !choice.right && !choice.reply.empty() ? 1 : 0;
            if (choice.right) question_.answer = choice.text;
        }
        if (right == 0)
            refuse(script_.line, answer_ ? "has no choice '" + answer_->text + "', its answer"
                                         : "has no right choice; end one with (right)");
        if (right > 1) refuse(script_.line, "has two right choices; leave one");
        if (foreseen == 0)
            refuse(script_.line, "foresees no mistake; write reply: ... below a wrong choice");
    }

    void check_number() {
        if (!answer_)
            refuse(script_.line,
                   "has no answer; write answer: {{number: NAME}}, or lines "
                   "choice: ..., one of them ending with (right)");
        if (!answer_->is_counted) refuse(answer_line_, "has words for its answer; give it choices");
        question_.tolerance = tolerance();
        if (question_.mistakes.empty())
            refuse(script_.line, "foresees no mistake; write mistake: ... and reply: ...");
        for (std::size_t i = 0; i < question_.mistakes.size(); ++i) check_mistake(i);
    }

    void check_mistake(std::size_t i) const {
        const Mistake& mistake = question_.mistakes[i];
        const int line = mistake_lines_[i];
        if (mistake.reply.empty()) refuse(line, "has a mistake without a reply; write it below");
        if (mistake.kind != Mistake::Kind::value) return;
        if (!std::isfinite(mistake.value)) refuse(line, "has a mistake that is no number");
        const double slack = 1.001 * question_.tolerance + 1e-9 * std::abs(question_.value);
        if (std::abs(mistake.value - question_.value) <= slack)
            refuse(line,
                   "has a mistake that is the answer, " + question_.answer + "; take it away");
        for (std::size_t k = 0; k < i; ++k)
            if (question_.mistakes[k].kind == Mistake::Kind::value &&
                std::abs(mistake.value - question_.mistakes[k].value) <= slack)
                refuse(line, "foresees this mistake already, in line " +
                                 std::to_string(mistake_lines_[k]) + "; join them");
    }

    /// What a rounded answer allows, or what the lesson does.
    [[nodiscard]] double tolerance() const {
        const std::string shown = question_.answer.substr(
            0, question_.answer.size() - with_unit("", question_.unit).size());
        const std::size_t point = shown.find('.');
        const double rounding =
            point == std::string::npos && question_.value == std::round(question_.value)
                ? 0
                : 0.5 * std::pow(10.0, point == std::string::npos
                                           ? 0.0
                                           : -static_cast<double>(shown.size() - point - 1));
        if (within_.text.empty()) return rounding;
        const TypedNumber within = read_number(within_.text);
        if (within.values.empty() || within.values[0] < 0)
            refuse(within_.line, "is graded within no number; write within: 0.01, or 2 %");
        const double size = within.values[0];
        return std::max(rounding, within.unit == "%" && question_.unit != "%"
                                      ? size / 100 * std::abs(question_.value)
                                      : size);
    }

    const QuestionScript& script_;
    Filler& filler_;
    Question question_;
    const Number* answer_ = nullptr;
    int answer_line_ = 0;
    KeyText within_;
    std::vector<int> mistake_lines_;
    std::string* reply_to_ = nullptr;
};

}  // namespace

Question make_question(const QuestionScript& script, Filler& filler) {
    return Maker(script, filler).make();
}

}  // namespace lessons
