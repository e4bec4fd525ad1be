#include <csignal>
#include <exception>
#include <iostream>

#include "cli/output.hpp"
#include "cli/parse.hpp"
#include "lodlab/core/error.hpp"

namespace {

void stop(int signal) {
    lod::stop_signal.store(signal, std::memory_order_relaxed);
}

void listen_to_signals() {
    struct sigaction action {};
    action.sa_handler = stop;
    sigemptyset(&action.sa_mask);
    for (int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
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
        return 0;
    } catch (const lod::Error& error) {
        return failed(error.what(), static_cast<int>(error.kind()));
    } catch (const lod::Interrupted& interrupted) {
        return failed("stopped by a signal; no file was left half-written",
                      128 + interrupted.signal());
    } catch (const std::bad_alloc&) {
        return failed("out of memory; use a smaller scene or a shallower tree",
                      static_cast<int>(lod::ErrorKind::limit_exceeded));
    } catch (const std::exception& error) {
        return failed(std::string("internal error: ") + error.what() +
                          "; please report it with the command line",
                      1);
    }
}
