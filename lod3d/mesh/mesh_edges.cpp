// Edges of a mesh: which are bad, which triangles they join, which way those are turned.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "lodlab/lod3d/mesh/mesh_sides.hpp"

#include "lodlab/core/base/lists.hpp"

namespace lod3d {
namespace {

/// Sets that merge; each remembers whether its members are turned against its root.
class TurnedSets {
  public:
    explicit TurnedSets(std::size_t count) : parent_(count), turned_(count, 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    struct Member {
        std::int32_t root;
        bool turned;  ///< against the root
    };
    Member find(std::int32_t i) {
        std::int32_t root = i;
        bool turned = false;
        for (; parent_[lod::at(root)] != root; root = parent_[lod::at(root)])
            turned ^= static_cast<bool>(turned_[lod::at(root)]);
        bool left = turned;  // compress the path
        while (parent_[lod::at(i)] != root && i != root) {
            const std::int32_t next = parent_[lod::at(i)];
            const bool step = turned_[lod::at(i)];
            parent_[lod::at(i)] = root;
            turned_[lod::at(i)] = left;
            left ^= step;
            i = next;
        }
        return {root, turned};
    }

    /// Says that i and j are turned against each other, or alike. What contradicts is ignored.
    void join(std::int32_t i, std::int32_t j, bool against) {
        const Member a = find(i);
        const Member b = find(j);
        if (a.root == b.root) return;
        parent_[lod::at(b.root)] = a.root;
        turned_[lod::at(b.root)] = against ^ a.turned ^ b.turned;
    }

  private:
    std::vector<std::int32_t> parent_;
    std::vector<char> turned_;
};

}  // namespace

std::vector<MeshSide> sorted_sides(const Mesh& mesh) {
    std::vector<MeshSide> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t from = mesh.triangles[t][k];
            const std::int32_t to = mesh.triangles[t][(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t),
                             static_cast<std::int32_t>(k), from < to});
        }
    std::sort(sides.begin(), sides.end(), [](const MeshSide& a, const MeshSide& b) {
        return std::tie(a.low, a.high, a.triangle, a.place) <
               std::tie(b.low, b.high, b.triangle, b.place);
    });
    return sides;
}

BadEdges find_bad_edges(const Mesh& mesh) {
    BadEdges bad;
    each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        const BadEdges before = bad;
        const auto count = last - first;
        const auto upwards =
            std::count_if(first, last, [](const MeshSide& side) { return side.upwards; });
        if (count == 1)
            ++bad.open;
        else if (2 * upwards != count)
            ++(count == 2 ? bad.reversed : bad.crowded);
        else if (count > 2)
            ++bad.shared;
        if (before.none() && !bad.none()) bad.first = {first->low, first->high};
    });
    return bad;
}

int orient(Mesh& mesh) {
    TurnedSets sets(mesh.triangles.size());
    each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        if (last - first == 2)
            sets.join(first->triangle, (first + 1)->triangle,
                      first->upwards == (first + 1)->upwards);
    });
    std::vector<std::int32_t> members(mesh.triangles.size(), 0);
    std::vector<std::int32_t> turned(mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto member = sets.find(static_cast<std::int32_t>(t));
        ++members[static_cast<std::size_t>(member.root)];
        turned[static_cast<std::size_t>(member.root)] += member.turned;
    }
    int changed = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto member = sets.find(static_cast<std::int32_t>(t));
        const auto root = static_cast<std::size_t>(member.root);
        const bool most_are_turned = 2 * turned[root] > members[root];
        if (member.turned == most_are_turned) continue;
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++changed;
    }
    return changed;
}

Parts find_parts(const Mesh& mesh) {
    TurnedSets sets(mesh.triangles.size());
    each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        for (auto side = first + 1; side < last; ++side)
            sets.join(first->triangle, side->triangle, false);
    });
    Parts parts;
    std::vector<std::int32_t> number(mesh.triangles.size(), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        auto& of_root =
            number[static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(t)).root)];
        if (of_root < 0) of_root = parts.count++;
        parts.of_triangle.push_back(of_root);
    }
    return parts;
}

std::vector<Mesh> split(const Mesh& mesh, const Parts& parts) {
    std::vector<Mesh> meshes(static_cast<std::size_t>(parts.count));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        meshes[static_cast<std::size_t>(parts.of_triangle[t])].triangles.push_back(
            mesh.triangles[t]);
    struct Numbered {
        std::size_t part = 0;  ///< counted from 1
        std::int32_t number = 0;
    };
    std::vector<Numbered> last(mesh.vertices.size());  // where a vertex was met last
    for (std::size_t part = 1; part <= meshes.size(); ++part) {
        Mesh& own = meshes[part - 1];
        for (Triangle& triangle : own.triangles)
            for (std::int32_t& corner : triangle) {
                const auto vertex = static_cast<std::size_t>(corner);
                if (last[vertex].part != part) {
                    last[vertex] = {part, static_cast<std::int32_t>(own.vertices.size())};
                    own.vertices.push_back(mesh.vertices[vertex]);
                }
                corner = last[vertex].number;
            }
    }
    return meshes;
}

}  // namespace lod3d
