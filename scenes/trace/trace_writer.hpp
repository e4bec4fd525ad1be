#pragma once

/// \file
/// Writes a trace while its run goes.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lodlab/io/files/output_file.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {

enum class TraceLine;

/// How a trace is written.
struct TraceSettings {
    /// From one frame whose bodies are told to the next: what a seek runs at most. 0: 100, fewer
    /// where there are more than 5,000 bodies, so that such frames hold half a million of them.
    std::int64_t key_frames = 0;
    /// Tells of each frame its bodies, pairs and contacts, for other programs. A replay needs none
    /// of it.
    bool records = false;
};

/// Where a run begins.
template <int Dim>
struct TraceOrigin {
    std::string scene;                       ///< its name
    std::span<const lod::Body<Dim>> bodies;  ///< at the start
    lod::FrameSettings settings;
    Limits limits;
};

/// Writes a trace frame by frame, one JSON document in lines, whose keys README.md of this folder's
/// parent lists. It keeps sixteen bytes a key frame, whatever the length of the run. The file is
/// complete or absent: without finish() nothing is left behind. Throws lod::Error (output failed)
/// as lod::OutputFile does.
template <int Dim>
class TraceWriter {
  public:
    /// Begins a trace.
    TraceWriter(const std::filesystem::path& path, const TraceOrigin<Dim>& origin,
                const TraceSettings& settings = {});
    /// Begins one with all frames of an earlier trace, whose run goes on: what is written then is
    /// what one long run would have written. Throws lod::Error (input refused) where the earlier
    /// one is damaged, or of version 2.
    TraceWriter(const std::filesystem::path& path, const Trace& earlier);

    /// Writes the next frame; `after` are the bodies that it leaves.
    void add(const Step<Dim>& step, const std::vector<State<Dim>>& after);
    /// Ends the trace, and gives the file its name. Requires: a frame.
    void finish();

  private:
    void write_bodies(const std::vector<State<Dim>>& states, TraceLine line);

    lod::OutputFile file_;
    TraceSettings settings_;
    std::int64_t frame_ = 0;  ///< the next one
    std::vector<std::pair<std::int64_t, std::uint64_t>>
        keys_;  ///< frames, and where their lines are
    std::vector<State<Dim>> end_;
};

/// Writes a whole run.
template <int Dim>
void write_trace(const std::filesystem::path& path, const std::string& scene,
                 std::span<const lod::Body<Dim>> bodies_at_start, const Run<Dim>& run,
                 const TraceSettings& settings = {});

}  // namespace scenes
