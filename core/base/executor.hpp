#pragma once

/// \file
/// Where work that is cut into parts is done: on one thread, or on those of a program that lends
/// them.

#include <algorithm>
#include <cstddef>
#include <memory>

namespace lod {

/// A task of many parts, by reference: it must outlive the call that it is handed to.
class PartTask {
  public:
    /// Of anything that is called with the number of a part and that of a worker.
    template <class Task>
    explicit PartTask(const Task& task)
        : task_(std::addressof(task)), call_([](const void* of, int part, int worker) {
              (*static_cast<const Task*>(of))(part, worker);
          }) {}
    /// Does one part.
    void operator()(int part, int worker) const { call_(task_, part, worker); }

  private:
    const void* task_;
    void (*call_)(const void*, int, int);
};

/// Does the parts of a task, on as many threads as it has. Injected, so that a program keeps its
/// own pool; the libraries start no thread. No result depends on which executor there is.
class Executor {
  public:
    virtual ~Executor() = default;
    /// How many parts it does at a time, at most; > 0, and always the same.
    [[nodiscard]] virtual int workers() const = 0;
    /// Calls task(part, worker) once for each part from 0 to parts - 1, in any order, with a worker
    /// from 0 to workers() - 1, never with the same one at the same time; and returns when all have
    /// ended. Where parts throw, some are left out and what one of them threw is thrown here.
    virtual void run(int parts, const PartTask& task) = 0;
};

/// Consecutive things of a list.
struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t number = 0;  ///< in the order of the list
    std::size_t worker = 0;  ///< who has this part
};

/// How many threads there are, where nothing stands for the calling one alone.
[[nodiscard]] inline std::size_t workers_of(const Executor* executor) {
    return executor == nullptr ? 1 : static_cast<std::size_t>((std::max)(1, executor->workers()));
}

/// Into how many parts of some size a list is cut: one, where only one thread is there.
[[nodiscard]] inline std::size_t parts_of(const Executor* executor, std::size_t count,
                                          std::size_t size) {
    return workers_of(executor) == 1 ? 1 : (std::max<std::size_t>)(1, (count + size - 1) / size);
}

/// Does `work` for parts of `count` things, `size` in each: where they end follows from the counts
/// alone.
template <class Work>
void each_part(Executor* executor, std::size_t count, std::size_t size, const Work& work) {
    const std::size_t parts = parts_of(executor, count, size);
    if (parts == 1) {
        work(Part{0, count, 0, 0});
        return;
    }
    const auto task = [&](int part, int worker) {
        const auto number = static_cast<std::size_t>(part);
        work(Part{number * size, (std::min)(count, (number + 1) * size), number,
                  static_cast<std::size_t>(worker)});
    };
    executor->run(static_cast<int>(parts), PartTask(task));
}

/// Bodies of which each takes some ten nanoseconds: so many in a part.
inline constexpr std::size_t bodies_of_a_part = 512;
/// Candidate pairs, of which each takes some hundred.
inline constexpr std::size_t pairs_of_a_part = 64;

}  // namespace lod
