#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lessons/embed/script.hpp"
#include "lessons/engine/questions/question.hpp"
#include "lodlab/live/scene.hpp"
#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/blocks.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace lessons {

/// What the list of lessons shows.
struct Entry {
    int number = 0;     ///< 1 and up
    std::string slug;   ///< "distance_test"
    std::string title;  ///< "Do two circles touch?"
};

/// Every lesson, in order.
[[nodiscard]] std::vector<Entry> list();

/// A number that running code found, and how a text shows it (rounded, with its unit).
struct Number {
    double value = 0;
    std::string text;
    std::string unit;        ///< which the text ends with
    bool is_counted = true;  ///< false: the text is words of its own, which take no other format
};

/// A number as a step shows it.
struct ShownNumber {
    std::string told;  ///< what it is: "R_a + R_b"
    std::string text;  ///< "1.650 m"
};

/// One step: what happens and why. Its text is Markdown, its numbers filled in; a symbol of the
/// equations is written `r_a`. Its questions keep the reader from the next step until each is
/// answered rightly or passed; a later step tells the answer.
struct Step {
    std::string title;
    std::string text;
    std::string figure;  ///< its name among the lesson's
    std::vector<ShownNumber> numbers;
    std::vector<Question> questions;
};

/// A scene that the reader plays with in the page. The code gives the scene, the text the words.
struct LivePart {
    live::Scene scene;
    std::string title;
    std::string task;      ///< Markdown: what to try, and what to see
    std::string controls;  ///< by name, as live::check_controls has them
};

/// A lesson: its words, and what its code found and drew. The code gives numbers, figures, the
/// animation and the scene of the live part; `complete` puts them and the words together.
struct Lesson {
    Entry entry;
    Script script;  ///< lesson.md
    std::map<std::string, std::string> listings;
    std::map<std::string, std::string> equations;  ///< LaTeX as written -> MathML

    std::map<std::string, Number> numbers;
    std::map<std::string, viz::Figure> figures;
    std::map<std::string, Picks> picks;
    viz::Animation animation;
    std::optional<LivePart> live;
    std::map<std::string, std::string> given;  ///< where the code gave a name: "lesson.cpp:12"
    std::set<std::string> said;                ///< keys of the video's words that the code took

    std::string text;  ///< of the lesson without its steps, numbers filled in; a {{steps}} tag
                       ///< stands for these, others for listings, figures, video and live part
    std::vector<Step> steps;
};

/// A line of a source. (std::source_location asks for clang 16.)
struct Place {
    const char* file = "";
    int line = 0;
    static Place current(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

// What a lesson's code gives. Throws lod::Error (input refused) for a name that is given twice.
void give(Lesson& lesson, const std::string& name, Number number, Place place = Place::current());
void give(Lesson& lesson, const std::string& name, viz::Figure figure,
          Place place = Place::current());

/// What a question's reader may pick in its step's picture.
void give(Lesson& lesson, const std::string& name, Picks picks, Place place = Place::current());

/// The scene of the live part; its name and title are the lesson's.
void give(Lesson& lesson, live::Scene scene, Place place = Place::current());

/// What a picture says beside its title: what a number is -> its name.
using Header = std::vector<std::pair<std::string, std::string>>;
/// A figure of one panel, in the shape of a page's. Throws besides for a number that is not given.
void give(Lesson& lesson, const std::string& name, viz::Panel panel, const Header& header = {},
          Place place = Place::current());

/// The words `key: ...` below the video's tag, numbers filled in. Throws lod::Error (input refused)
/// where there are none, or where they hold a number that was not given.
[[nodiscard]] std::string video_words(Lesson& lesson, const std::string& key);

/// Fills numbers into the words, and gives figures their titles and alt texts. Throws lod::Error
/// (input refused), with file and line, for a tag that names what the code does not give, a number
/// or figure that no text uses, a figure without a title or an alt text, words that nothing asks
/// for, and a question that cannot be graded, that no later step answers, or whose answer the
/// reader has seen.
void complete(Lesson& lesson);

/// The lesson of that number or name; or the one whose name alone holds the word, as "impulse".
/// Nothing where there is none, or more than one.
[[nodiscard]] std::optional<Entry> find_lesson(const std::string& word);

/// Runs a lesson's code and completes it. Throws lod::Error: usage for a number that no lesson has;
/// input refused as `complete`.
[[nodiscard]] Lesson run(int number);

struct StepperOptions {
    std::filesystem::path
        pictures;  ///< folder for step_01.png, ...; made when missing; empty: none
    viz::Theme theme = viz::Theme::light;
    int keyboard = -1;    ///< a terminal to read single keys from; -1: lines from the input stream
    bool ascii = false;   ///< no other characters, for a terminal without UTF-8
    bool styled = false;  ///< bold and dim, for a terminal
    bool show_inline = false;  ///< show each picture: by `chafa`, where it is installed, else in
                               ///< block characters
    viz::TerminalColours colours = viz::TerminalColours::indexed;  ///< of these
    int columns = 80;  ///< the text is broken into lines of at most so many characters
    int rows = 24;     ///< of the terminal's window: the lesson's text comes by pages
    int first_step = 1;
    std::function<void(int)> arrived;  ///< told the number of each step that is shown
};

/// Steps through a lesson: next (Enter, n, space, right), back (b, p, left), a number or g NUMBER
/// (goto), t (the lesson's text), ? (help), q (quit). Prints what happens and why, and writes the
/// picture of each step it comes to. A step's questions are asked below it: then a whole line is an
/// answer, whatever it says, and commands begin with a colon (:p passes). The end of the input
/// quits. On a keyboard's terminal columns and rows are its window's, as that is at each step.
/// Throws lod::Error: output failed where the pictures cannot be written, or would replace others.
void step_in_terminal(const Lesson& lesson, std::istream& input, std::ostream& output,
                      const StepperOptions& options = {});

}  // namespace lessons
