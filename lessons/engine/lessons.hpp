#pragma once

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "lodlab/viz/figure/figure.hpp"
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
};

/// One step: what happens and why. Its text is Markdown without equations; a symbol of the
/// equations is written `r_a`. A question to the reader begins with **Predict:** and is answered by
/// a later step.
struct Step {
    std::string title;
    std::string text;
    viz::Figure figure;
    std::map<std::string, Number> numbers;  ///< what changed in this step, by name
};

/// A lesson after its code has run.
struct Lesson {
    Entry entry;
    std::string markdown;  ///< lesson.md with its tags and equations as written
    std::vector<Step> steps;
    std::map<std::string, viz::Figure> figures;
    std::map<std::string, Number> numbers;
    std::map<std::string, std::string> listings;
    viz::Animation animation;

    std::map<std::string, std::string> equations;  ///< LaTeX as written -> MathML
};

/// Runs a lesson's code. Throws lod::Error: usage for a number that no lesson has; input refused
/// when its text names a figure, number or listing that its code does not make.
[[nodiscard]] Lesson run(int number);

/// Throws lod::Error (input refused), naming the line of the text, unless every tag of the lesson's
/// text names something that the lesson has, and every step has a title, a text and an alt text.
void check_lesson(const Lesson& lesson);

struct StepperOptions {
    std::filesystem::path
        pictures;  ///< folder for step_01.png, ...; made when missing; empty: none
    viz::Theme theme = viz::Theme::light;
    int keyboard = -1;    ///< a terminal to read single keys from; -1: lines from the input stream
    bool styled = false;  ///< bold and dim, for a terminal
    bool show_inline = false;  ///< show each picture by `chafa`, where it is installed
    int columns = 80;          ///< the text is broken into lines of at most so many characters
    int first_step = 1;
};

/// Steps through a lesson: next (Enter, n, space, right), back (b, p, left), a number or g NUMBER
/// (goto), t (the lesson's text), ? (help), q (quit). Prints what happens and why, and writes the
/// picture of each step it comes to. The end of the input quits.
/// Throws lod::Error: output failed where the pictures cannot be written, or would replace others.
void step_in_terminal(const Lesson& lesson, std::istream& input, std::ostream& output,
                      const StepperOptions& options = {});

}  // namespace lessons
