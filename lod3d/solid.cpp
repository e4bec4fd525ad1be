#include "lodlab/lod3d/solid.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/fill.hpp"
#include "lodlab/lod3d/intersect.hpp"
#include "lodlab/lod3d/mesh_faults.hpp"

namespace lod3d {
namespace {

void close_gaps(Mesh& mesh, std::vector<std::string>& mended) {
    const auto said = [&](const Welded& welded) {
        if (welded.duplicates > 0)
            mended.emplace_back("dropped " + counted(welded.duplicates, "repeated triangle"));
    };
    said(weld(mesh));
    if (mesh.triangles.empty() || find_bad_edges(mesh).open == 0) return;
    const Box box = bounding_box(mesh);
    Mesh welded = mesh;
    const Welded by_distance = weld(welded, 1e-6 * (box.high - box.low).maxCoeff());
    if (by_distance.vertices == 0 || welded.triangles.empty()) return;
    mended.emplace_back("merged " + counted(by_distance.vertices, "corner") +
                        " within 1e-6 of the size of the mesh");
    said(by_distance);
    mesh = std::move(welded);
}

void turn_alike(Mesh& mesh, std::vector<std::string>& mended) {
    const BadEdges before = find_bad_edges(mesh);
    if (before.reversed == 0) return;
    Mesh turned = mesh;
    const int changed = orient(turned);
    if (find_bad_edges(turned).reversed > 0) return;
    mesh = std::move(turned);
    mended.emplace_back("turned " + counted(changed, "triangle") + " to agree with the neighbours");
}

/// How often the surface winds around the space just behind and just before a part.
struct Sides {
    int behind = 0;
    int before = 0;
};

std::vector<Sides> sides_of_parts(const Mesh& mesh, const Parts& parts) {
    std::vector<std::size_t> largest(static_cast<std::size_t>(parts.count));
    std::vector<double> most(static_cast<std::size_t>(parts.count), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto part = static_cast<std::size_t>(parts.of_triangle[t]);
        const Point a = mesh.corner(t, 0);
        const double area = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
        if (area <= most[part]) continue;
        most[part] = area;
        largest[part] = t;
    }
    const MeshDistance distance(mesh, InsideRule::winding);
    std::vector<Sides> sides;
    for (std::size_t part = 0; part < largest.size(); ++part) {
        const Point a = mesh.corner(largest[part], 0);
        const Point b = mesh.corner(largest[part], 1);
        const Point c = mesh.corner(largest[part], 2);
        const Point off = 1e-5 * std::sqrt(most[part]) * (b - a).cross(c - a).stableNormalized();
        const Point middle = (a + b + c) / 3;
        sides.push_back({static_cast<int>(std::lround(distance.winding_number(middle - off))),
                         static_cast<int>(std::lround(distance.winding_number(middle + off)))});
    }
    return sides;
}

/// Turns parts that are inside-out. Returns how parts stand to each other then; crossing, too,
/// where one lies within another that it does not hollow out.
PartsMeet turn_outwards(Mesh& mesh, std::vector<std::string>& mended) {
    constexpr double hair = 1e-9;  // of the longest side
    const Parts parts = find_parts(mesh);
    const std::vector<Sides> sides = sides_of_parts(mesh, parts);
    long turned = 0;
    PartsMeet meet = PartsMeet::apart;
    for (const Sides& side : sides) {
        // Both are 1 where another part begins right there.
        if (side.behind == 0 && side.before == -1)
            ++turned;
        else if (side.behind != 1 || (side.before != 0 && side.before != 1))
            meet = PartsMeet::crossing;
    }
    const auto settled = [&] {
        const double longest = bounding_box(mesh).size().maxCoeff();
        if (meet == PartsMeet::crossing) return meet;
        if (parts.count > 1) return parts_meet(mesh, parts, hair * longest);
        return find_bad_edges(mesh).shared > 0 ? PartsMeet::touching : PartsMeet::apart;
    };
    if (turned == 0) return settled();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Sides& side = sides[static_cast<std::size_t>(parts.of_triangle[t])];
        if (side.behind == 0 && side.before == -1)
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    mended.emplace_back(parts.count == 1
                            ? "turned the surface, which was inside-out"
                            : "turned " + counted(turned, "part") + " of " +
                                  std::to_string(parts.count) + ", which stood inside-out");
    return settled();
}

Mesh filled(const Mesh& mesh, const SolidOptions& options) {
    try {
        return fill_by_winding(mesh, options.fill_cells);
    } catch (const lod::Error& error) {
        lod::refuse_input(options.source, error.what());
    }
}

/// Where a mesh is brought near to the origin: on each axis on which it lies several of its lengths
/// away its middle, else 0. Taking it off the vertices loses no bit (Sterbenz).
Point far_middle(const Box& box) {
    const Point middle = 0.5 * (box.low + box.high);
    const double longest = box.size().maxCoeff();
    Point far = Point::Zero();
    for (int d = 0; d < 3; ++d)
        if (std::abs(middle[d]) > 4 * longest) far[d] = middle[d];
    return far;
}

/// Moves a mesh near to the origin and gives it its size. Returns what was taken off after that.
Point bring_near(Mesh& mesh, const std::optional<double>& longest_side) {
    const Box box = bounding_box(mesh);
    Point moved = far_middle(box);
    for (Point& p : mesh.vertices) p -= moved;
    const double longest = box.size().maxCoeff();
    if (!longest_side || !(longest > 0)) return moved;
    const double scale = *longest_side / longest;
    for (Point& p : mesh.vertices) p *= scale;
    return scale * moved;
}

/// Closes and turns what can be; refuses what then still bounds no solid, unless it may be filled.
void mend(Mesh& mesh, const Point& moved, const SolidOptions& options, Solid& solid) {
    const std::string& source = options.source;
    close_gaps(mesh, solid.mended);
    if (mesh.triangles.empty())
        lod::refuse_input(
            source, "every triangle has two equal corners, all near " + place_in_words(moved) +
                        "; if it is small and far from the origin, move it there where it "
                        "is made, or write more digits");
    const int doubled = drop_other_sides(mesh);
    turn_alike(mesh, solid.mended);
    if (const int walls = drop_inner_walls(mesh); walls > 0) {
        drop_unused_vertices(mesh);
        solid.mended.emplace_back("dropped " + counted(walls, "triangle") +
                                  " that lie back to back within the solid");
    }
    const BadEdges bad = find_bad_edges(mesh);
    const std::string sides =
        doubled > 0 ? "its faces are doubled, each is there twice, turned both ways; " : "";
    if (!bad.none() && !options.fill)
        lod::refuse_input(source, "the mesh does not bound a solid: " + sides +
                                      describe(bad, mesh, moved) +
                                      "; mend it, or fill it by winding number (--fill, in a scene "
                                      "fill = true)");
    if (doubled > 0)
        solid.mended.emplace_back("dropped " + counted(doubled, "triangle") +
                                  " that doubled others, turned the other way");
    if (bad.none()) return;
    solid.mended.emplace_back("filled by winding number: " + describe(bad, mesh, moved));
    mesh = filled(mesh, options);
    solid.approximate = true;
}

}  // namespace

Solid make_solid(std::string name, Mesh mesh, const SolidOptions& given) {
    SolidOptions options = given;
    if (options.source.empty()) options.source = name;
    try {
        check_numbers(mesh);
    } catch (const lod::Error& error) {
        lod::refuse_input(options.source, error.what());
    }
    drop_unused_vertices(mesh);
    const Point moved = bring_near(mesh, options.longest_side);
    Solid solid;
    solid.name = std::move(name);
    mend(mesh, moved, options, solid);

    const PartsMeet meet = turn_outwards(mesh, solid.mended);
    Integrals of = integrate(mesh);
    const double longest = bounding_box(mesh).size().maxCoeff();
    if (!(of.volume > 1e-12 * longest * longest * longest))
        lod::refuse_input(options.source, why_no_volume(mesh, moved));
    // Where surfaces touch or cross, the nearest one does not tell the inside.
    if (meet != PartsMeet::apart) solid.inside_rule = InsideRule::winding;
    if (meet == PartsMeet::crossing) {
        of = integrate(filled(mesh, options));
        solid.approximate = true;
        solid.mended.emplace_back(
            "parts overlap: volume, centre and inertia are of their union on a grid");
    }
    solid.centroid = of.centroid + moved;  // rounded as doubles are there
    const Point centre = solid.centroid - moved;
    for (Point& p : mesh.vertices) p -= centre;
    solid.mesh = std::move(mesh);
    solid.volume = of.volume;
    solid.second_moment = of.inertia;
    return solid;
}

}  // namespace lod3d
