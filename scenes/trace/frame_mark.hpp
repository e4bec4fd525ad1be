#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {

/// What a trace says of a frame, `after` being the bodies after it.
template <int Dim>
[[nodiscard]] FrameMark mark_of(const Step<Dim>& step, const std::vector<State<Dim>>& after);

/// As it stands in a trace, and back. What reads throws std::exception at anything else.
[[nodiscard]] nlohmann::ordered_json json_of(std::int64_t frame, const FrameMark& mark);
[[nodiscard]] FrameMark mark_from(const nlohmann::ordered_json& json);

/// FNV-1a over states, in order: lod::state_hash of such bodies.
template <int Dim>
[[nodiscard]] std::uint64_t hash_of(const std::vector<State<Dim>>& states);

}  // namespace scenes
