#pragma once

/// \file
/// Shapes of the plane and of space behind one vocabulary, for code that treats both alike.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/builder/tree_report.hpp"
#include "lodlab/core/math/solvers.hpp"
#include "lodlab/core/tree/body.hpp"
#include "lodlab/io/sha256.hpp"
#include "lodlab/io/tree_cache.hpp"
#include "lodlab/lod2d/builder/build_tree.hpp"
#include "lodlab/lod2d/shape/distance.hpp"
#include "lodlab/lod3d/builder/build_tree.hpp"
#include "lodlab/lod3d/mesh/distance.hpp"

namespace scenes {

inline constexpr double half_space_reach = 1e5;  ///< [m]

/// How a shape is taken from its name.
struct ShapeChoice {
    /// Longest side of its box [m]. Nothing: 1 m for drawings and texts; meshes and generators are
    /// as large as their numbers say.
    std::optional<double> size;
    bool fill = false;        ///< take open meshes, filled by winding number
    double raise_limits = 1;  ///< factor of every limit on the size of files, >= 1
    bool strokes = false;     ///< of drawings: take strokes in, beside fills too
    bool strict = false;      ///< refuse a drawing of which something is left out
    bool page = false;        ///< of drawings: stretched and cut off by the page, as in a browser
};

/// Throws lod::Error (usage) where what only drawings have is chosen for something else.
void check_drawing_choice(const std::string& spec, const ShapeChoice& choice);

/// How a tree is asked for; the builders' defaults where nothing is said.
struct TreeChoice {
    std::string builder;
    std::optional<int> branching;
    std::optional<int> depth;
    /// A node that stands out by no more than this share of the root's diameter is not divided.
    std::optional<double> error;
    std::optional<std::int64_t>
        most_nodes;  ///< levels that would take the tree beyond are left out

    std::optional<double> effort;  ///< of the search for spheres; 1: the usual one
};

/// Some order, for maps.
[[nodiscard]] inline bool operator<(const TreeChoice& a, const TreeChoice& b) {
    const auto all = [](const TreeChoice& choice) {
        const auto& [builder, branching, depth, error, most_nodes, effort] = choice;
        return std::tie(builder, branching, depth, error, most_nodes, effort);
    };
    return all(a) < all(b);
}

/// Throws lod::Error (usage) where an effort is chosen for another builder than the one that has
/// it.
void check_effort(const TreeChoice& choice, bool has_effort);

/// What a dimension calls its things, for reports.
struct Vocabulary {
    std::string_view measure;       ///< "area"
    std::string_view measure_unit;  ///< "m^2"
    std::string_view moment_unit;   ///< "m^4": of the second moment of the measure
    std::string_view balls;         ///< "circles"
    std::string_view files;         ///< endings of the files that shapes are read from
};

/// A generator as a list of them shows it.
struct GeneratorNote {
    std::string name;
    std::string usage;
    std::string description;
};

/// Shapes of the plane and their trees.
struct PlaneShapes {
    /// What a body is.
    using Shape = lod2d::Shape;
    /// What its builder is asked for.
    using Settings = lod2d::TreeSettings;
    /// What tells whether two bodies touch.
    using Border = lod2d::BoundaryIndex;

    static constexpr Vocabulary words{"area", "m^2", "m^4", "circles", "svg, svgz"};

    /// A drawing, "text:R" or a generator. Throws lod::Error as lod2d::load_shape does, and for a
    /// mesh.
    [[nodiscard]] static Shape named(const std::string& spec, const ShapeChoice& choice);
    /// What of a half-space pictures and exact contact see: half_space_reach to all sides.
    [[nodiscard]] static Shape half_space();
    /// Throws lod::Error (usage) for an unknown builder.
    [[nodiscard]] static Settings settings(const TreeChoice& choice);
    /// Builds its tree.
    [[nodiscard]] static lod::SphereTree<2> build(const Shape& shape, const Settings& settings);
    /// Adds all that decides the tree: the geometry, every setting.
    static void identify(const Shape& shape, const Settings& settings, io::Sha256& key);
    /// How well the tree fits, level by level.
    [[nodiscard]] static lod::TreeReport report(const Shape& shape, const lod::SphereTree<2>& tree);

    /// Area [m^2].
    [[nodiscard]] static double measure(const Shape& shape) { return shape.area; }
    /// About the centre of mass; times the density: the inertia.
    [[nodiscard]] static lod::Inertia<2> second_moment(const Shape& shape);
    /// What was done to the source to make a shape of it, and what is not exact: a line each.
    [[nodiscard]] static std::vector<std::string> remarks(const Shape& shape);
    /// Whether its mass is not exact.
    [[nodiscard]] static bool is_approximate(const Shape&) { return false; }

    /// For exact contact, after the leaves.
    [[nodiscard]] static std::shared_ptr<const lod::ExactShape<2>> exact_of(const Shape& shape);

    /// What touch() asks.
    [[nodiscard]] static Border border_of(const Shape& shape);
    /// Whether the posed shapes share a point.
    [[nodiscard]] static bool touch(const Border& a, const lod::Body<2>& body_a, const Border& b,
                                    const lod::Body<2>& body_b);

    /// Every generator, for lists.
    [[nodiscard]] static std::vector<GeneratorNote> generators();
    [[nodiscard]] static std::vector<std::string_view> builders();  ///< the default first
};

/// Shapes of space and their trees.
struct SpaceShapes {
    /// As in PlaneShapes.
    /// @{
    using Shape = lod3d::Solid;
    using Settings = lod3d::TreeSettings;
    /// @}
    /// What tells whether two bodies touch.
    struct Border {
        lod3d::MeshDistance distance;
        std::vector<lod3d::Point> of_parts;  ///< a point of each connected part, body frame
    };

    static constexpr Vocabulary words{"volume", "m^3", "m^5", "spheres",
                                      "obj, ply, stl, off, 3ds, gltf, glb"};

    /// A mesh file or a generator. Throws lod::Error as lod3d::load_mesh, lod3d::make_solid and
    /// lod3d::generate do, and for a drawing or a text.
    [[nodiscard]] static Shape named(const std::string& spec, const ShapeChoice& choice);
    /// As in PlaneShapes.
    /// @{
    [[nodiscard]] static Shape half_space();
    [[nodiscard]] static Settings settings(const TreeChoice& choice);
    [[nodiscard]] static lod::SphereTree<3> build(const Shape& shape, const Settings& settings);
    static void identify(const Shape& shape, const Settings& settings, io::Sha256& key);
    [[nodiscard]] static lod::TreeReport report(const Shape& shape, const lod::SphereTree<3>& tree);

    [[nodiscard]] static double measure(const Shape& shape) { return shape.volume; }
    [[nodiscard]] static lod::Inertia<3> second_moment(const Shape& shape);
    [[nodiscard]] static std::vector<std::string> remarks(const Shape& shape);
    [[nodiscard]] static bool is_approximate(const Shape& shape) { return shape.approximate; }

    [[nodiscard]] static std::shared_ptr<const lod::ExactShape<3>> exact_of(const Shape& shape);

    [[nodiscard]] static Border border_of(const Shape& shape);
    [[nodiscard]] static bool touch(const Border& a, const lod::Body<3>& body_a, const Border& b,
                                    const lod::Body<3>& body_b);

    [[nodiscard]] static std::vector<GeneratorNote> generators();
    [[nodiscard]] static std::vector<std::string_view> builders();
    /// @}
};

/// The table of types: all that scenes and the program must know to treat the plane and space by
/// one code.
template <int Dim>
struct Shapes;
/// @{
/// A type of its own, not another name for one: compilers spell those differently for the linker.
template <>
struct Shapes<2> : PlaneShapes {};
template <>
struct Shapes<3> : SpaceShapes {};
/// @}
/// The shape of a body in so many dimensions.
template <int Dim>
using Shape = typename Shapes<Dim>::Shape;

/// A hash of the trees that the builders make of a few shapes (tests/scenes/builders.cpp computes
/// it and fails when it is another one): trees in the cache are of this version of the builders,
/// compiled with these releases of the libraries that they compute with.
inline constexpr std::string_view builders_version =
    "8763afc5cd49d2f9cb3d5491c95e78dd7618942f3993a592c7627bd4dd04fbd8";

/// The tree of a shape, from the cache where it was built before.
template <int Dim>
[[nodiscard]] lod::SphereTree<Dim> tree_of(const Shape<Dim>& shape,
                                           const typename Shapes<Dim>::Settings& settings,
                                           const io::TreeCache& cache) {
    io::Sha256 key;
    key.add(builders_version);
    key.add(std::string_view(lod::solvers_release()));
    key.add(Dim);
    Shapes<Dim>::identify(shape, settings, key);
    return cache.tree<Dim>(key.hexadecimal(), [&] { return Shapes<Dim>::build(shape, settings); });
}

/// 2 or 3, by what the shape's name says: a mesh, or a generator that only space has, is of space.
[[nodiscard]] int dimension_of(const std::string& spec);

}  // namespace scenes
