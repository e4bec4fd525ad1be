#pragma once

/// \file
/// A rigid solid in its body frame: a closed mesh with its volume, inertia and centre of mass.

#include <optional>
#include <string>
#include <vector>

#include "lodlab/lod3d/mesh/distance.hpp"

namespace lod3d {

/// A rigid solid in its body frame: the origin is the centre of mass, the axes are the source's.
struct Solid {
    std::string name;                ///< what the reader calls it: "gear:9", a file's stem
    Mesh mesh;                       ///< closed and oriented, body frame [m]
    double volume = 0;               ///< [m^3], > 0
    Point centroid = Point::Zero();  ///< centre of mass in the frame of the source [m]
    lod::Inertia<3> second_moment =
        lod::Inertia<3>::Zero();  ///< about the centre of mass [m^5]; times the density: inertia
    bool approximate = false;  ///< volume, centre and inertia come from a filled or sampled solid
    InsideRule inside_rule = InsideRule::nearest_normal;
    std::vector<std::string> mended;  ///< what was changed in the source, one line each
};

/// How a mesh becomes a solid.
struct SolidOptions {
    bool fill = false;        ///< take open and non-manifold meshes, filled by winding number
    int fill_cells = 64;      ///< cubes along the longest side, where something is filled
    std::string source = {};  ///< what refusals call it, such as the file; the name where empty
    std::optional<double> longest_side = {};  ///< that its box shall have [m]; nothing: as it is
};

/// Welds, checks and orients a mesh, centres it on its centre of mass and takes its integrals.
///
/// A mesh far from the origin is worked on near to it: it is moved there without loss, so that the
/// solid holds every digit that the mesh holds. The body frame is that of the source, moved by the
/// centroid, to the bit.
///
/// Vertices with equal coordinates are merged; where that leaves open edges, those within 1e-6 of
/// the box's longest side. Triangles that disagree with their neighbours and parts that are
/// inside-out are turned; of a part whose triangles are all there twice, turned both ways, one each
/// is kept. A shell within a shell that faces it is a cavity; one that does not is hidden, and
/// dropped, as a flat part is. Where closed parts cross, the solid is their union: its surface
/// keeps the hidden triangles, and the integrals are those of the union filled on a grid, marked
/// approximate. Parts that only touch keep their exact integrals.
///
/// Throws lod::Error: input refused, with the counts of bad edges and the place of the first, where
/// the mesh does not bound a solid of positive volume.
[[nodiscard]] Solid make_solid(std::string name, Mesh mesh, const SolidOptions& options = {});

}  // namespace lod3d
