#pragma once

#include <map>
#include <string>
#include <vector>

#include "lessons/embed/source.hpp"
#include "lessons/engine/lessons.hpp"

namespace lessons {

/// A lesson's words and its code. `make` fills steps, figures, numbers and the animation.
struct EmbeddedLesson {
    Source source;
    void (*make)(Lesson&) = nullptr;
};

/// Written by lodlab_embed when lodlab is built: every folder NN_slug, in order.
const std::vector<EmbeddedLesson>& embedded_lessons();

/// The templates, style sheet and script of the book, by file name.
const std::map<std::string, std::string>& embedded_files();

}  // namespace lessons
