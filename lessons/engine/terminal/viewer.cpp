#include "lessons/engine/terminal/viewer.hpp"

#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <vector>

#include "lodlab/core/base/stop.hpp"

extern char** environ;

namespace lessons {

bool show_picture(const std::filesystem::path& viewer, const std::filesystem::path& picture,
                  int columns, int rows) {
    std::vector<std::string> arguments{
        viewer.string(), "--animate=off",
        "--size=" + std::to_string(columns) + "x" + std::to_string(rows),
        std::filesystem::absolute(picture).string()};
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, viewer.c_str(), nullptr, nullptr, argv.data(), environ) != 0)
        return false;
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

struct KeyboardMode::Saved {
    termios settings;
};

KeyboardMode::KeyboardMode(int terminal) : terminal_(terminal), saved_(nullptr) {
    termios settings{};
    if (tcgetattr(terminal_, &settings) != 0) return;  // not a terminal: bytes come as they come
    saved_ = new Saved{settings};
    settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    tcsetattr(terminal_, TCSADRAIN, &settings);
}

KeyboardMode::~KeyboardMode() {
    if (saved_) tcsetattr(terminal_, TCSADRAIN, &saved_->settings);
    delete saved_;
}

int read_key(int terminal) {
    for (;;) {
        unsigned char byte = 0;
        const ssize_t count = read(terminal, &byte, 1);
        lod::check_interrupted();
        if (count == 1) return byte;
        if (count == 0 || errno != EINTR) return -1;
    }
}

std::optional<Window> window_of(int terminal) {
    winsize size{};
    if (ioctl(terminal, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
    return Window{size.ws_col, size.ws_row};
}

bool key_waiting(int terminal) {
    constexpr int patience = 25;  // [ms] between the bytes of one key
    pollfd waiting{terminal, POLLIN, 0};
    return poll(&waiting, 1, patience) > 0;
}

}  // namespace lessons
