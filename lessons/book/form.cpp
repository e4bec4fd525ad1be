#include "lessons/book/form.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lessons/embed/lines.hpp"
#include "lessons/embed/markdown.hpp"
#include "lessons/engine/questions/read_number.hpp"

namespace lessons {
namespace {

/// What the script grades by: the same as lessons::grade does.
nlohmann::ordered_json key_of(const Lesson& lesson, const Question& question) {
    using Json = nlohmann::ordered_json;
    constexpr const char* kinds[] = {"value", "above", "below", "missing", "more", "kind"};
    Json key;
    for (const Choice& choice : question.choices)
        key["choices"].push_back(
            {{"right", choice.right}, {"reply", inline_html(lesson, choice.reply)}});
    if (!question.choices.empty()) return key;
    for (const Pick& pick : question.picks)
        key["picks"].push_back({{"name", pick.name}, {"right", pick.right}, {"kind", pick.kind}});
    if (question.picks.empty())
        key = {
            {"value", question.value}, {"tolerance", question.tolerance}, {"unit", question.unit}};
    key["reply"] = inline_html(lesson, question.reply);
    key["mistakes"] = Json::array();
    for (const Mistake& mistake : question.mistakes)
        key["mistakes"].push_back({{"kind", kinds[static_cast<int>(mistake.kind)]},
                                   {"value", mistake.value},
                                   {"picked", mistake.picked},
                                   {"reply", inline_html(lesson, mistake.reply)}});
    return key;
}

/// JSON that may stand in a script element, which a text could end.
std::string script_text(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char c : json.dump()) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

std::string choices_html(const Lesson& lesson, const Question& question, const std::string& id) {
    std::string html = "<ol class=\"choices\">";
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        html += "<li><label><input type=\"radio\" name=\"" + id + "\" value=\"" + letter_of(i) +
                "\" hidden> <span>" + inline_html(lesson, question.choices[i].text) +
                "</span></label></li>";
    return html + "</ol>\n";
}

std::string number_html(const Question& question, const std::string& id) {
    return "<p class=\"typed\" hidden><label for=\"" + id +
           "-answer\">Your answer</label> <input id=\"" + id +
           "-answer\" type=\"text\" autocomplete=\"off\" spellcheck=\"false\" size=\"9\">" +
           (question.unit.empty()
                ? ""
                : " <span class=\"unit\">" + escaped_html(question.unit) + "</span>") +
           "</p>\n";
}

/// What stands in the form of a question whose answer is given in the picture.
constexpr const char* picked_html =
    "<p class=\"picked\" hidden>Picked in the picture: <output>none</output></p>\n";

}  // namespace

/// `r_a` in running text becomes an italic letter with its index; tags and code stay as they are.
std::string with_symbols(const std::string& html) {
    std::string result;
    bool in_tag = false;
    bool in_code = false;
    for (std::size_t i = 0; i < html.size(); ++i) {
        const char c = html[i];
        if (c == '<') {
            in_tag = true;
            if (html.compare(i, 5, "<code") == 0) in_code = true;
            if (html.compare(i, 6, "</code") == 0) in_code = false;
        }
        const bool begins_word = i == 0 || !is_word(html[i - 1]);
        if (!in_tag && !in_code && is_letter(c) && begins_word && i + 2 < html.size() &&
            html[i + 1] == '_' && is_word(html[i + 2])) {
            std::size_t end = i + 2;
            while (end < html.size() && is_word(html[end])) ++end;
            result += "<var>" + std::string(1, c) + "<sub>" + html.substr(i + 2, end - i - 2) +
                      "</sub></var>";
            i = end - 1;
            continue;
        }
        if (c == '>') in_tag = false;
        result += c;
    }
    return result;
}

std::string inline_html(const Lesson& lesson, const std::string& markdown) {
    std::string html = with_symbols(markdown_to_html(markdown, lesson.equations));
    html = trimmed(html);
    constexpr std::string_view open = "<p>";
    constexpr std::string_view close = "</p>";
    if (html.starts_with(open) && html.ends_with(close) &&
        html.find(close) == html.size() - close.size())
        html = html.substr(open.size(), html.size() - open.size() - close.size());
    return html;
}

std::string figure_words_html(const std::string& words) {
    std::string html;
    bool italic = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == '\\' && i + 1 < words.size()) {
            html += escaped_html(words.substr(++i, 1));
        } else if (words[i] == '*') {
            html += italic ? "</var>" : "<var>";
            italic = !italic;
        } else if (words[i] == '_' && i + 1 < words.size()) {
            const bool braced = words[i + 1] == '{';
            const std::size_t begin = i + (braced ? 2 : 1);
            const std::size_t end =
                braced ? std::min(words.find('}', begin), words.size()) : begin + 1;
            html += "<sub>" + escaped_html(words.substr(begin, end - begin)) + "</sub>";
            i = braced ? end : end - 1;
        } else {
            html += escaped_html(words.substr(i, 1));
        }
    }
    return html + (italic ? "</var>" : "");
}

std::string form_html(const Lesson& lesson, const Question& question, std::size_t number) {
    const std::string id = "question-" + std::to_string(number);
    return "<form class=\"question\" id=\"" + id + "\" data-name=\"" + escaped_html(question.name) +
           "\" novalidate autocomplete=\"off\">\n<fieldset>\n<legend>" +
           inline_html(lesson, question.prose) + "</legend>\n" +
           (!question.picks.empty()    ? picked_html
            : question.choices.empty() ? number_html(question, id)
                                       : choices_html(lesson, question, id)) +
           "<p class=\"acts\" hidden><button type=\"submit\">Answer</button> <button "
           "type=\"button\" class=\"pass\">Pass</button></p>\n"
           "<p class=\"reply\" role=\"status\" aria-live=\"polite\"></p>\n</fieldset>\n"
           "<script type=\"application/json\" class=\"key\">" +
           script_text(key_of(lesson, question)) + "</script>\n</form>\n";
}

}  // namespace lessons
