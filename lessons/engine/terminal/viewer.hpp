#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lessons {

/// Shows a picture on standard output, in at most columns x rows characters, by the program chafa
/// that stands at `viewer`. Returns whether it said that it did. No shell is involved.
bool show_picture(const std::filesystem::path& viewer, const std::filesystem::path& picture,
                  int columns, int rows);

/// Puts a terminal into the state in which every key is delivered at once, unseen; the destructor
/// puts it back. Signals (Ctrl-C) stay on.
class KeyboardMode {
  public:
    explicit KeyboardMode(int terminal);
    ~KeyboardMode();
    KeyboardMode(const KeyboardMode&) = delete;
    KeyboardMode& operator=(const KeyboardMode&) = delete;

  private:
    struct Saved;
    int terminal_;
    Saved* saved_;
};

/// The next byte of a terminal, or -1 at its end. Throws lod::Interrupted when stop_requested is
/// set.
[[nodiscard]] int read_key(int terminal);

/// What a terminal shows at a time.
struct Window {
    int columns = 0;
    int rows = 0;
};

/// The size of a terminal's window; nothing where it does not say.
[[nodiscard]] std::optional<Window> window_of(int terminal);

/// Whether another byte follows at once: tells the Escape key from an arrow key's sequence.
[[nodiscard]] bool key_waiting(int terminal);

}  // namespace lessons
