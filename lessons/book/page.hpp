#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lessons/engine/lessons.hpp"

namespace lessons {

/// The path of a figure's picture, relative to the page; of its narrow one where it has one.
using PicturePath = std::function<std::string(const std::string& figure, bool narrow)>;

/// A figure of many columns, or a tall one, as a window has it that is as narrow as a phone's.
struct NarrowPicture {
    viz::Figure figure;
    double width = 0;       ///< in units
    bool is_strip = false;  ///< scrolled sideways
};

/// Up to four panels in two columns, more of them as a strip, so that words and shapes can be seen.
/// Nothing for a figure that can be read there as it is.
[[nodiscard]] std::optional<NarrowPicture> narrow_picture(const viz::Figure& figure);

/// A figure without the words that the page says above it.
[[nodiscard]] viz::Figure without_words(viz::Figure figure);

/// Units across a figure's picture: few, so that its words can be read on a phone.
[[nodiscard]] double picture_width(const viz::Figure& figure);

/// " width=... height=..." of a figure's picture, so that a page keeps its place free.
[[nodiscard]] std::string size_attributes(const viz::Figure& figure);
[[nodiscard]] std::string size_attributes(const viz::Figure& figure, double width);

/// The files of the lesson's video, relative to the page; empty where there is none.
struct VideoFiles {
    std::string light;
    std::string dark;
    std::string poster;
};

/// Files beside a lesson's page.
struct PageFiles {
    VideoFiles video;
    std::string scene;  ///< of the live part; empty: the page has none
};

/// The body of a completed lesson's page as HTML.
[[nodiscard]] std::string lesson_html(const Lesson& lesson, const PageFiles& files,
                                      const PicturePath& picture_path);

/// A C++ listing as HTML: comments, keywords, strings and numbers marked.
[[nodiscard]] std::string listing_html(const std::string& code);

}  // namespace lessons
