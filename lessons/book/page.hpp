#pragma once

#include <functional>
#include <string>

#include "lessons/engine/lessons.hpp"

namespace lessons {

/// Puts a picture into the page: writes its files and returns the paths, relative to the page.
struct PictureFiles {
    std::string light;
    std::string dark;
};
using WritePicture =
    std::function<PictureFiles(const std::string& name, const viz::Figure& figure)>;

/// The files of the lesson's video, relative to the page; empty where there is none.
struct VideoFiles {
    std::string light;
    std::string dark;
    std::string poster;
};

/// The body of a lesson's page as HTML. Requires: the lesson passed check_lesson.
[[nodiscard]] std::string lesson_html(const Lesson& lesson, const VideoFiles& video,
                                      const WritePicture& write_picture);

/// A C++ listing as HTML: comments, keywords, strings and numbers marked.
[[nodiscard]] std::string listing_html(const std::string& code);

}  // namespace lessons
