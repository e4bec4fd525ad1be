#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "lessons/embed/lines.hpp"
#include "lessons/engine/questions/question.hpp"
#include "lessons/engine/questions/read_number.hpp"

namespace lessons {
namespace {

constexpr const char* not_that = "Not that. Try again, or pass.";

std::string lower(std::string_view text) {
    std::string small;
    for (const char c : text) small += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return small;
}

/// The choice that an answer names; as many as there are where it names none.
std::size_t chosen(const std::vector<Choice>& choices, const std::string& answer) {
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (lower(choices[i].text) == answer) return i;
    std::string name = answer;
    if (name.size() > 1 && (name.back() == ')' || name.back() == '.')) name.pop_back();
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (name == letter_of(i) || name == std::to_string(i + 1)) return i;
    return choices.size();
}

Graded grade_choice(const Question& question, const std::string& answer) {
    const std::size_t i = chosen(question.choices, lower(answer));
    if (i == question.choices.size())
        return {Grade::unclear,
                "Answer with a letter, a to " + letter_of(question.choices.size() - 1) + "."};
    const Choice& choice = question.choices[i];
    if (choice.right) return {Grade::right, choice.reply.empty() ? "Right." : choice.reply};
    return choice.reply.empty() ? Graded{Grade::wrong, not_that}
                                : Graded{Grade::foreseen, choice.reply};
}

/// Factor from the reader's unit to the question's, or the words that say why there is none.
struct Conversion {
    double factor = 1;
    std::string unclear;
};

Conversion conversion(const std::string& unit, const std::string& typed) {
    if (typed.empty()) return {};
    const UnitSize asked = size_of(plain_unit(unit));
    const UnitSize given = size_of(typed);
    if (!asked.measures.empty() && asked.measures == given.measures)
        return {given.size / asked.size, {}};
    const bool counts = unit.empty() || asked.measures.empty();  // "16 tests"
    if (counts && given.measures.empty()) return {};
    const std::string wanted =
        counts ? "The answer is a plain number." : "The answer is in " + unit + ".";
    return {1, "That unit does not fit. " + wanted};
}

bool is_near(double value, double wanted, double tolerance) {
    return std::abs(value - wanted) <= tolerance + 1e-9 * std::abs(wanted);
}

Graded grade_number(const Question& question, const std::string& answer) {
    const TypedNumber typed = read_number(answer);
    if (typed.values.empty())
        return {Grade::unclear,
                "That is no number. Write one as 12, 0.5 or 0,5" +
                    (question.unit.empty() ? std::string(".")
                                           : ", in " + question.unit + " or without.")};
    const Conversion to = conversion(question.unit, typed.unit);
    if (!to.unclear.empty()) return {Grade::unclear, to.unclear};
    for (const double value : typed.values)
        if (is_near(to.factor * value, question.value, question.tolerance))
            return {Grade::right, question.reply.empty() ? "Right." : question.reply};
    for (const Mistake& mistake : question.mistakes)
        for (const double value : typed.values)
            if (mistake.kind == Mistake::Kind::value &&
                is_near(to.factor * value, mistake.value, question.tolerance))
                return {Grade::foreseen, mistake.reply};
    const double likeliest = to.factor * typed.values.front();
    for (const Mistake& mistake : question.mistakes)
        if ((mistake.kind == Mistake::Kind::above && likeliest > question.value) ||
            (mistake.kind == Mistake::Kind::below && likeliest < question.value))
            return {Grade::foreseen, mistake.reply};
    return {Grade::wrong, not_that};
}

/// Which picks an answer names; nothing where it names what is none of them.
std::optional<std::vector<bool>> picked_in(const Picks& picks, const std::string& answer) {
    std::vector<bool> picked(picks.size());
    std::string spaced = answer;
    for (char& c : spaced)
        if (c == ',' || c == ';') c = ' ';
    std::istringstream words(spaced);
    for (std::string word; words >> word;) {
        if (word == "and") continue;
        const auto found = std::find_if(picks.begin(), picks.end(),
                                        [&](const Pick& pick) { return lower(pick.name) == word; });
        if (found == picks.end()) return {};
        picked[static_cast<std::size_t>(found - picks.begin())] = true;
    }
    return picked;
}

Graded grade_picks(const Question& question, const std::string& answer) {
    const auto picked = picked_in(question.picks, lower(answer));
    if (!picked)
        return {Grade::unclear,
                "Answer with names from the picture: " + names_of(question.picks, false) + "."};
    bool all_right = true;
    bool has_wrong = false;
    for (std::size_t i = 0; i < question.picks.size(); ++i) {
        all_right = all_right && (*picked)[i] == question.picks[i].right;
        has_wrong = has_wrong || ((*picked)[i] && !question.picks[i].right);
    }
    if (all_right) return {Grade::right, question.reply.empty() ? "Right." : question.reply};
    const auto is_made = [&](const Mistake& mistake) {
        if (mistake.kind == Mistake::Kind::missing) return !has_wrong;
        if (mistake.kind == Mistake::Kind::more) return has_wrong;
        for (std::size_t i = 0; i < question.picks.size(); ++i)
            if ((*picked)[i] && !question.picks[i].right &&
                question.picks[i].kind == mistake.picked)
                return true;
        return false;
    };
    for (const Mistake& mistake : question.mistakes)
        if (is_made(mistake)) return {Grade::foreseen, mistake.reply};
    return {Grade::wrong, not_that};
}

}  // namespace

std::string names_of(const Picks& picks, bool only_right) {
    std::string names;
    for (const Pick& pick : picks)
        if (pick.right || !only_right) names += (names.empty() ? "" : ", ") + pick.name;
    return names;
}

Graded grade(const Question& question, std::string_view typed) {
    const std::string answer = trimmed(typed);
    if (answer.empty()) return {Grade::unclear, "Type an answer, or pass."};
    if (!question.picks.empty()) return grade_picks(question, answer);
    return question.choices.empty() ? grade_number(question, answer)
                                    : grade_choice(question, answer);
}

std::string letter_of(std::size_t choice) {
    return std::string(1, static_cast<char>('a' + choice));
}

}  // namespace lessons
