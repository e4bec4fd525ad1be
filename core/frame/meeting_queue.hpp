#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "lodlab/core/base/lists.hpp"

namespace lod {

/// Meetings of two bodies, a and b, in the order of time, those of equal times in that of the
/// bodies' numbers. One is over when either of its bodies has changed since it was added. Keeps the
/// storage of those that were taken.
template <class Meeting>
class MeetingQueue {
  public:
    /// Of none, among so many bodies.
    void clear(std::size_t bodies) {
        meetings_.clear();
        unused_.clear();
        due_.clear();
        changes_.assign(bodies, 0);
    }

    void add(Meeting&& meeting) {
        if (unused_.empty()) {
            unused_.push_back(meetings_.size());
            meetings_.emplace_back();
        }
        due_.push_back({meeting.time, meeting.a, meeting.b, unused_.back(), changes_[at(meeting.a)],
                        changes_[at(meeting.b)]});
        meetings_[unused_.back()] = std::move(meeting);
        unused_.pop_back();
        std::push_heap(due_.begin(), due_.end(), is_later);
    }

    /// Ends all meetings of a body.
    void change(std::size_t body) { ++changes_[body]; }

    /// Takes the first one that is not over. Returns false where none is left.
    [[nodiscard]] bool take_next(Meeting& meeting) {
        while (!due_.empty()) {
            std::pop_heap(due_.begin(), due_.end(), is_later);
            const Due due = due_.back();
            due_.pop_back();
            unused_.push_back(due.meeting);
            if (due.changes_of_a != changes_[at(due.a)] || due.changes_of_b != changes_[at(due.b)])
                continue;
            meeting = std::move(meetings_[due.meeting]);
            return true;
        }
        return false;
    }

  private:
    struct Due {
        double time = 0;
        std::int32_t a = 0;
        std::int32_t b = 0;
        std::size_t meeting = 0;  ///< into meetings_
        int changes_of_a = 0;     ///< when it was added
        int changes_of_b = 0;
    };
    static bool is_later(const Due& x, const Due& y) {
        return std::tie(x.time, x.a, x.b) > std::tie(y.time, y.a, y.b);
    }

    std::vector<Meeting> meetings_;
    std::vector<std::size_t> unused_;  ///< of them
    std::vector<Due> due_;             ///< a heap
    std::vector<int> changes_;         ///< of each body
};

}  // namespace lod
