#include "lessons/book/book.hpp"
#include "cli/arguments/command.hpp"
#include "cli/stage/pictures.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
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
