#include "lodlab/io/files/child_process.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "tests/catch.hpp"

namespace {

using Work = std::function<void(lod::ChildPipe&)>;

const lod::ChildNames names{"a.txt", "the reader"};
constexpr lod::ChildLimits generous{1 << 30, 100};

[[noreturn]] void never_end() {
    volatile int round = 0;
    while (round == 0) {
    }
    std::abort();
}

struct Refusal {
    lod::ErrorKind kind{};
    std::string line;
};

/// What receiving one number from such a child throws.
Refusal refusal(const Work& work, const lod::ChildLimits& limits = generous) {
    lod::ChildProcess child(names, limits, work);
    try {
        (void)child.receive<int>();
    } catch (const lod::Error& error) {
        return {error.kind(), error.what()};
    }
    FAIL("received");
    return {};
}

}  // namespace

TEST_CASE("a child process hands over its result in as many pieces as it likes", "[child]") {
    std::vector<int> numbers(300'000);  // more than a pipe holds
    std::iota(numbers.begin(), numbers.end(), 7);
    lod::ChildProcess child(names, generous, [&](lod::ChildPipe& pipe) {
        pipe.send(numbers.size());
        pipe.send(numbers.data(), numbers.size() * sizeof(int));
    });
    std::vector<int> received(child.receive<std::size_t>());
    REQUIRE(received.size() == numbers.size());
    child.receive(received.data(), received.size() * sizeof(int));
    CHECK(received == numbers);
}

TEST_CASE("what a child process throws is thrown where its result is awaited", "[child]") {
    const Refusal error = refusal([](lod::ChildPipe&) {
        throw lod::Error(lod::ErrorKind::not_installed, "no such thing; install it");
    });
    CHECK(error.kind == lod::ErrorKind::not_installed);
    CHECK(error.line == "no such thing; install it");
    const Refusal other = refusal([](lod::ChildPipe&) { throw std::runtime_error("line\nends"); });
    CHECK(other.kind == lod::ErrorKind::input_refused);
    CHECK(other.line == "a.txt: line ends");
    const Refusal memory = refusal([](lod::ChildPipe&) { throw std::bad_alloc(); });
    CHECK(memory.kind == lod::ErrorKind::limit_exceeded);
    CHECK(memory.line.find("limit of 1024 MB") != std::string::npos);
}

TEST_CASE("a child process that breaks down is a refusal", "[child]") {
    const Refusal crash = refusal([](lod::ChildPipe&) { std::raise(SIGKILL); });
    CHECK(crash.kind == lod::ErrorKind::input_refused);
    CHECK(crash.line == "a.txt: the reader broke down on it");
    const Refusal silence = refusal([](lod::ChildPipe&) {});
    CHECK(silence.line == crash.line);
    const Refusal half = refusal([](lod::ChildPipe& pipe) {
        pipe.send('x');
        throw std::runtime_error("too late");
    });
    CHECK(half.line == crash.line);
}

TEST_CASE("a child process that never ends is ended at the limit of its time", "[child]") {
    const Refusal busy = refusal([](lod::ChildPipe&) { never_end(); }, {1 << 30, 0.1});
    CHECK(busy.kind == lod::ErrorKind::limit_exceeded);
    CHECK(busy.line.find("longer than the limit of 0 s") != std::string::npos);
    const Refusal asleep = refusal(
        [](lod::ChildPipe&) {
            for (;;) pause();
        },
        {1 << 30, 0.01});
    CHECK(asleep.kind == lod::ErrorKind::limit_exceeded);
}

TEST_CASE("whoever waits for a child process can be interrupted", "[child]") {
    lod::ChildProcess child(names, generous, [](lod::ChildPipe&) { never_end(); });
    lod::stop_requested = true;
    CHECK_THROWS_AS(child.receive<int>(), lod::Interrupted);
    lod::stop_requested = false;
}

#ifdef __linux__
TEST_CASE("a signal that ends the parent ends the child process", "[child]") {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t parent = fork();
    if (parent == 0) {
        lod::ChildProcess child(names, generous, [&](lod::ChildPipe&) {
            if (write(ends[1], "x", 1) == 1) never_end();
        });
        for (;;) pause();
    }
    close(ends[1]);
    char letter = 0;
    CHECK(read(ends[0], &letter, 1) == 1);
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    pollfd closed{ends[0], POLLIN, 0};  // once neither of them holds the other end
    CHECK(poll(&closed, 1, 60'000) == 1);
    CHECK(read(ends[0], &letter, 1) == 0);
    close(ends[0]);
}
#endif
