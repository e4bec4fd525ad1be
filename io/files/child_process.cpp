#include "lodlab/io/files/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <new>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace lod {
namespace {

/// What the child says first: a result follows, or so many letters that say why there is none.
struct Announcement {
    enum Kind : std::uint64_t { result, error, failure, out_of_memory } kind;
    std::uint64_t letters;
    ErrorKind error_kind;
};

double seconds_of(clockid_t clock) {
    timespec time{};
    if (clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// ---- in the child ----

void write_whole(int pipe, const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t sent = write(pipe, at, count);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(1);
        at += sent;
        count -= static_cast<std::size_t>(sent);
    }
}

void announce(int pipe, Announcement says, const std::string& why) {
    says.letters = why.size();
    write_whole(pipe, &says, sizeof says);
    write_whole(pipe, why.data(), why.size());
}

void limit_resources(const ChildLimits& limits) {
    const rlim_t seconds = static_cast<rlim_t>(limits.most_seconds) + 2;
    const rlimit cpu{seconds, seconds};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if defined(__has_feature)
#define LODLAB_SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define LODLAB_SANITIZED 0
#endif
#if !LODLAB_SANITIZED  // sanitizers map terabytes that they never touch
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + limits.most_memory;
    const rlimit memory{bytes, bytes};
    setrlimit(RLIMIT_AS, &memory);
#endif
#endif
}

/// Whatever ends the parent, a signal that cannot be caught too, ends the child.
void end_with(pid_t parent) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) _exit(1);
}

[[noreturn]] void run_child(ChildPipe pipe, pid_t parent, const ChildLimits& limits,
                            const std::function<void(ChildPipe&)>& work) {
    end_with(parent);
    for (const int signal : {SIGINT, SIGTERM})  // what is ignored stays so
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        limit_resources(limits);
        work(pipe);
    } catch (...) {
        pipe.send_failure();
    }
    _exit(0);
}

}  // namespace

void ChildPipe::send(const void* bytes, std::size_t count) {
    if (!begun_) announce(end_, {Announcement::result, 0, {}}, "");
    begun_ = true;
    write_whole(end_, bytes, count);
}

void ChildPipe::send_failure() const {
    if (begun_) _exit(1);
    try {
        throw;
    } catch (const Error& error) {
        announce(end_, {Announcement::error, 0, error.kind()}, error.what());
    } catch (const std::bad_alloc&) {
        announce(end_, {Announcement::out_of_memory, 0, {}}, "");
    } catch (const std::exception& error) {
        announce(end_, {Announcement::failure, 0, {}}, error.what());
    } catch (...) {
        _exit(1);
    }
}

// ---- in the parent ----

ChildProcess::ChildProcess(ChildNames names, const ChildLimits& limits,
                           const std::function<void(ChildPipe&)>& work)
    : names_(std::move(names)),
      limits_(limits),
      latest_(seconds_of(CLOCK_MONOTONIC) + 20 * limits.most_seconds) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) refuse_input(names_.input, std::strerror(errno));
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) run_child(ChildPipe(ends[1]), parent, limits, work);
    const int failure = errno;
    close(ends[1]);
    pipe_ = ends[0];
    if (process_ > 0) return;
    close(pipe_);
    refuse_input(names_.input, std::strerror(failure));
}

ChildProcess::~ChildProcess() {
    close(pipe_);
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

/// Until there is something to read.
void ChildProcess::await() const {
    clockid_t clock{};
    const bool known = clock_getcpuclockid(process_, &clock) == 0;
    for (;;) {
        check_interrupted();
        const double taken = known ? seconds_of(clock) : 0;
        if (taken >= limits_.most_seconds || seconds_of(CLOCK_MONOTONIC) >= latest_)
            throw Error(ErrorKind::limit_exceeded,
                        names_.input + ": reading it took longer than the limit of " +
                            std::to_string(static_cast<long>(limits_.most_seconds)) +
                            " s; simplify it or raise the limit");
        pollfd waiting{pipe_, POLLIN, 0};
        if (poll(&waiting, 1, 100) > 0) return;
    }
}

void ChildProcess::read_whole(void* bytes, std::size_t count) {
    char* at = static_cast<char*>(bytes);
    while (count > 0) {
        await();
        const ssize_t got = read(pipe_, at, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) refuse_input(names_.input, names_.reader + " broke down on it");
        at += got;
        count -= static_cast<std::size_t>(got);
    }
}

void ChildProcess::read_announcement() {
    Announcement says{};
    read_whole(&says, sizeof says);
    announced_ = true;
    if (says.kind == Announcement::result) return;
    std::string why(std::min<std::uint64_t>(says.letters, 2000), ' ');
    read_whole(why.data(), why.size());
    if (says.kind == Announcement::error) throw Error(says.error_kind, why);
    if (says.kind == Announcement::out_of_memory)
        throw Error(ErrorKind::limit_exceeded, names_.input +
                                                   ": reading it took more than the limit of " +
                                                   std::to_string(limits_.most_memory >> 20) +
                                                   " MB; simplify it or raise the limit");
    refuse_input(names_.input, why);
}

void ChildProcess::receive(void* bytes, std::size_t count) {
    if (!announced_) read_announcement();
    read_whole(bytes, count);
}

}  // namespace lod
