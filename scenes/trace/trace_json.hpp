#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lodlab/scenes/run.hpp"

/// What stands in traces, to JSON and back. What reads throws std::exception at anything else.
namespace scenes {

using Json = nlohmann::ordered_json;

[[nodiscard]] std::uint64_t from_hexadecimal(const std::string& text);

/// A list of numbers a body, as TraceInterval::states has them.
template <int Dim>
[[nodiscard]] Json states(const std::vector<State<Dim>>& all);
/// Back to the numbers, all in a row.
[[nodiscard]] std::vector<double> numbers_from(const Json& states, int dim);
/// How many numbers are a body's state.
[[nodiscard]] std::size_t numbers_of_a_state(int dim);
/// The states that such numbers are. Requires: a whole number of states.
template <int Dim>
[[nodiscard]] std::vector<State<Dim>> states_from(const std::vector<double>& numbers);

/// Every candidate pair of a frame, with its contacts.
template <int Dim>
[[nodiscard]] Json pairs(const lod::FrameRecord<Dim>& record);
/// What fast bodies ran into.
template <int Dim>
[[nodiscard]] Json swept(const lod::FrameRecord<Dim>& record);

[[nodiscard]] Json json_of(const lod::FrameSettings& settings);
[[nodiscard]] lod::FrameSettings settings_from(const Json& json);
[[nodiscard]] Json json_of(const std::optional<lod::Cut>& cut);
[[nodiscard]] std::optional<lod::Cut> cut_from(const Json& json);
[[nodiscard]] Json json_of(const Limits& limits);
[[nodiscard]] Limits limits_from(const Json& json);

}  // namespace scenes
