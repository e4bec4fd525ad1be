#pragma once

/// \file
/// What happened in a frame, event by event: levels of pairs, contacts, rounds, impulses; and the
/// sentence of each.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/scenes/run.hpp"

namespace scenes {

/// What may happen in a frame.
enum class EventKind {
    level,    ///< a level of a pair was finished
    dropped,  ///< a level of a pair was begun, but its tests are thrown away
    skipped,  ///< a level of a pair was not begun: its tests did not fit into the budget
    exact,    ///< the true shapes of a pair were asked
    contact,  ///< two bodies were taken to touch
    round,    ///< a round of Response::net, where there were several
    impulse,  ///< a contact pushed two bodies apart, over all rounds
    swept,    ///< a fast body ran into another between two frames
};
/// Their words in results.
[[nodiscard]] constexpr std::array<std::string_view, 8> names_of(EventKind) {
    return {"level", "dropped", "skipped", "exact", "contact", "round", "impulse", "swept"};
}
static_assert(names_of(EventKind{}).size() == static_cast<std::size_t>(EventKind::swept) + 1);

/// Something that happened between two bodies in a frame.
template <int Dim>
struct Event {
    EventKind kind = EventKind::level;
    int nth = 1;         ///< of its kind in the frame
    std::int32_t a = 0;  ///< body numbers, from 0; of `round`: of the contact that pushed hardest
    std::int32_t b = 0;
    int level = 0;  ///< of `level`, `dropped` and `skipped`: which
    /// Of `level` and `dropped`: node tests that were done of that level.
    std::uint64_t tests = 0;
    std::uint64_t needed = 0;  ///< of `dropped` and `skipped`: node tests of that whole level
    /// Of `level`: node pairs; of `exact`: contacts; of `round`: contacts that pushed.
    std::uint64_t overlapping = 0;
    int round = 0;                ///< of `round`: which, from 1
    int rounds = 0;               ///< of `round`: of how many
    lod::Contact<Dim> contact{};  ///< of `contact`, `round`, `impulse` and `swept`
    double impulse = 0;           ///< of the same, but of `contact` [N s]
    /// Of `round`: what it added to the impulse of each contact, in the order of the record's
    /// impacts [N s].
    std::vector<double> pushes{};
    /// Of `exact`: when the shapes touched; of `swept`: when they met; from the frame's instant
    /// [s].
    double time = 0;
};

/// Every event of a frame, as they came: first pair by pair the levels that every pair gets, all of
/// them where there was no limit; under a limit then the levels by turns, as the policy chose, with
/// those that were dropped and skipped, and what still waited when nothing fitted any more; what
/// the true shapes say, pair by pair; the contacts; the rounds of the response; the impulses
/// contact by contact, without those of 0; what was swept, by time. Rounds are told where the
/// response, done again, gives the impulses of the record to the last bit, which it does where no
/// pair was backtracked. Requires: bodies are those of the step, in any state; settings are those
/// of its frame.
template <int Dim>
[[nodiscard]] std::vector<Event<Dim>> events_of(const Step<Dim>& step,
                                                std::span<const lod::Body<Dim>> bodies,
                                                const lod::FrameSettings& settings);

/// The name by which it is reached: its kind, and which of that kind, "contact:2".
template <int Dim>
[[nodiscard]] std::string event_name(const Event<Dim>& event) {
    return std::string(lod::name_of(event.kind)) + ":" + std::to_string(event.nth);
}

/// Whether a sentence says where bodies touch.
enum class Places { told, left_out };

/// What happened, as a sentence without its capital and its full stop; `names` are those of the
/// bodies.
template <int Dim>
[[nodiscard]] std::string sentence(const Event<Dim>& event, std::span<const std::string> names,
                                   Places places = Places::told);

/// How many events of each kind there are: "6 levels, 1 contact and 1 impulse"; "no event".
template <int Dim>
[[nodiscard]] std::string kinds_text(std::span<const Event<Dim>> events);

}  // namespace scenes
