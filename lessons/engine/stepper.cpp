#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <istream>
#include <optional>
#include <ostream>
#include <system_error>

#include "lessons/engine/ascii.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/plain.hpp"
#include "lessons/engine/questions/answer_mode.hpp"
#include "lessons/engine/viewer.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace lessons {
namespace {

constexpr std::string_view help_text =
    "Enter, n, space, right  next step\n"
    "b, p, left              one step back\n"
    "5 or g5                 go to step 5\n"
    "t                       the text of the lesson\n"
    "?                       this help\n"
    "q                       quit\n";

constexpr std::string_view answer_help =
    "A number may have a decimal comma or point, and a unit or none; a choice is a letter.\n"
    ":p   pass this question     :b   one step back     :5   go to step 5\n"
    ":t   the lesson's text      :h   this help         :q   quit\n";

struct Command {
    enum class Kind { next, back, go, text, help, quit, pass, answer, unknown };
    Kind kind = Kind::unknown;
    int step = 0;       ///< of go
    std::string typed;  ///< of unknown, and of answer
};

/// A whole line of input, as a pipe or a terminal in line mode gives it.
Command parse_line(std::string line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
    while (!line.empty() && line.front() == ' ') line.erase(0, 1);
    using Kind = Command::Kind;
    if (line.empty() || line == "n" || line == "next" || line == "right" || line == "\033[C")
        return {Kind::next, 0, {}};
    if (line == "b" || line == "p" || line == "back" || line == "left" || line == "\033[D")
        return {Kind::back, 0, {}};
    if (line == "t") return {Kind::text, 0, {}};
    if (line == "?" || line == "h" || line == "help") return {Kind::help, 0, {}};
    if (line == "q" || line == "quit") return {Kind::quit, 0, {}};
    std::string digits = line.starts_with("g") ? line.substr(1) : line;
    while (!digits.empty() && digits.front() == ' ') digits.erase(0, 1);
    constexpr std::size_t most_digits = 6;
    if (!digits.empty() && digits.size() <= most_digits &&
        digits.find_first_not_of("0123456789") == std::string::npos)
        return {Kind::go, std::stoi(digits), {}};
    return {Kind::unknown, 0, line};
}

/// A line typed to a question: an answer, or a command after a colon.
Command parse_answer(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos || line[first] != ':') return {Command::Kind::answer, 0, line};
    const std::string word = line.substr(first + 1);
    if (word == "p" || word == "p\r" || word == "pass") return {Command::Kind::pass, 0, {}};
    if (word.empty() || word == "\r") return {Command::Kind::help, 0, {}};
    return parse_line(word);
}

/// Single keys of a terminal; digits are gathered until Enter.
Command read_command_from_keys(int terminal, std::ostream& output) {
    std::string digits;
    for (;;) {
        const int key = read_key(terminal);
        if (key < 0 || key == 4) return {Command::Kind::quit, 0, {}};  // 4: Ctrl-D
        const char letter = static_cast<char>(key);
        if ((letter >= '0' && letter <= '9') || (letter == 'g' && digits.empty())) {
            digits += letter;
            output << letter << std::flush;
        } else if (key == 127 && !digits.empty()) {
            digits.pop_back();
            output << "\b \b" << std::flush;
        } else if (letter == '\n' || letter == '\r') {
            return parse_line(digits);
        } else if (letter == ' ') {
            return {Command::Kind::next, 0, {}};
        } else if (key == 27) {
            std::string sequence(1, letter);
            while (sequence.size() < 3 && key_waiting(terminal))
                sequence += static_cast<char>(read_key(terminal));
            if (sequence[1 % sequence.size()] == 'O' && sequence.size() == 3) sequence[1] = '[';
            return parse_line(sequence);
        } else {
            return parse_line(std::string(1, letter));
        }
    }
}

/// What the reader says next: a key, a line, or in answer to a question a whole line. Nothing at
/// the end of the input.
std::optional<Command> read_command(bool is_asking, std::istream& input, std::ostream& output,
                                    int keyboard) {
    if (keyboard >= 0 && !is_asking) return read_command_from_keys(keyboard, output);
    std::optional<std::string> line;
    if (keyboard >= 0)
        line = read_line_from_keys(keyboard, output);
    else if (std::string typed; std::getline(input, typed))
        line = typed;
    if (!line) return {};
    if (is_asking) return parse_answer(*line);
    const bool has_colon = line->starts_with(":") && *line != ":p";  // as in answer to a question
    return parse_line(has_colon ? line->substr(1) : *line);
}

/// A folder that goes away again, for pictures that are only shown.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "lodlab-XXXXXX").string();
        if (mkdtemp(name.data())) path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failed;
    const auto size = std::filesystem::file_size(a, failed);
    if (failed || std::filesystem::file_size(b, failed) != size || failed) return false;
    return lod::read_text_file(a, size) == lod::read_text_file(b, size);
}

class Stepper {
  public:
    Stepper(const Lesson& lesson, std::ostream& output, const StepperOptions& options)
        : lesson_(lesson), output_(output), options_(options), answers_(lesson, output, options) {
        if (options.show_inline) viewer_ = find_viewer();
        if (!viewer_.empty() && options.pictures.empty()) shown_only_.emplace();
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
                output_ << "\n"
                        << text_for_terminal(lesson_, lesson_.text, options_.columns,
                                             options_.styled);
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
            const TemporaryFolder made;
            if (made.path().empty())
                throw lod::Error(lod::ErrorKind::output_failed,
                                 "no temporary folder can be made to look at what stands in " +
                                     options_.pictures.string() +
                                     "; set TMPDIR, or choose an empty folder");
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

    void draw(int number) {
        const std::filesystem::path folder = !options_.pictures.empty() ? options_.pictures
                                             : shown_only_              ? shown_only_->path()
                                                                        : std::filesystem::path();
        if (folder.empty()) return;
        const std::filesystem::path path = folder / picture_name(number);
        write_picture(number, path);
        if (!options_.pictures.empty()) output_ << "\npicture: " << path.string() << "\n";
        output_ << std::flush;
        constexpr int inline_rows = 30;
        if (!viewer_.empty()) show_picture(viewer_, path, options_.columns, inline_rows);
    }

    const Lesson& lesson_;
    std::ostream& output_;
    const StepperOptions& options_;
    std::filesystem::path viewer_;
    std::optional<TemporaryFolder> shown_only_;
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
