#include <atomic>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>

#include "cli/arguments/parse.hpp"
#include "cli/exit_code.hpp"
#include "cli/terminal/output.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace {

std::atomic<int> stop_signal{0};  ///< 0 while none asked to stop

void stop(int signal) {
    stop_signal = signal;
    lod::stop_requested = true;
}

/// Whether a signal ends a process that does nothing about it, and may: not those that say that the
/// program itself is broken.
bool ends(int signal) {
    switch (signal) {
        case SIGKILL:
        case SIGSTOP:  // nobody hears these
        case SIGSEGV:
        case SIGBUS:
        case SIGFPE:
        case SIGILL:
        case SIGABRT:
        case SIGTRAP:
        case SIGSYS:
        case SIGCHLD:
        case SIGCONT:
        case SIGTSTP:
        case SIGTTIN:
        case SIGTTOU:
        case SIGURG:
        case SIGWINCH:
            return false;
        default:
            return true;
    }
}

/// A signal that ends the program is noticed by check_interrupted(), so that what is half-written
/// goes. One that is ignored, as by nohup or behind a shell's &, stays ignored.
void listen_to_signals() {
    struct sigaction action {};
    action.sa_handler = stop;
    sigemptyset(&action.sa_mask);
    for (int signal = 1; signal <= SIGRTMAX; ++signal) {
        struct sigaction before {};
        if (!ends(signal) || sigaction(signal, nullptr, &before) != 0) continue;
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);  // the write itself fails, and says why
}

int failed(const std::string& line, int code) {
    cli::remark(line);
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    listen_to_signals();
    try {
        const cli::Parsed parsed = cli::parse(argc, argv);
        if (parsed.command)
            parsed.command->run(parsed.options);
        else
            cli::print(parsed.text);
        return cli::done_code;
    } catch (const lod::Error& error) {
        if (stop_signal == SIGPIPE) return cli::signal_code(SIGPIPE);  // nobody reads on
        return failed(error.what(), cli::exit_code(error.kind()));
    } catch (const lod::Interrupted&) {
        return failed("stopped by a signal; no file was left half-written",
                      cli::signal_code(stop_signal));
    } catch (const std::bad_alloc&) {
        return failed("out of memory; use a smaller scene or a shallower tree",
                      cli::exit_code(lod::ErrorKind::limit_exceeded));
    } catch (const std::filesystem::filesystem_error& error) {
        return failed("cannot use " + error.path1().string() + ": " + error.code().message() +
                          "; check the name",
                      cli::exit_code(lod::ErrorKind::input_refused));
    } catch (const std::exception& error) {
        return failed(std::string("internal error: ") + error.what() +
                          "; please report it with the command line",
                      cli::internal_error_code);
    }
}
