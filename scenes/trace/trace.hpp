#pragma once

/// \file
/// A run in a file, to be played again to the same bits, interruptions included, from any frame on.

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/scenes/run.hpp"

namespace scenes {

/// The version of the traces that are written. Those of version 2 are read, too.
inline constexpr int trace_version = 3;

/// The stages of a frame, in their order, as far as a trace tells them apart.
enum class Stage {
    state,     ///< the bodies as the frame found them
    pairs,     ///< the candidates of the broad phase
    levels,    ///< how far each pair was refined, and what that says of it
    contacts,  ///< where the bodies touch
    impulses,  ///< of every contact
    motion,    ///< the bodies after the frame
};
/// Their words in messages.
[[nodiscard]] constexpr std::array<std::string_view, 6> names_of(Stage) {
    return {"state", "pairs", "levels", "contacts", "impulses", "motion"};
}
static_assert(names_of(Stage{}).size() == static_cast<std::size_t>(Stage::motion) + 1);

/// FNV-1a over what each stage of a frame found; that of `motion` is lod::state_hash.
struct StageHashes {
    std::uint64_t pairs = 0;
    std::uint64_t levels = 0;
    std::uint64_t contacts = 0;
    std::uint64_t impulses = 0;
    std::uint64_t motion = 0;
    /// Whether they are the same.
    friend bool operator==(const StageHashes&, const StageHashes&) = default;
};

/// What a trace says of a frame.
struct FrameMark {
    std::optional<lod::Cut> cut;  ///< where the budget ended it, see FrameRecord
    StageHashes hashes;
    /// A small hash a body, of its state after the frame. Empty in version 2, whose `hashes` have
    /// `motion` alone.
    std::vector<std::uint16_t> bodies;
    /// Of a frame on a clock: what was left of its quota at its end, and when its levels were done.
    std::optional<std::chrono::nanoseconds> time_left = {};
    std::optional<lod::AfterLevels> after_levels = {};  ///< see time_left
};

/// Frames in a row, from one whose bodies the trace tells.
struct TraceInterval {
    std::int64_t first = 0;  ///< number of its first frame
    /// The bodies as that frame found them, one after the other: position, orientation (an angle,
    /// in space a quaternion x, y, z, w), velocity, spin. Empty where the trace does not tell them:
    /// they are the scene's then, and `first` is 0.
    std::vector<double> states;
    std::vector<FrameMark> frames;
};

/// What a trace says of all its frames.
struct TraceHead {
    int version = trace_version;
    std::string scene;              ///< its name
    int dim = 2;                    ///< of the scene
    std::uint64_t fingerprint = 0;  ///< of the bodies at the start
    lod::FrameSettings settings;
    Limits limits;                ///< of the run; none in version 2
    std::int64_t key_frames = 0;  ///< from one frame whose bodies it tells to the next
    bool has_records = false;     ///< whether it tells pairs and contacts, for other programs
};

class TraceText;

/// A trace that is open for reading: what it says of all frames and where its frames begin is read
/// at once, the frames when they are asked for. Not for two threads at once.
class Trace {
  public:
    /// Reads the beginning and the end of a text; `source` is what messages call it.
    Trace(std::shared_ptr<TraceText> text, std::string source);

    /// What it says of all frames.
    [[nodiscard]] const TraceHead& head() const { return head_; }
    /// How many frames it has, > 0.
    [[nodiscard]] std::int64_t frames() const { return keys_.back().frame; }
    /// The frames around one, from its first to the next whose bodies the trace tells. Throws
    /// lod::Error (input refused) where they are damaged. Requires: 0 <= frame < frames().
    [[nodiscard]] TraceInterval interval(std::int64_t frame) const;
    /// The bodies after the last frame, as TraceInterval::states; empty where it does not tell
    /// them, as in version 2. Throws lod::Error (input refused) where they are damaged.
    [[nodiscard]] std::vector<double> end() const;
    /// What messages call it.
    [[nodiscard]] const std::string& source() const { return source_; }

  private:
    friend class TraceCopy;
    struct Key {
        std::int64_t frame = 0;
        std::uint64_t offset = 0;  ///< of its line, in bytes
    };

    void read_head(std::string_view line);
    void read_index(std::string_view line, std::uint64_t head_bytes);
    void read_old(std::string_view text);
    void check_index(std::uint64_t index_begins) const;
    [[nodiscard]] std::size_t key_of(std::int64_t frame) const;
    [[nodiscard]] std::string bytes_of(std::size_t key) const;
    [[nodiscard]] TraceInterval parsed(std::size_t key, std::string_view text) const;
    [[noreturn]] void refuse(const std::string& why) const;

    std::string source_;
    TraceHead head_;
    std::vector<Key> keys_;           ///< the last is the end
    std::vector<TraceInterval> old_;  ///< all frames of one of version 2
    std::shared_ptr<TraceText> text_;
};

/// FNV-1a over all that decides how bodies move from here: state, mass, inertia, restitution and
/// every node of every tree.
template <int Dim>
[[nodiscard]] std::uint64_t fingerprint(std::span<const lod::Body<Dim>> bodies);

/// Sixteen hexadecimal digits, as hashes are written.
[[nodiscard]] std::string hexadecimal(std::uint64_t number);

/// Opens a trace. Throws lod::Error (input refused) when the file is none, is cut short, or is of a
/// version that is not read.
[[nodiscard]] Trace read_trace(const std::filesystem::path& path);
/// The same from memory; `source` is what messages call it.
[[nodiscard]] Trace parse_trace(std::string_view text, const std::string& source);

}  // namespace scenes
