#pragma once

/// \file
/// What happened in a frame, event by event: levels of pairs, contacts, impulses.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/scenes/run.hpp"

namespace scenes {

/// What may happen in a frame.
enum class EventKind {
    level,    ///< a level of a pair was finished
    exact,    ///< the true shapes of a pair were asked
    contact,  ///< two bodies were taken to touch
    impulse,  ///< a contact pushed them apart
    swept,    ///< a fast body ran into another between two frames
};
/// Their words in results.
[[nodiscard]] constexpr std::array<std::string_view, 5> names_of(EventKind) {
    return {"level", "exact", "contact", "impulse", "swept"};
}
static_assert(names_of(EventKind{}).size() == static_cast<std::size_t>(EventKind::swept) + 1);

/// Something that happened between two bodies in a frame.
template <int Dim>
struct Event {
    EventKind kind = EventKind::level;
    std::int32_t a = 0;  ///< body numbers, from 0
    std::int32_t b = 0;
    int level = 0;                  ///< of `level`: which
    std::uint64_t tests = 0;        ///< of `level`: node tests of that level
    std::uint64_t overlapping = 0;  ///< of `level`: node pairs; of `exact`: contacts
    lod::Contact<Dim> contact{};    ///< of `contact`, `impulse` and `swept`
    double impulse = 0;             ///< of `impulse` and `swept` [N s]
    /// Of `exact`: when the shapes touched; of `swept`: when they met; from the frame's instant
    /// [s].
    double time = 0;
};

/// Every event of a frame, in one fixed order: pair by pair its finished levels, from the roots
/// down, and what its true shapes say; then the contacts pair by pair; their impulses in the same
/// order, without those of 0; what was swept by time. Requires: bodies are those of the step, in
/// any state.
template <int Dim>
[[nodiscard]] std::vector<Event<Dim>> events_of(const Step<Dim>& step,
                                                std::span<const lod::Body<Dim>> bodies);

}  // namespace scenes
