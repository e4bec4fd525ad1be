#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/embed/question.hpp"

namespace lessons {

/// What the lines below the tag of a figure, the video or the live part say of it, by key.
using Words = std::map<std::string, KeyText>;

/// A number that a step shows in its list: `{{shown: TOLD = NAME}}`.
struct ShownTag {
    std::string told;  ///< what the reader is told that it is
    std::string name;
    std::string format;
    int line = 0;
};

/// A section `### Step: TITLE`.
struct StepScript {
    std::string title;
    std::string text;  ///< Markdown with its tags, line by line as it was written
    std::string figure;
    int figure_line = 0;
    std::vector<ShownTag> shown;
    std::vector<QuestionScript> questions;
    int line = 0;  ///< of the title; the first line of `text` is the next one
};

/// A lesson.md, taken apart. Line breaks stay where they were, so that every tag keeps its line.
struct Script {
    std::string where;                   ///< the file's name, for messages
    std::string text;                    ///< without the steps; {{steps}} stands in their place
    std::vector<StepScript> steps;       ///< one after another, under one heading
    std::map<std::string, Words> words;  ///< of figures, by name
    std::map<std::string, int> figures;  ///< the line of each figure's first tag
    Words video;
    Words live;
    int live_line = 0;  ///< of its tag; 0: there is none
};

/// Throws lod::Error (input refused) with the file and the line for steps that stand apart, a step
/// without a title, a text or a figure, words twice, and whatever find_tags refuses.
[[nodiscard]] Script read_script(std::string_view markdown, const std::string& where);

}  // namespace lessons
