#include "lessons/exercises/judge.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>

namespace exercises {
namespace {

using Answers = std::vector<Numbers>;

constexpr double tolerance = 1e-9;  // of a number, of 1 where it is smaller
constexpr std::size_t most_letters = 220;

bool same_number(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (std::isinf(a) || std::isinf(b)) return a == b;
    return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

bool is_nan(const Numbers& answer) {
    return std::any_of(answer.begin(), answer.end(), [](double x) { return std::isnan(x); });
}

template <class Function>
Answers answers_of(std::span<const Case> cases, const Function& function) {
    Answers answers;
    for (const Case& one : cases) answers.push_back(function(one.numbers));
    return answers;
}

std::string cut(std::string text) {
    if (text.size() > most_letters) text.replace(most_letters, std::string::npos, " ...");
    return text;
}

std::string place_of(const Case& one) {
    return one.seed == 0 ? "an edge case" : "a case of seed " + std::to_string(one.seed);
}

/// How a variant fits what a student's function answered.
struct Fit {
    bool whole = true;          ///< the same answer in every case
    bool where_wrong = true;    ///< the same in every case in which the variant is wrong
    std::size_t explained = 0;  ///< wrong answers that are the variant's
};

Fit fit_of(const Answers& variant, const Answers& truths, const Answers& answers) {
    Fit fit;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const bool same = same_answer(variant[i], answers[i]);
        const bool is_wrong = !same_answer(variant[i], truths[i]);
        if (!same) fit.whole = false;
        if (!same && is_wrong) fit.where_wrong = false;
        if (same && is_wrong) ++fit.explained;
    }
    return fit;
}

bool is_constant(const Answers& answers) {
    return std::all_of(answers.begin(), answers.end(),
                       [&](const Numbers& answer) { return same_answer(answer, answers.front()); });
}

/// The mistakes that explain the answers best; none where none does.
std::vector<int> recognised(const Exercise& exercise, std::span<const Case> cases,
                            const Answers& truths, const Answers& answers, std::size_t wrong) {
    const Variant* best = nullptr;
    std::size_t explained = (wrong + 1) / 2;
    const bool constant = is_constant(answers);  // whose fault is in no single line
    for (const Variant& variant : exercise.variants) {
        if (variant.mistakes.empty() || (constant && variant.mistakes.size() > 1)) continue;
        const Fit fit = fit_of(answers_of(cases, variant.answer), truths, answers);
        if (fit.whole) return variant.mistakes;
        if (constant || variant.mistakes.size() > 1) continue;
        if (!fit.where_wrong || fit.explained < explained) continue;
        if (best == nullptr || fit.explained > explained) best = &variant;
        explained = fit.explained;
    }
    return best == nullptr ? std::vector<int>() : best->mistakes;
}

std::string told_signal(int signal) {
    switch (signal) {
        case SIGSEGV:
        case SIGBUS:
            return "it reads or writes memory that is not its own: an index beyond the end of a "
                   "list, "
                   "or a function that calls itself without end";
        case SIGFPE:
            return "a whole number is divided by zero";
        case SIGXFSZ:
            return "it prints without end";
        case SIGKILL:
            return "it was killed; does it ask for more and more memory?";
        default:
            return "it was ended";
    }
}

/// What its last line says, where the library's own checks or an exception speak there.
std::string told_output(const Attempt& attempt) {
    for (const std::string& line : attempt.lines) {
        if (line.find("Assertion") != std::string::npos && line.find("size()") != std::string::npos)
            return "an index beyond the end of a list";
        if (line.find("Assertion") != std::string::npos)
            return cut(line.substr(line.find("Assertion")));
    }
    return attempt.lines.empty() ? "" : cut(attempt.lines.back());
}

/// Where a program broke down.
void tell_end(const Exercise& exercise, std::span<const Case> cases, const Attempt& attempt,
              Judgement& found) {
    const std::size_t at = std::min(attempt.answers.size(), cases.size() - 1);
    const std::string asked =
        "It was asked: " + cut(told(exercise.words.told_case, cases[at].numbers)) + " (" +
        place_of(cases[at]) + ").";
    const std::string said = told_output(attempt);
    switch (attempt.end) {
        case Attempt::End::did_not_compile:
            found.verdict = "it does not compile";
            found.lines = attempt.lines;
            return;
        case Attempt::End::endless:
            found.verdict = "it gives no answer within 2 s; does every loop end?";
            break;
        case Attempt::End::crashed:
            found.verdict =
                "it crashed, signal " + std::to_string(attempt.signal) + " (" +
                ::strsignal(attempt.signal) + "): " +
                (attempt.signal == SIGABRT && !said.empty() ? said : told_signal(attempt.signal));
            break;
        case Attempt::End::threw:
            found.verdict = "it threw an exception: " + said;
            break;
        default:
            found.verdict = "it ended the program instead of giving an answer; return one";
            break;
    }
    found.lines = {asked};
}

/// What can be said of wrong answers that no foreseen mistake explains.
std::string told_pattern(const Exercise& exercise, const Answers& answers, const Numbers& wrong) {
    if (is_constant(answers))
        return "It answers the same in every case: " +
               cut(told(exercise.words.told_answer, answers.front())) + ".";
    if (is_nan(wrong))
        return "nan is no number: it comes from 0/0, or from the square root of a negative number.";
    return {};
}

}  // namespace

bool same_answer(const Numbers& a, const Numbers& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_number);
}

Judgement judge(const Exercise& exercise, std::span<const Case> cases, const Attempt& attempt) {
    Judgement found;
    found.cases = cases.size();
    if (attempt.end != Attempt::End::answered) {
        tell_end(exercise, cases, attempt, found);
        return found;
    }
    const Answers truths = answers_of(cases, exercise.task.truth);
    std::size_t first = cases.size();
    for (std::size_t i = cases.size(); i-- > 0;) {
        if (same_answer(attempt.answers[i], truths[i])) continue;
        ++found.wrong;
        first = i;
    }
    found.passes = found.wrong == 0;
    if (found.passes) {
        found.verdict = "it answers all " + std::to_string(cases.size()) + " cases";
        return found;
    }
    found.verdict = std::to_string(found.wrong) + " of " + std::to_string(found.cases) +
                    " cases are answered wrongly";
    found.mistakes = recognised(exercise, cases, truths, attempt.answers, found.wrong);
    for (const int mistake : found.mistakes)
        found.lines.push_back(exercise.words.mistakes[static_cast<std::size_t>(mistake)].reply);
    const std::string pattern = told_pattern(exercise, attempt.answers, attempt.answers[first]);
    if (found.mistakes.empty() && !pattern.empty()) found.lines.push_back(pattern);
    const Words& words = exercise.words;
    found.lines.push_back("Asked: " + cut(told(words.told_case, cases[first].numbers)) +
                          ". Answered: " + cut(told(words.told_answer, attempt.answers[first])) +
                          ". Right: " + cut(told(words.told_answer, truths[first])) + " (" +
                          place_of(cases[first]) + ").");
    return found;
}

}  // namespace exercises
