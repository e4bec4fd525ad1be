#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cli {

/// What the command line said: one field for each row of the table of options (parse.cpp), shared
/// by all commands. A command reads the fields of the options that it takes.
struct Options {
    std::vector<std::string> given;  ///< the names of those that stood there: "--depth", "SHAPE"

    std::string shape;          ///< a file, text:R, or a generator
    std::string scene;          ///< a file, or the name of a scene that comes with lodlab
    std::optional<int> number;  ///< of a figure

    std::string lesson;  ///< its number or its name
    std::optional<int> step;
    std::string exercise;  ///< its number or its name
    bool hint = false;
    bool solution = false;
    bool reset = false;
    bool watch = false;

    bool json = false;
    std::vector<std::string> out;
    std::string theme = "light";
    std::string quality = "720p";

    std::optional<double> size;  ///< [m]
    std::string builder;
    std::optional<int> branching;
    std::optional<int> depth;
    std::optional<double> error;        ///< of a tree, share of the root's diameter
    std::optional<std::int64_t> nodes;  ///< of a tree, at most
    std::optional<int> dim;             ///< 2 or 3; nothing: as the shape says
    std::optional<double> effort;       ///< of the search for spheres
    bool no_cache = false;
    bool fill = false;     ///< open meshes, by winding number
    bool strokes = false;  ///< of drawings, beside fills too
    bool page = false;     ///< drawings are cut off by their page
    bool strict = false;   ///< no drawing of which something is left out
    bool list = false;

    std::optional<int> level;
    std::optional<std::uint64_t> budget;  ///< node tests a frame
    std::optional<double> milliseconds;   ///< a frame
    int threads = 1;                      ///< that do a frame

    std::optional<double> at;        ///< [s]
    std::optional<double> duration;  ///< [s]
    std::string response;
    std::string point_model;
    std::string contact_model;
    std::string finest;
    std::string policy;
    std::optional<std::array<double, 3>> fixation;  ///< [m]
    std::string sweep;                              ///< "on", "off"; empty: as the scene says
    bool projected = false;                         ///< the picture of collide, in space
    std::string picture;  ///< of simulate: "strip", "plot", "quota"; empty: what suits the scene
    std::string trace;
    std::optional<std::int64_t> key_frames;  ///< of the trace: from one to the next
    bool records = false;                    ///< the trace tells pairs and contacts, too
    std::string replay;
    std::string seek;       ///< FRAME[.EVENT] of the trace that is played again
    std::string continued;  ///< the trace at whose end the run goes on
    double raise_limits = 1;
    bool no_video = false;
    bool playground = false;  ///< the page is of no scene

    std::string shapes;     ///< of degrade, parted by commas
    std::string models;     ///< contact models, parted by commas
    std::string responses;  ///< parted by commas
    std::optional<int> impacts;
    std::optional<int> seeds;  ///< of a crowd
    std::string policies;      ///< parted by commas
    std::string bodies;        ///< of a crowd: how many, parted by commas
    bool levels = false;       ///< of a crowd, frame by frame
    std::uint64_t seed = 1;
    std::string share = "1/1";
    std::vector<std::string> merge;  ///< files with shares
};

}  // namespace cli
