#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

namespace lod {

/// What a child process may take; each is named in the error that it causes.
struct ChildLimits {
    std::uint64_t most_memory = 0;  ///< beyond what this process holds [bytes]
    double most_seconds = 0;        ///< of the processor's time; 0 accepts nothing
};

/// What the errors of a child process speak of.
struct ChildNames {
    std::string input;   ///< what is read
    std::string reader;  ///< whose code reads it: "the importer"
};

/// Where a child process sends its result.
class ChildPipe {
  public:
    explicit ChildPipe(int end) : end_(end) {}

    void send(const void* bytes, std::size_t count);
    template <typename T>
    void send(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        send(&value, sizeof value);
    }
    /// Tells what was thrown in place of a result. Requires: nothing sent.
    void send_failure() const;

  private:
    int end_;
    bool begun_ = false;
};

/// Foreign code at work in a process of its own, under limits of memory and time: an input that
/// hangs it, crashes it or blows it up costs an error. It writes nothing to the terminal. It ends
/// with this object, at the latest; a signal that ends this process ends it too.
class ChildProcess {
  public:
    /// Starts the work, which sends its result, or throws before it sends anything.
    ChildProcess(ChildNames names, const ChildLimits& limits,
                 const std::function<void(ChildPipe&)>& work);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// The next bytes of the result, once they come. Throws what the work threw: an Error as it
    /// was, anything else as input refused, memory that ran out as limit exceeded. Throws Error,
    /// limit exceeded, after the time that is granted (or twenty times as long on the clock, so
    /// that it may not sleep either); input refused where the child broke down; Interrupted a
    /// tenth of a second after stop_requested at the latest.
    void receive(void* bytes, std::size_t count);
    template <typename T>
    [[nodiscard]] T receive() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        receive(&value, sizeof value);
        return value;
    }

  private:
    void await() const;
    void read_whole(void* bytes, std::size_t count);
    void read_announcement();

    ChildNames names_;
    ChildLimits limits_;
    double latest_ = 0;  ///< the clock's time when it ends, whatever it does
    int process_ = -1;
    int pipe_ = -1;
    bool announced_ = false;
};

}  // namespace lod
