#include "lessons/book/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/book/form.hpp"
#include "lessons/embed/lines.hpp"
#include "lessons/embed/markdown.hpp"
#include "lessons/embed/source.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/viz/paint/paint.hpp"

namespace lessons {
namespace {

constexpr double of_few_columns = 520;  // 15 units, the smallest words, are 11 px on a phone

std::string picture_html(const PicturePath& path_of, const std::string& name,
                         const viz::Figure& figure) {
    const std::string path = path_of(name, false);
    std::string narrow;
    if (const auto other = narrow_picture(figure))
        narrow = "<source media=\"(max-width: 46rem)\" srcset=\"" + path_of(name, true) + "\"" +
                 size_attributes(other->figure, other->width) + ">";
    return "<a class=\"picture\" href=\"" + path + "\"><picture>" + narrow + "<img src=\"" + path +
           "\" alt=\"" + escaped_html(viz::plain_text(figure.alt)) + "\"" +
           size_attributes(figure) + " loading=\"lazy\" decoding=\"async\"></picture></a>";
}

/// A strip is as wide as its words ask for.
std::string pane_tag(const viz::Figure& figure) {
    constexpr double pixels = 0.75;  // for a unit
    const auto narrow = narrow_picture(figure);
    if (!narrow || !narrow->is_strip) return "<div class=\"pane\">";
    return "<div class=\"pane strip\" style=\"--strip: " + shown(pixels * narrow->width, 0) +
           "px\">";
}

/// What a question's reader picks, over the picture; the largest below the others.
std::string picks_html(const viz::Figure& figure, const Question& question, const std::string& id) {
    const double width = picture_width(figure);
    const viz::Mapping place = viz::panel_places(without_words(figure), width).front().mapping;
    Picks picks = question.picks;
    std::stable_sort(picks.begin(), picks.end(),
                     [](const Pick& one, const Pick& other) { return one.radius > other.radius; });
    std::string html = "<svg class=\"picks\" data-question=\"" + id + "\" role=\"group\" " +
                       "aria-label=\"What may be picked\" viewBox=\"0 0 " + shown(width, 0) + " " +
                       shown(width / figure.aspect, 0) + "\" hidden>";
    for (const Pick& pick : picks) {
        const viz::Point at = place(pick.centre);
        html += "<circle class=\"pick\" data-name=\"" + escaped_html(pick.name) +
                "\" role=\"checkbox\" aria-checked=\"false\" tabindex=\"0\" aria-label=\"Circle " +
                escaped_html(pick.name) + "\" cx=\"" + std::to_string(at.x) + "\" cy=\"" +
                std::to_string(at.y) + "\" r=\"" + std::to_string(place.length(pick.radius)) +
                "\"/>";
    }
    return html + "</svg>";
}

std::string numbers_html(const std::vector<ShownNumber>& numbers) {
    if (numbers.empty()) return {};
    std::string html = "<dl class=\"numbers\">";
    for (const ShownNumber& number : numbers)
        html += "<div><dt>" + with_symbols(escaped_html(number.told)) + "</dt><dd>" +
                escaped_html(number.text) + "</dd></div>";
    return html + "</dl>";
}

std::string video_html(const Lesson& lesson, const VideoFiles& video) {
    if (video.light.empty()) return "<p class=\"note\">This book was written without videos.</p>\n";
    const std::string type = video.light.ends_with(".webm") ? "video/webm" : "video/mp4";
    const std::string dark = video.dark.empty()
                                 ? std::string()
                                 : "<source src=\"" + video.dark + "\" type=\"" + type +
                                       "\" media=\"(prefers-color-scheme: dark)\">";
    return "<figure class=\"video\"><video controls muted playsinline loop preload=\"metadata\" "
           "poster=\"" +
           video.poster + "\" aria-label=\"" +
           escaped_html(viz::plain_text(lesson.animation.title)) + "\">" + dark + "<source src=\"" +
           video.light + "\" type=\"" + type + "\"></video><figcaption>" +
           escaped_html(viz::plain_text(lesson.animation.title)) + "</figcaption></figure>\n";
}

/// Stays hidden until a script shows it.
std::string live_html(const Lesson& lesson, const std::string& scene) {
    if (scene.empty()) return {};
    const LivePart& live = *lesson.live;
    const viz::Box& view = live.scene.view;
    const std::string title = inline_html(lesson, live.title);
    return "<section class=\"live\" data-scene=\"" + scene + "\" data-controls=\"" +
           escaped_html(live.controls) +
           "\" aria-labelledby=\"live-title\" hidden>\n<h2 id=\"live-title\">" + title +
           "</h2>\n<div class=\"task\">" + markdown_to_html(live.task, lesson.equations) +
           "</div>\n<div class=\"picture\"><svg class=\"stage\" role=\"group\" "
           "aria-labelledby=\"live-title\" style=\"aspect-ratio: " +
           std::to_string(view.high.x - view.low.x) + " / " +
           std::to_string(view.high.y - view.low.y) +
           "\"></svg><p class=\"finding\" aria-hidden=\"true\"></p><p class=\"spoken\" "
           "aria-live=\"polite\"></p></div>\n<div class=\"controls\"></div>\n"
           "<p class=\"trouble\" role=\"alert\"></p>\n</section>\n";
}

}  // namespace

viz::Figure without_words(viz::Figure figure) {
    figure.title.clear();
    figure.numbers.clear();
    figure.caption.clear();
    return figure;
}

std::optional<NarrowPicture> narrow_picture(const viz::Figure& figure) {
    constexpr double narrow_aspect = 1.28;   // as wide as a phone it is whole beside a step's words
    constexpr double strip_panel = 300;      // units across a panel
    constexpr double strip_aspect = 0.88;    // of it with its title
    constexpr double widest = 5;             // of figures
    constexpr std::size_t most_in_grid = 4;  // panels
    const bool has_many_columns = figure.columns > 2;
    if (!has_many_columns && figure.aspect >= narrow_aspect) return {};
    NarrowPicture narrow{figure, of_few_columns,
                         has_many_columns && figure.panels.size() > most_in_grid};
    viz::Figure& drawn = narrow.figure;
    drawn.aspect = narrow_aspect;
    if (!has_many_columns) return narrow;
    const auto panels = static_cast<double>(drawn.panels.size());
    drawn.columns = narrow.is_strip ? static_cast<int>(drawn.panels.size()) : 2;
    if (narrow.is_strip) {
        drawn.aspect = std::min(panels * strip_aspect, widest);
        narrow.width = panels * strip_panel;
    }
    drawn.column_weights.clear();
    for (viz::Panel& panel : drawn.panels) panel.cell.reset();
    return narrow;
}

double picture_width(const viz::Figure& figure) {
    constexpr double of_three_columns = 640;
    return figure.columns > 2 ? of_three_columns : of_few_columns;
}

std::string size_attributes(const viz::Figure& figure) {
    return size_attributes(figure, picture_width(figure));
}

std::string size_attributes(const viz::Figure& figure, double width) {
    const auto wide = static_cast<int>(std::lround(width));
    const auto tall = static_cast<int>(std::lround(width / figure.aspect));
    return " width=\"" + std::to_string(wide) + "\" height=\"" + std::to_string(tall) + "\"";
}

std::string listing_html(const std::string& code) {
    constexpr std::array<std::string_view, 24> keywords{
        "auto", "bool",  "const", "constexpr", "double", "else",     "enum",      "false",
        "for",  "if",    "int",   "inline",    "return", "static",   "struct",    "template",
        "true", "using", "void",  "while",     "class",  "typename", "namespace", "nodiscard"};
    std::string html;
    const auto mark = [&](const char* kind, std::string_view text) {
        html += std::string("<span class=\"") + kind + "\">" + escaped_html(text) + "</span>";
    };
    for (std::size_t i = 0; i < code.size();) {
        std::size_t end = i + 1;
        if (code.compare(i, 2, "//") == 0) {
            end = std::min(code.find('\n', i), code.size());
            mark("comment", std::string_view(code).substr(i, end - i));
        } else if (code[i] == '"') {
            while (end < code.size() && code[end] != '"') end += code[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, code.size());
            mark("string", std::string_view(code).substr(i, end - i));
        } else if (is_letter(code[i]) || code[i] == '_') {
            while (end < code.size() && is_word(code[end])) ++end;
            const std::string_view word = std::string_view(code).substr(i, end - i);
            if (std::find(keywords.begin(), keywords.end(), word) != keywords.end())
                mark("keyword", word);
            else
                html += word;
        } else {
            html += escaped_html(code.substr(i, 1));
        }
        i = end;
    }
    return "<pre class=\"listing\" tabindex=\"0\"><code>" + html + "</code></pre>\n";
}

namespace {

/// Writes the parts of a lesson's page.
class PageWriter {
  public:
    PageWriter(const Lesson& lesson, const PageFiles& files, const PicturePath& picture_path)
        : lesson_(lesson), files_(files), picture_path_(picture_path) {}

    std::string text_html(const std::string& markdown) {
        std::string html;
        std::string pending;  // Markdown that waits for the end of its part
        const auto flush = [&] {
            html += with_symbols(markdown_to_html(pending, lesson_.equations));
            pending.clear();
        };
        std::size_t done = 0;
        for (const Tag& tag : find_tags(markdown, lesson_.script.where)) {
            pending += markdown.substr(done, tag.begin - done);
            done = tag.end;
            flush();
            if (tag.kind == "listing") html += listing_html(lesson_.listings.at(tag.name));
            if (tag.kind == "steps") html += steps_html();
            if (tag.kind == "video") html += video_html(lesson_, files_.video);
            if (tag.kind == "live") html += live_html(lesson_, files_.scene);
            if (tag.kind == "figure")
                html += figure_html(tag.name, {}, is_in_step(tag.name) ? again : "<figure>") + "\n";
        }
        pending += markdown.substr(done);
        flush();
        return html;
    }

  private:
    static constexpr const char* again = "<figure class=\"again\">";  ///< is not printed twice

    [[nodiscard]] bool is_in_step(const std::string& figure) const {
        return std::any_of(lesson_.steps.begin(), lesson_.steps.end(),
                           [&](const Step& step) { return step.figure == figure; });
    }

    /// A picture with its finding in words, and what it counts unless that stands beside it.
    std::string figure_html(const std::string& name, const std::vector<ShownNumber>& beside = {},
                            const std::string& element = "<figure>", const std::string& over = "") {
        const viz::Figure& figure = lesson_.figures.at(name);
        std::string facts;
        for (const viz::Quantity& number : figure.numbers)
            if (std::none_of(beside.begin(), beside.end(),
                             [&](const ShownNumber& shown) { return shown.text == number.value; }))
                facts += "<span>" + figure_words_html(number.name) + " <b>" +
                         figure_words_html(number.value) + "</b></span> ";
        return element + "<figcaption><strong>" + figure_words_html(figure.title) + "</strong>" +
               (facts.empty() ? "" : " <span class=\"facts\">" + facts + "</span>") +
               (figure.caption.empty() ? "" : " " + figure_words_html(figure.caption)) +
               "</figcaption>" + pane_tag(figure) + picture_html(picture_path_, name, figure) +
               over + "</div></figure>";
    }

    std::string step_html(std::size_t index) {
        const Step& step = lesson_.steps[index];
        const std::string picks = picks_of(step);  // before its questions are numbered
        const std::string id = "step-" + std::to_string(index + 1);
        return "<article class=\"step\" id=\"" + id + "\" aria-labelledby=\"" + id +
               "-title\">\n<h3 id=\"" + id + "-title\"><span>" + std::to_string(index + 1) + "/" +
               std::to_string(lesson_.steps.size()) + "</span> " + escaped_html(step.title) +
               "</h3>\n" + figure_html(step.figure, step.numbers, "<figure>", picks) +
               "\n<div class=\"words\">" + text_html(step.text) + numbers_html(step.numbers) +
               "</div>\n" + questions_html(step) + "</article>\n";
    }

    /// Over the picture of a step, for those of its questions that are answered there.
    [[nodiscard]] std::string picks_of(const Step& step) const {
        std::string html;
        std::size_t number = questions_;
        for (const Question& question : step.questions) {
            ++number;
            if (!question.picks.empty())
                html += picks_html(lesson_.figures.at(step.figure), question,
                                   "question-" + std::to_string(number));
        }
        return html;
    }

    std::string questions_html(const Step& step) {
        if (step.questions.empty()) return {};
        std::string html = "<div class=\"questions\">";
        for (const Question& question : step.questions)
            html += form_html(lesson_, question, ++questions_);
        return html + "</div>\n";
    }

    std::string steps_html() {
        const std::string count = std::to_string(lesson_.steps.size());
        std::string html =
            "<section class=\"steps\" aria-label=\"Steps of the lesson\" tabindex=\"-1\">\n"
            "<div class=\"scrubber\" hidden>"
            "<button type=\"button\" class=\"back\" aria-label=\"Step back\">←</button>"
            "<input type=\"range\" min=\"1\" max=\"" +
            count +
            "\" value=\"1\" step=\"1\" aria-label=\"Step\">"
            "<button type=\"button\" class=\"next\" aria-label=\"Next step\">→</button>"
            "<output>1 / " +
            count +
            "</output></div>\n"
            "<p class=\"spoken\" role=\"status\" aria-live=\"polite\"></p>\n";
        for (std::size_t i = 0; i < lesson_.steps.size(); ++i) html += step_html(i);
        return html +
               "<p class=\"hint\" hidden>The arrow keys <kbd>←</kbd> <kbd>→</kbd> step back and "
               "forwards, <kbd>Home</kbd> and <kbd>End</kbd> go to the ends.</p>\n</section>\n"
               "<p class=\"tally\" data-lesson=\"" +
               lesson_.entry.slug + "\" data-questions=\"" + std::to_string(questions_) +
               "\" hidden></p>\n";
    }

    const Lesson& lesson_;
    const PageFiles& files_;
    const PicturePath& picture_path_;
    std::size_t questions_ = 0;  ///< written so far
};

}  // namespace

std::string lesson_html(const Lesson& lesson, const PageFiles& files,
                        const PicturePath& picture_path) {
    return PageWriter(lesson, files, picture_path).text_html(lesson.text);
}

}  // namespace lessons
