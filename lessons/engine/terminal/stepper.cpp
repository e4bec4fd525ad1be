#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <istream>
#include <optional>
#include <ostream>
#include <system_error>

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/plain.hpp"
#include "lessons/engine/questions/answer_mode.hpp"
#include "lessons/engine/terminal/ascii.hpp"
#include "lessons/engine/terminal/commands.hpp"
#include "lessons/engine/terminal/viewer.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/io/files/find_program.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/files/temporary_folder.hpp"
#include "lodlab/viz/paint/blocks.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace lessons {
namespace {

constexpr int least_columns = 20;  // of a window, however narrow it is

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failed;
    const auto size = std::filesystem::file_size(a, failed);
    if (failed || std::filesystem::file_size(b, failed) != size || failed) return false;
    return lod::read_text_file(a, size) == lod::read_text_file(b, size);
}

class Stepper {
  public:
    Stepper(const Lesson& lesson, std::ostream& output, const StepperOptions& options)
        : lesson_(lesson), output_(output), options_(options), answers_(lesson, output, options_) {
        if (options.show_inline) viewer_ = lod::find_program("chafa");
        if (!viewer_.empty() && options.pictures.empty())
            shown_only_.emplace("pictures that are shown");
        if (options.pictures.empty()) return;
        std::error_code failed;
        std::filesystem::create_directories(options.pictures, failed);
        if (failed)
            throw lod::Error(lod::ErrorKind::output_failed,
                             options.pictures.string() + ": cannot be made: " + failed.message() +
                                 "; choose another folder");
        check_pictures_there();
    }

    void greet() {
        output_ << "Lesson " << lesson_.entry.number << ": " << lesson_.entry.title << "\n"
                << last() << " steps. Enter: next, b: back, a number: go to, t: text, ?: help, "
                << "q: quit\n";
        go(options_.first_step);
    }

    /// Returns whether the reader wants to go on.
    bool obey(const Command& command) {
        switch (command.kind) {
            case Command::Kind::next:
                if (at_ == last())
                    end();
                else
                    advance(at_ + 1);
                return true;
            case Command::Kind::back:
                if (at_ == 1)
                    output_ << "This is the first step.\n";
                else
                    go(at_ - 1);
                return true;
            case Command::Kind::go:
                advance(command.step);
                return true;
            case Command::Kind::answer:
                answers_.answer(at_, command.typed);
                if (!is_asking()) output_ << "\nEnter: next step.\n";
                return true;
            case Command::Kind::pass:
                answers_.pass(at_);
                return true;
            case Command::Kind::text:
                output_ << "\n";
                print_by_pages(
                    text_for_terminal(lesson_, lesson_.text, options_.columns, options_.styled));
                return true;
            case Command::Kind::help:
                output_ << (is_asking() ? answer_help : help_text);
                return true;
            case Command::Kind::unknown:
                output_ << "'" << viz::plain_text(command.typed)
                        << "' is no command; ? lists them.\n";
                return true;
            case Command::Kind::quit:
                return false;
        }
        return false;
    }

    /// Whether the step that is shown has a question left.
    [[nodiscard]] bool is_asking() const { return answers_.open_in(at_) != nullptr; }

    void prompt() {
        const Question* question = answers_.open_in(at_);
        if (question && question != asked_) answers_.ask(at_);
        asked_ = question;
        output_ << (question ? "answer> " : "> ") << std::flush;
    }

    void say_goodbye() {
        const Tally tally = answers_.tally();
        if (tally.at_once + tally.later + tally.passed > 0)
            output_ << "Questions: " << in_words(tally) << "\n";
        output_ << std::flush;
    }

  private:
    [[nodiscard]] int last() const { return static_cast<int>(lesson_.steps.size()); }

    /// A picture that is there already may be ours, to the byte; any other is the reader's.
    void check_pictures_there() const {
        for (int number = 1; number <= last(); ++number) {
            const std::filesystem::path there = options_.pictures / picture_name(number);
            std::error_code ignored;
            if (!std::filesystem::exists(std::filesystem::symlink_status(there, ignored))) continue;
            const lod::TemporaryFolder made("a look at what stands in " +
                                            options_.pictures.string());
            const std::filesystem::path ours = made.path() / picture_name(number);
            write_picture(number, ours);
            if (!same_bytes(ours, there))
                throw lod::Error(lod::ErrorKind::output_failed,
                                 "cannot write " + there.string() +
                                     ": another picture has that name; move it elsewhere, or "
                                     "choose another folder");
        }
    }

    static std::string picture_name(int number) {
        const std::string digits = std::to_string(number);
        return "step_" + std::string(digits.size() < 2 ? "0" : "") + digits + ".png";
    }

    void write_picture(int number, const std::filesystem::path& path) const {
        viz::WriteOptions how;
        how.theme = options_.theme;
        const Step& step = lesson_.steps[static_cast<std::size_t>(number - 1)];
        viz::write_png(path, lesson_.figures.at(step.figure), how);
    }

    void end() {
        output_ << "That was the last step. b goes back, q quits.\n";
        if (lesson_.live)
            output_ << text_for_terminal(lesson_, live_line(lesson_), options_.columns, false);
        const Tally tally = answers_.tally();
        if (tally.at_once + tally.later + tally.passed + tally.open > 0)
            output_ << "Questions: " << in_words(tally) << "\n";
    }

    /// Goes to a step, or to the first on the way whose question is open.
    void advance(int number) {
        const std::optional<int> blocked = answers_.blocked_between(at_, std::min(number, last()));
        if (!blocked || number > last()) return go(number);
        if (*blocked != at_) go(*blocked);
        output_ << "\nFirst answer the question of this step, or pass it by :p.\n";
        asked_ = nullptr;
    }

    void go(int number) {
        asked_ = nullptr;
        if (number < 1 || number > last()) {
            output_ << "There are steps 1 to " << last() << ".\n";
            return;
        }
        at_ = number;
        take_window();
        if (options_.arrived) options_.arrived(number);
        const Step& step = lesson_.steps[static_cast<std::size_t>(number - 1)];
        output_ << "\n[" << number << "/" << last() << "] " << (options_.styled ? "\033[1m" : "")
                << step.title << (options_.styled ? "\033[0m" : "") << "\n\n"
                << text_for_terminal(lesson_, step.text, options_.columns, options_.styled);
        if (!step.numbers.empty()) {
            output_ << "\n";
            for (const ShownNumber& shown : step.numbers)
                output_ << "  " << shown.told << ": " << shown.text << "\n";
        }
        draw(number);
    }

    void take_window() {
        const std::optional<Window> window =
            options_.keyboard >= 0 ? window_of(options_.keyboard) : std::nullopt;
        if (!window) return;
        options_.columns = std::max(window->columns, least_columns);
        options_.rows = window->rows;
    }

    /// A long text, a window at a time.
    void print_by_pages(const std::string& text) {
        constexpr std::string_view more = "[space: more, q: enough] ";
        const int page = std::max(options_.rows - 1, 2);
        int lines = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
            output_ << text.substr(begin, end - begin);
            begin = end;
            if (options_.keyboard < 0 || ++lines < page || begin == text.size()) continue;
            output_ << more << std::flush;
            const int key = read_key(options_.keyboard);
            output_ << '\r' << std::string(more.size(), ' ') << '\r';
            if (key < 0 || key == 'q' || key == 4) return;  // 4: Ctrl-D
            lines = 0;
        }
    }

    void draw(int number) {
        show_in_blocks(number);
        const std::filesystem::path folder = !options_.pictures.empty() ? options_.pictures
                                             : shown_only_              ? shown_only_->path()
                                                                        : std::filesystem::path();
        if (folder.empty()) return;
        const std::filesystem::path path = folder / picture_name(number);
        write_picture(number, path);
        if (!options_.pictures.empty()) output_ << "\npicture: " << path.string() << "\n";
        output_ << std::flush;
        if (!viewer_.empty()) show_picture(viewer_, path, options_.columns, picture_rows());
    }

    /// Where there is no viewer: the step's shapes, and in words what they are.
    void show_in_blocks(int number) {
        if (!options_.show_inline || !viewer_.empty()) return;
        const Step& step = lesson_.steps[static_cast<std::size_t>(number - 1)];
        const viz::Figure& figure = lesson_.figures.at(step.figure);
        output_ << "\n"
                << viz::block_text(figure, {.columns = options_.columns,
                                            .rows = picture_rows(),
                                            .theme = options_.theme,
                                            .colours = options_.colours})
                << text_for_terminal(lesson_, viz::plain_text(figure.alt), options_.columns, false);
    }

    [[nodiscard]] int picture_rows() const {
        constexpr int most = 30;
        constexpr int for_words = 4;
        return std::clamp(options_.rows - for_words, 1, most);
    }

    const Lesson& lesson_;
    std::ostream& output_;
    StepperOptions options_;
    std::filesystem::path viewer_;
    std::optional<lod::TemporaryFolder> shown_only_;
    AnswerMode answers_;
    const Question* asked_ = nullptr;  ///< the question that stands last on the screen
    int at_ = 1;
};

void step(const Lesson& lesson, std::istream& input, std::ostream& output,
          const StepperOptions& options) {
    if (options.first_step < 1 || options.first_step > static_cast<int>(lesson.steps.size()))
        throw lod::Error(lod::ErrorKind::usage,
                         "lesson " + std::to_string(lesson.entry.number) + " has no step " +
                             std::to_string(options.first_step) + "; it has steps 1 to " +
                             std::to_string(lesson.steps.size()));
    Stepper stepper(lesson, output, options);
    std::optional<KeyboardMode> keys;
    if (options.keyboard >= 0) keys.emplace(options.keyboard);
    stepper.greet();
    for (;;) {
        lod::check_interrupted();
        stepper.prompt();
        const std::optional<Command> command =
            read_command(stepper.is_asking(), input, output, options.keyboard);
        if (!command) break;
        output << "\n";
        if (!stepper.obey(*command)) break;
    }
    stepper.say_goodbye();
}

}  // namespace

void step_in_terminal(const Lesson& lesson, std::istream& input, std::ostream& output,
                      const StepperOptions& options) {
    if (!options.ascii) return step(lesson, input, output, options);
    AsciiBuffer buffer(output.rdbuf());
    std::ostream ascii(&buffer);
    step(lesson, input, ascii, options);
    if (!ascii) output.setstate(std::ios::failbit);
}

}  // namespace lessons
