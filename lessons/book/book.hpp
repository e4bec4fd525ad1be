#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lodlab/viz/paint/options.hpp"

namespace lessons {

/// How far write_book has come.
struct BookProgress {
    std::string what;          ///< "lesson 2: video"
    double share = 0;          ///< of the whole book, 0 to 1
    double seconds_left = -1;  ///< by the pace so far; negative while that is not known
};

struct BookOptions {
    std::vector<int> lessons;  ///< empty: all
    bool video = true;
    viz::Quality video_quality = viz::Quality::p720;
    std::function<void(const BookProgress&)> progress;
    std::function<void(const std::string&)> warn;  ///< told of a fallback, such as no video encoder
};

/// Writes the lessons as pages that work without a network: index.html and a folder a lesson.
/// The directory is complete or absent: pages are made in a temporary directory beside it, which
/// then takes its name. A book that stood there is replaced where it holds nothing but what
/// write_book wrote; anything else is refused (output failed), and stays as it is.
void write_book(const std::filesystem::path& directory, const BookOptions& options = {});

}  // namespace lessons
