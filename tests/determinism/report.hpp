#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/frame/state_hash.hpp"

/// One hash a name: of the bits of every body at the end of a run, of a tree, or of a text.
class Report {
  public:
    struct Line {
        std::string name;
        std::string hash;  ///< sixteen hexadecimal digits; empty: not made here, and why
        std::string why_not;
    };

    void add(const std::string& name, std::uint64_t hash);
    /// Of the bytes of a text that a program writes.
    void add_text(const std::string& name, std::string_view text);
    /// This machine lacks what it takes.
    void leave_out(const std::string& name, const std::string& why);

    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

  private:
    std::vector<Line> lines_;
};

/// Many hashes as one.
class Combined {
  public:
    void add(std::uint64_t hash) { value_ = (value_ ^ hash) * 1099511628211ULL; }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

void add_crowds(Report& report);        ///< core alone: balls by every response and model
void add_traversals(Report& report);    ///< of these, those by the default response and model
void add_plane_trees(Report& report);   ///< lod2d: builders, trees as text
void add_space_trees(Report& report);   ///< lod3d: builders, meshes in files
void add_scenes(Report& report);        ///< shipped scenes, interruptions, traces
void add_measurements(Report& report);  ///< degradation curves as text
