#include "lodlab/viz/draw/corner_normals.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/viz/figure/camera.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr std::size_t few = 128;  ///< faces round a vertex, each compared with each
constexpr int cells_a_side = 8;   ///< of a cube of directions
constexpr std::size_t cells = 6 * cells_a_side * cells_a_side;  ///< a face compares with no more

struct Direction {
    Vector3 normal = Vector3::Zero();
    double length = 0;
};

/// The cell of a cube about the origin that a direction passes. Requires: not zero.
std::size_t cell_of(const Vector3& v) {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::abs(v[other]) > std::abs(v[axis])) axis = other;
    int cell = 2 * axis + (v[axis] < 0);
    for (int other = 1; other < 3; ++other) {
        const double share = 0.5 + 0.5 * v[(axis + other) % 3] / std::abs(v[axis]);
        cell = cells_a_side * cell +
               std::min(cells_a_side - 1, static_cast<int>(cells_a_side * share));
    }
    return static_cast<std::size_t>(cell);
}

/// The sums of the directions in each cell, in the order in which cells first come.
std::vector<Direction> gathered(const std::vector<Direction>& faces) {
    std::array<std::size_t, cells> place{};  // counted from 1
    std::vector<Direction> sums;
    for (const Direction& face : faces) {
        if (face.length == 0) continue;
        std::size_t& known = place[cell_of(face.normal)];
        if (known == 0) {
            sums.emplace_back();
            known = sums.size();
        }
        sums[known - 1].normal += face.normal;
    }
    for (Direction& sum : sums) sum.length = sum.normal.norm();
    return sums;
}

Point3 mean_normal(const Direction& own, const std::vector<Direction>& others) {
    Vector3 sum = Vector3::Zero();
    for (const Direction& other : others)
        if (turn_little(own.normal, own.length, other.normal, other.length)) sum += other.normal;
    const double length = sum.norm();
    return point3(length > 0 ? Vector3(sum / length) : Vector3::UnitY());
}

}  // namespace

CornerNormals corner_normals(const lod3d::Mesh& mesh, std::span<const Vector3> faces) {
    std::vector<std::vector<std::size_t>> corners(mesh.vertices.size());  // round each vertex
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            corners[lod::at(mesh.triangles[t][k])].push_back(3 * t + k);
    CornerNormals result;
    result.of.resize(mesh.triangles.size());
    std::vector<Direction> own;
    for (const std::vector<std::size_t>& round : corners) {
        own.clear();
        for (const std::size_t corner : round)
            own.push_back({faces[corner / 3], faces[corner / 3].norm()});
        const std::vector<Direction> others = round.size() > few ? gathered(own) : own;
        for (std::size_t i = 0; i < round.size(); ++i)
            result.of[round[i] / 3][round[i] % 3] = mean_normal(own[i], others);
        result.compared += round.size() * others.size();
    }
    return result;
}

}  // namespace viz
