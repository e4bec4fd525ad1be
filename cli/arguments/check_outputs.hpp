#pragma once

#include <string>
#include <vector>

#include "cli/arguments/options.hpp"

namespace cli {

/// What a command can write.
struct Formats {
    bool video = false;
    std::vector<std::string> exports{};  ///< endings, such as ".sph"
    bool still = true;                   ///< pictures
};

/// Before any work: throws lod::Error, usage for an ending that the command does not write, for an
/// output that is a file which the command reads, or that is named by one (a drawing that a scene
/// names, a texture), whatever path or link leads there, and for two outputs in one file; output
/// failed for a place that cannot be written. Also what reading a scene and a package throws.
void check_outputs(const Options& options, const Formats& formats);

}  // namespace cli
