#pragma once

/// \file
/// A scene file as data: the bodies, the settings, what is shown.

#include <array>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/frame/frame.hpp"

namespace scenes {

/// A vector of a scene file, world frame, SI units; in the plane its third entry is 0. A spin of
/// the plane turns about the third axis.
using Triple = std::array<double, 3>;

/// One body as a scene file describes it. World frame, SI units, radians.
struct BodySpec {
    std::string name;   ///< unique in its scene
    std::string shape;  ///< as written: a file, "package:NAME/FILE", "text:R", a generator,
                        ///< or half_space_name
    std::filesystem::path file;    ///< where the shape is a file beside the scene: its path
    std::string sha256;            ///< of the file that the scene was made with; empty: any will do
    std::optional<double> size;    ///< longest side of the shape's box [m]
    bool fill = false;             ///< open meshes are filled by winding number
    bool strokes = false;          ///< of a drawing: taken in, beside fills too
    bool page = false;             ///< a drawing is stretched and cut off by its page
    bool strict = false;           ///< refuse a drawing of which something is left out
    double density = 1;            ///< [kg/m^2] in the plane, [kg/m^3] in space
    std::optional<double> mass;    ///< [kg]; overrides the density
    bool is_static = false;        ///< never moves
    Triple position{};             ///< of the centre of mass [m]
    Triple axis{0, 0, 1};          ///< unit vector that the body is turned about
    double angle = 0;              ///< [rad], right-handed about the axis; the file says degrees
    Triple velocity{};             ///< of the centre of mass [m/s]
    Triple spin{};                 ///< [rad/s]
    double restitution = 1;        ///< 0 to 1; a pair takes the smaller
    std::string builder;           ///< of the tree; empty: the default builder
    std::optional<int> branching;  ///< children of a node; nothing: the builder's default
    std::optional<int> depth;      ///< levels below the root; nothing: the builder's default
    std::string where;             ///< "file:line:column" of its entry, for messages
};

/// The shape of a body that is all below a line or plane through its position; unturned, the second
/// axis points out of it.
inline constexpr std::string_view half_space_name = "half_space";

/// How far a frame refines. At most one of the three is set; none means to the leaves.
struct Limits {
    std::optional<int> level;                 ///< the last level that is tested
    std::optional<std::uint64_t> node_tests;  ///< per frame
    std::optional<double> milliseconds;       ///< per frame, on the clock
};

/// The part of the world that pictures show. World frame, metres.
struct Camera {
    Triple centre{};
    double width = 0;  ///< 0, in space only: all that moves
    /// Space: where the eye stands, about the vertical from the side of the reader, growing to the
    /// right [rad]; nothing: what moves, moves across.
    std::optional<double> azimuth;
    std::optional<double> elevation;  ///< space: above the ground [rad]
    bool perspective = false;         ///< space: what is near is larger
};

/// A scene file as data. README.md in this folder documents every key of the file.
struct Scene {
    std::string name;
    std::string title;  ///< a sentence for pictures
    int dim = 2;
    std::vector<BodySpec> bodies;
    double time_step = 1.0 / 240;  ///< [s]
    double duration = 2;           ///< [s]
    Limits limits;
    lod::Response response = lod::Response::net;
    lod::ContactModel contact_model = lod::ContactModel::hull;
    lod::PointModel point_model = lod::PointModel::radius_ratio;
    lod::Priority priority = lod::Priority::closing_speed;
    lod::Organisation organisation = lod::Organisation::interleaved;
    lod::Viewer viewer;        ///< who looks, for Priority::perceptual
    lod::FinestDetail finest;  ///< beyond the leaves
    /// Whether fast bodies are swept between frames; nothing: where something follows the leaves.
    std::optional<bool> sweep;
    std::optional<Camera> camera;  ///< nothing: pictures frame all that moves

    [[nodiscard]] std::int64_t frames() const;  ///< steps that cover the duration, at least 1
};

/// Reads a scene file. A shape file is looked up in the folder of the scene and may not lie outside
/// it. Throws lod::Error: input refused, with file, line, column and the mend, when the file cannot
/// be read, is no TOML, has an unknown key or a value outside its range; limit exceeded when it is
/// larger than a scene can be or has more than most_bodies bodies.
[[nodiscard]] Scene load_scene(const std::filesystem::path& path);

/// The same from memory; `path` is what messages call it and where shape files are looked up.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::filesystem::path& path);

inline constexpr std::size_t most_bodies = 10'000;

/// One key that the loader reads, as README.md documents it.
struct KeyNote {
    std::string section;  ///< "scene", "body" or "camera"
    std::string name;
    std::string unit;
    std::string otherwise;  ///< the default
};
/// Every key.
[[nodiscard]] std::vector<KeyNote> key_notes();

}  // namespace scenes
