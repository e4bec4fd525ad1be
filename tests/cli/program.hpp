#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What one run of the program left behind.
struct Outcome {
    int code = 0;  ///< exit code; 128 + signal where a signal ended it
    std::string out;
    std::string err;
};

struct Start {
    std::filesystem::path folder;       ///< where it runs; empty: here
    std::function<void()> in_child;     ///< just before it starts: limits, another user
    int signal = 0;                     ///< sent once the program says that it has begun ...
    std::filesystem::path when_exists;  ///< ... or, where set, once a file begins with this path
    /// Trees of space take seconds to build, so tests share those that one of them built.
    std::vector<std::string> environment{"PATH=/usr/bin:/bin", "HOME=/nonexistent",
                                         "XDG_CACHE_HOME=" LODLAB_TEST_CACHE};
};

/// Runs lodlab with these arguments and waits for its end.
[[nodiscard]] Outcome lodlab(const std::vector<std::string>& arguments, const Start& start = {});

/// A folder of its own for a test, removed with all that is in it.
class Scratch {
  public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::string operator/(const std::string& name) const {
        return (path_ / name).string();
    }
    std::string write(const std::string& name, const std::string& text) const;
    /// Names of all that is in it, sorted.
    [[nodiscard]] std::vector<std::string> files() const;

  private:
    std::filesystem::path path_;
};

[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Whether the text is one line, newline included.
[[nodiscard]] bool is_one_line(const std::string& text);

/// Checks that the program failed with this code, and said so in one line with these words.
void check_failure(const Outcome& outcome, int code, const std::string& part);
