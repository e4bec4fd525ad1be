#include "lodlab/lod3d/solid/solid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"
#include "lodlab/lod3d/mesh/mesh_faults.hpp"
#include "lodlab/lod3d/solid/fill.hpp"

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
    bool operator==(const Sides&) const = default;

    /// Nothing but the part begins there.
    [[nodiscard]] bool clear() const { return behind == before + 1; }
    [[nodiscard]] bool inside_out() const { return behind <= 0 && before < 0; }
    [[nodiscard]] bool hidden() const { return behind > 1 && before > 0; }
};

/// At the middle of a triangle, so far off it [m].
Sides sides_at(const MeshDistance& distance, const Mesh& mesh, std::size_t triangle, double far) {
    const Point a = mesh.corner(triangle, 0);
    const Point b = mesh.corner(triangle, 1);
    const Point c = mesh.corner(triangle, 2);
    const Point off = far * (b - a).cross(c - a).stableNormalized();
    const Point middle = (a + b + c) / 3;
    return {static_cast<int>(std::lround(distance.winding_number(middle - off))),
            static_cast<int>(std::lround(distance.winding_number(middle + off)))};
}

/// Of a part, its triangles by size, the largest first. Preferably where what is close to one is
/// so further off, too; else close by, as in a wall that is thinner than that.
Sides sides_of_part(const MeshDistance& distance, const Mesh& mesh, double longest,
                    std::span<const std::pair<double, std::size_t>> triangles) {
    constexpr std::size_t most_asked = 16;
    const auto asked = triangles.first(std::min(most_asked, triangles.size()));
    const auto close_to = [&](const auto& triangle) {
        const double least = 1e-12 * longest;  // what rounding leaves of it is enough
        return sides_at(distance, mesh, triangle.second,
                        std::max(1e-9 * std::sqrt(triangle.first), least));
    };
    for (const auto& triangle : asked) {
        const Sides far =
            sides_at(distance, mesh, triangle.second, 1e-5 * std::sqrt(triangle.first));
        if (far.clear() && far == close_to(triangle)) return far;
    }
    for (const auto& triangle : asked)
        if (const Sides close = close_to(triangle); close.clear()) return close;
    return close_to(asked.front());
}

std::vector<Sides> sides_of_parts(const Mesh& mesh, const Parts& parts) {
    std::vector<std::vector<std::pair<double, std::size_t>>> of_part(
        static_cast<std::size_t>(parts.count));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Point a = mesh.corner(t, 0);
        const double area = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
        of_part[static_cast<std::size_t>(parts.of_triangle[t])].emplace_back(area, t);
    }
    const MeshDistance distance(mesh, InsideRule::winding);
    const double longest = bounding_box(mesh).size().maxCoeff();
    std::vector<Sides> sides;
    for (auto& triangles : of_part) {
        lod::check_interrupted();
        std::sort(triangles.begin(), triangles.end(), [](const auto& s, const auto& t) {
            return s.first > t.first || (s.first == t.first && s.second < t.second);
        });
        sides.push_back(sides_of_part(distance, mesh, longest, triangles));
    }
    return sides;
}

/// Drops flat parts, which bound nothing, and says so. Refuses a mesh of which another part bounds
/// no volume, as where its faces are doubled: what it was meant to hold cannot be told.
void check_parts(Mesh& mesh, const Point& moved, const std::string& source,
                 std::vector<std::string>& mended) {
    const Parts parts = find_parts(mesh);
    if (parts.count == 1) return;
    std::vector<Mesh> of_part(static_cast<std::size_t>(parts.count));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        of_part[static_cast<std::size_t>(parts.of_triangle[t])].triangles.push_back(
            mesh.triangles[t]);
    Mesh kept;
    kept.vertices = mesh.vertices;
    long flat = 0;
    for (Mesh& part : of_part) {
        const std::vector<Triangle> triangles = part.triangles;
        for (Triangle& t : part.triangles)
            for (std::int32_t& corner : t) {
                part.vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
                corner = static_cast<std::int32_t>(part.vertices.size()) - 1;
            }
        const bool bounds = bounds_volume(part);
        if (!bounds && !is_flat(part))
            lod::refuse_input(
                source,
                why_no_volume(part, moved,
                              "one of its " + std::to_string(parts.count) + " parts, which holds " +
                                  place_in_words(part.vertices[0] + moved) + ","));
        if (bounds)
            kept.triangles.insert(kept.triangles.end(), triangles.begin(), triangles.end());
        else
            ++flat;
    }
    if (flat == 0 || flat == parts.count) return;
    drop_unused_vertices(kept);
    mesh = std::move(kept);
    mended.emplace_back("dropped " + counted(flat, "part") + " of " + std::to_string(parts.count) +
                        ", flat and so without a volume");
}

/// Turns the parts that are inside-out. Returns how many those are.
long turn_parts(Mesh& mesh, const Parts& parts, const std::vector<Sides>& sides) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (sides[static_cast<std::size_t>(parts.of_triangle[t])].inside_out())
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    return std::count_if(sides.begin(), sides.end(), std::mem_fn(&Sides::inside_out));
}

/// Drops the parts that lie within others and bound nothing. Returns how many those are.
long drop_hidden(Mesh& mesh, const Parts& parts, const std::vector<Sides>& sides) {
    const long hidden = std::count_if(sides.begin(), sides.end(), std::mem_fn(&Sides::hidden));
    if (hidden == 0) return 0;
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!sides[static_cast<std::size_t>(parts.of_triangle[t])].hidden())
            kept.push_back(mesh.triangles[t]);
    mesh.triangles = std::move(kept);
    drop_unused_vertices(mesh);
    return hidden;
}

/// Turns parts that are inside-out and drops those that others hide. Returns how the parts stand to
/// each other then.
PartsMeet turn_outwards(Mesh& mesh, std::vector<std::string>& mended) {
    constexpr double hair = 1e-9;  // of the longest side
    const Parts parts = find_parts(mesh);
    std::vector<Sides> sides = sides_of_parts(mesh, parts);
    const auto counted_parts = [&](long count) {
        return counted(count, "part") + " of " + std::to_string(parts.count);
    };
    if (const long turned = turn_parts(mesh, parts, sides); turned > 0) {
        mended.emplace_back(parts.count == 1
                                ? "turned the surface, which was inside-out"
                                : "turned " + counted_parts(turned) + ", which stood inside-out");
        sides = sides_of_parts(mesh, parts);
    }
    for (const Sides& side : sides)  // both are 1 where another part begins right there
        if (!side.hidden() && (side.behind != 1 || (side.before != 0 && side.before != 1)))
            return PartsMeet::crossing;
    if (parts.count == 1)
        return find_bad_edges(mesh).shared > 0 ? PartsMeet::touching : PartsMeet::apart;
    const double longest = bounding_box(mesh).size().maxCoeff();
    const PartsMeet meet = parts_meet(mesh, parts, hair * longest);
    if (meet == PartsMeet::crossing) return meet;
    if (const long hidden = drop_hidden(mesh, parts, sides); hidden > 0)
        mended.emplace_back("dropped " + counted_parts(hidden) +
                            ", as they lie within others and hollow nothing out");
    return meet;
}

/// `why`: before what a refusal says.
Mesh filled(const Mesh& mesh, const SolidOptions& options, const std::string& why = "") {
    try {
        return fill_by_winding(mesh, options.fill_cells);
    } catch (const lod::Error& error) {
        lod::refuse_input(options.source, why + error.what());
    }
}

/// Says where a closed surface that no other crosses winds otherwise than once around what it
/// encloses: there it crosses itself, or folds over. All triangles are asked, of many some; small
/// folds, as scanned surfaces have them, go unsaid.
void remark_on_folds(const Mesh& mesh, const Point& moved, std::vector<std::string>& mended) {
    constexpr std::size_t most_asked = 4096;
    constexpr double small = 1e-3;  // of the surface
    const MeshDistance distance(mesh, InsideRule::winding);
    const std::size_t step = 1 + mesh.triangles.size() / most_asked;
    double area = 0;
    double folded = 0;
    double largest = 0;
    std::string where;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
        const Point a = mesh.corner(t, 0);
        const double own = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
        if (!(own > 0)) continue;
        area += own;
        const Sides side = sides_at(distance, mesh, t, 1e-5 * std::sqrt(own));
        if (!side.clear() || (!side.inside_out() && !side.hidden())) continue;
        if (side != sides_at(distance, mesh, t, 1e-7 * std::sqrt(own))) continue;
        folded += own;
        if (own <= largest) continue;
        largest = own;
        where = place_in_words((a + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3 + moved) +
                ": what it encloses there " +
                (side.inside_out() ? "is taken from the volume" : "counts twice");
    }
    if (folded > small * area)
        mended.emplace_back("its surface crosses itself or folds over, as near " + where +
                            ", in the centre and the inertia, too; divide or unite it there");
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
    const bool all_doubled = doubled > 0 && doubled == static_cast<int>(mesh.triangles.size());
    turn_alike(mesh, solid.mended);
    if (const int walls = drop_inner_walls(mesh); walls > 0) {
        drop_unused_vertices(mesh);
        solid.mended.emplace_back("dropped " + counted(walls, "triangle") +
                                  " that lie back to back within the solid");
    }
    const BadEdges bad = find_bad_edges(mesh);
    const std::string sides =
        all_doubled ? "its faces are doubled, each is there twice, turned both ways; " : "";
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

    check_parts(mesh, moved, options.source, solid.mended);
    const PartsMeet meet = turn_outwards(mesh, solid.mended);
    if (meet != PartsMeet::crossing) remark_on_folds(mesh, moved, solid.mended);
    Integrals of = integrate(mesh);
    const double longest = bounding_box(mesh).size().maxCoeff();
    if (!(of.volume > 1e-12 * longest * longest * longest))
        lod::refuse_input(options.source, why_no_volume(mesh, moved));
    // Where surfaces touch or cross, the nearest one does not tell the inside.
    if (meet != PartsMeet::apart) solid.inside_rule = InsideRule::winding;
    if (meet == PartsMeet::crossing) {
        of = integrate(filled(mesh, options, "its parts cross each other, so it was "));
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
