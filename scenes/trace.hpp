#pragma once

/// \file
/// A run in a file, to be played again to the same bits, interruptions included.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lodlab/scenes/run.hpp"

namespace scenes {

/// The version of the traces that are written and read.
inline constexpr int trace_version = 2;

/// What a trace must say for a run to be played again to the same bits.
struct Trace {
    std::string scene;              ///< its name
    std::uint64_t fingerprint = 0;  ///< of the bodies at the start
    lod::FrameSettings settings;
    std::vector<std::optional<lod::Cut>> cuts;  ///< one a frame, see FrameRecord
    std::vector<std::uint64_t> state_hashes;    ///< one a frame, after it
};

/// FNV-1a over all that decides how bodies move from here: state, mass, inertia, restitution and
/// every node of every tree.
template <int Dim>
[[nodiscard]] std::uint64_t fingerprint(std::span<const lod::Body<Dim>> bodies);

/// Sixteen hexadecimal digits, as hashes are written.
[[nodiscard]] std::string hexadecimal(std::uint64_t number);

/// Writes a run as JSON: all that Trace holds, and for readers each frame's bodies, pairs and
/// contacts. The keys are listed in README.md of this folder. Complete or absent.
template <int Dim>
void write_trace(const std::filesystem::path& path, const std::string& scene,
                 std::span<const lod::Body<Dim>> bodies_at_start, const Run<Dim>& run);

/// Throws lod::Error (input refused) when the file is no trace of this version.
[[nodiscard]] Trace read_trace(const std::filesystem::path& path);
/// The same from memory; `source` is what messages call it.
[[nodiscard]] Trace parse_trace(std::string_view text, const std::string& source);

/// Plays a trace again. Throws lod::Error (input refused) when the bodies are not those of the
/// trace, or when a frame's bits differ, naming the frame. `options` gives the clock and the
/// progress; its settings, frames, limits and cuts come from the trace.
template <int Dim>
[[nodiscard]] Run<Dim> replay(const Trace& trace, std::vector<lod::Body<Dim>> bodies,
                              RunOptions options);

}  // namespace scenes
