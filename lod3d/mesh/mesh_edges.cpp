// Edges of a mesh: which are bad, which triangles they join, which way those are turned.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "lodlab/lod3d/mesh/mesh.hpp"

namespace lod3d {
namespace {

/// A side of a triangle, named by its lesser vertex first.
struct Side {
    std::int32_t low;
    std::int32_t high;
    std::int32_t triangle;
    bool upwards;  ///< the triangle passes it from low to high

    [[nodiscard]] bool same_edge(const Side& other) const {
        return low == other.low && high == other.high;
    }
};

/// All sides, those of one edge side by side.
std::vector<Side> sorted_sides(const Mesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& v = mesh.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t from = v[k];
            const std::int32_t to = v[(k + 1) % 3];
            sides.push_back(
                {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

/// Calls visit(first, last) for the sides of every edge.
template <typename Visit>
void each_edge(const std::vector<Side>& sides, const Visit& visit) {
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(),
                                       [&](const Side& side) { return !side.same_edge(*first); });
        visit(first, last);
        first = last;
    }
}

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
        for (; parent_[at(root)] != root; root = parent_[at(root)])
            turned ^= static_cast<bool>(turned_[at(root)]);
        bool left = turned;  // compress the path
        while (parent_[at(i)] != root && i != root) {
            const std::int32_t next = parent_[at(i)];
            const bool step = turned_[at(i)];
            parent_[at(i)] = root;
            turned_[at(i)] = left;
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
        parent_[at(b.root)] = a.root;
        turned_[at(b.root)] = against ^ a.turned ^ b.turned;
    }

  private:
    static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::vector<std::int32_t> parent_;
    std::vector<char> turned_;
};

}  // namespace

BadEdges find_bad_edges(const Mesh& mesh) {
    BadEdges bad;
    each_edge(sorted_sides(mesh), [&](auto first, auto last) {
        const BadEdges before = bad;
        const auto count = last - first;
        const auto upwards =
            std::count_if(first, last, [](const Side& side) { return side.upwards; });
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

}  // namespace lod3d
