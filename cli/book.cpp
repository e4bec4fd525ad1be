#include "lessons/book/book.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "lessons/engine/lessons.hpp"

namespace cli {

void run_book(const Options& options) {
    ProgressBar bar("Writing the book");
    lessons::BookOptions book;
    book.video = !options.no_video;
    book.video_quality = quality_of(options);
    book.progress = [&](const lessons::BookProgress& progress) { bar.show(progress.share); };
    book.warn = [](const std::string& line) { remark(line); };
    lessons::write_book(options.out.back(), book);
}

}  // namespace cli
