#include "lessons/exercises/child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace exercises {
namespace {

using namespace std::chrono_literals;
constexpr rlim_t most_output = 64 << 20;  // [bytes] of each file that it writes
constexpr int not_started = 127;

/// In the child, after fork: nothing that another thread of the parent may have held.
[[noreturn]] void become(const ChildCommand& command, char** words, pid_t parent) {
    ::setpgid(0, 0);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (::getppid() != parent) ::_exit(not_started);
    for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    const int output = ::open(command.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    const rlimit output_bytes{most_output, most_output};
    ::setrlimit(RLIMIT_FSIZE, &output_bytes);
    const auto seconds = static_cast<rlim_t>(command.most_seconds);
    const rlimit processor{seconds, seconds + 1};
    ::setrlimit(RLIMIT_CPU, &processor);
    const rlimit memory{command.most_memory, command.most_memory};
    if (command.most_memory > 0) ::setrlimit(RLIMIT_AS, &memory);
    ::execv(words[0], words);
    ::_exit(not_started);
}

/// Ends the child and all that it started, when this object goes.
class Group {
  public:
    explicit Group(pid_t leader) : leader_(leader) {}
    ~Group() {
        ::kill(-leader_, SIGKILL);
        ::kill(leader_, SIGKILL);
        if (running_) wait(0);
    }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    /// Whether it has ended.
    bool wait(int options) {
        pid_t ended = 0;
        do ended = ::waitpid(leader_, &status_, options);
        while (ended < 0 && errno == EINTR);
        if (ended != 0) running_ = false;
        return !running_;
    }
    [[nodiscard]] int status() const { return status_; }

  private:
    pid_t leader_;
    bool running_ = true;
    int status_ = 0;
};

}  // namespace

ChildEnd run_child(const ChildCommand& command) {
    std::vector<std::string> copies = command.words;
    std::vector<char*> words;
    for (std::string& word : copies) words.push_back(word.data());
    words.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) become(command, words.data(), parent);
    if (child < 0)
        throw lod::Error(lod::ErrorKind::limit_exceeded, std::string("no process for ") +
                                                             copies.front() + ": " +
                                                             std::strerror(errno) + "; end others");
    Group group(child);
    const auto latest =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(10 * command.most_seconds);
    ChildEnd end;
    while (!group.wait(WNOHANG)) {
        lod::check_interrupted();
        if (std::chrono::steady_clock::now() > latest) return {true, SIGKILL, 0};
        std::this_thread::sleep_for(2ms);
    }
    if (WIFSIGNALED(group.status())) end.signal = WTERMSIG(group.status());
    if (WIFEXITED(group.status())) end.code = WEXITSTATUS(group.status());
    end.late = end.signal == SIGXCPU;
    if (end.code == not_started)
        throw lod::Error(lod::ErrorKind::not_installed,
                         copies.front() + " cannot be started; install it again");
    return end;
}

}  // namespace exercises
