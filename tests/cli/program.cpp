#include "tests/cli/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace {

struct Pipe {
    Pipe() {
        if (::pipe2(end.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
    }
    std::array<int, 2> end{};
};

[[noreturn]] void become(const std::vector<std::string>& arguments, const Start& start,
                         const Pipe& out, const Pipe& err) {
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(out.end[1], STDOUT_FILENO);
    ::dup2(err.end[1], STDERR_FILENO);
    if (!start.folder.empty() && ::chdir(start.folder.c_str()) != 0) ::_exit(126);
    for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);  // whoever tests
    if (start.in_child) start.in_child();
    std::vector<char*> argv{const_cast<char*>(LODLAB_PROGRAM)};
    for (const std::string& one : arguments) argv.push_back(const_cast<char*>(one.c_str()));
    argv.push_back(nullptr);
    std::vector<char*> environment;
    for (const std::string& one : start.environment)
        environment.push_back(const_cast<char*>(one.c_str()));
    environment.push_back(nullptr);
    ::execve(LODLAB_PROGRAM, argv.data(), environment.data());
    ::_exit(127);
}

/// Reads both pipes until the program closed them.
void drain(int out, int err, Outcome& outcome) {
    std::array<pollfd, 2> open{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
    std::array<std::string*, 2> texts{&outcome.out, &outcome.err};
    int left = 2;
    while (left > 0) {
        if (::poll(open.data(), open.size(), -1) < 0) continue;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (open[i].fd < 0 || open[i].revents == 0) continue;
            std::array<char, 65536> buffer;
            const ssize_t count = ::read(open[i].fd, buffer.data(), buffer.size());
            if (count > 0) {
                texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
            } else {
                open[i].fd = -1;
                --left;
            }
        }
    }
}

bool begins(const std::filesystem::path& wanted) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(wanted.parent_path(), ignored))
        if (entry.path().filename().string().starts_with(wanted.filename().string())) return true;
    return false;
}

/// Sends the signal as soon as the file is there; gives up when the program has ended.
void send_signal(pid_t child, const Start& start) {
    using namespace std::chrono_literals;
    for (int round = 0; round < 20'000; ++round) {
        siginfo_t info{};
        ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
        if (info.si_pid == child) return;
        if (begins(start.when_exists)) break;
        std::this_thread::sleep_for(1ms);
    }
    ::kill(child, start.signal);
}

}  // namespace

Outcome lodlab(const std::vector<std::string>& arguments, const Start& start) {
    const Pipe out;
    const Pipe err;
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("fork");
    if (child == 0) become(arguments, start, out, err);
    ::close(out.end[1]);
    ::close(err.end[1]);
    Outcome outcome;
    std::thread sender;
    if (start.signal != 0) sender = std::thread([&] { send_signal(child, start); });
    drain(out.end[0], err.end[0], outcome);
    if (sender.joinable()) sender.join();
    ::close(out.end[0]);
    ::close(err.end[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

Scratch::Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "lodlab-cli-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
    path_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Scratch::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::vector<std::string> Scratch::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

void check_failure(const Outcome& outcome, int code, const std::string& part) {
    INFO(outcome.err);
    CHECK(outcome.code == code);
    CHECK(outcome.out.empty());
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, part));
}
