#include "lodlab/lod3d/solid/fill.hpp"

#include <algorithm>
#include <unordered_map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/mesh/distance.hpp"

namespace lod3d {
namespace {

/// Corner c of a cube: bit 0 along x, bit 1 along y, bit 2 along z.
using Tetrahedron = std::array<int, 4>;
/// The six tetrahedra of a cube along its main diagonal (Kuhn); those of neighbours fit together.
constexpr std::array<Tetrahedron, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marching {
  public:
    Marching(const Box& box, int cells, const std::function<bool(const Point&)>& inside)
        : inside_(inside) {
        const Point extent = box.high - box.low;
        step_ = extent.maxCoeff() / cells;
        for (int d = 0; d < 3; ++d)
            count_[static_cast<std::size_t>(d)] = static_cast<int>(extent[d] / step_) + 4;
        // Off the planes on which drawn shapes like to lie, and a cube wider than the box.
        low_ = box.low - step_ * Point(1.4142, 1.4021, 1.3939);
        sample();
    }

    Mesh run() {
        for (int z = 0; z + 1 < count_[2]; ++z) {
            lod::check_interrupted();
            for (int y = 0; y + 1 < count_[1]; ++y)
                for (int x = 0; x + 1 < count_[0]; ++x) cube(x, y, z);
        }
        return std::move(mesh_);
    }

  private:
    [[nodiscard]] Point place(int x, int y, int z) const { return low_ + step_ * Point(x, y, z); }
    [[nodiscard]] std::int64_t number(int x, int y, int z) const {
        return x + static_cast<std::int64_t>(count_[0]) *
                       (y + static_cast<std::int64_t>(count_[1]) * z);
    }

    void sample() {
        is_in_.reserve(static_cast<std::size_t>(number(0, 0, count_[2])));
        for (int z = 0; z < count_[2]; ++z) {
            lod::check_interrupted();
            for (int y = 0; y < count_[1]; ++y)
                for (int x = 0; x < count_[0]; ++x) {
                    const bool rim = x == 0 || y == 0 || z == 0 || x == count_[0] - 1 ||
                                     y == count_[1] - 1 || z == count_[2] - 1;
                    is_in_.push_back(!rim && inside_(place(x, y, z)));
                }
        }
    }

    void cube(int x, int y, int z) {
        std::array<std::int64_t, 8> corner;
        int within = 0;
        for (int c = 0; c < 8; ++c) {
            corner[static_cast<std::size_t>(c)] =
                number(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
            within += is_in_[static_cast<std::size_t>(corner[static_cast<std::size_t>(c)])];
        }
        if (within == 0 || within == 8) return;
        for (const Tetrahedron& t : tetrahedra) {
            std::array<std::int64_t, 4> of;
            for (std::size_t k = 0; k < 4; ++k) of[k] = corner[static_cast<std::size_t>(t[k])];
            tetrahedron(of);
        }
    }

    void tetrahedron(std::array<std::int64_t, 4> v) {
        const auto behind = std::stable_partition(v.begin(), v.end(), [&](std::int64_t corner) {
            return is_in_[static_cast<std::size_t>(corner)];
        });
        const auto within = behind - v.begin();
        if (within == 1) triangle(v, {{{v[0], v[1]}, {v[0], v[2]}, {v[0], v[3]}}});
        if (within == 3) triangle(v, {{{v[0], v[3]}, {v[1], v[3]}, {v[2], v[3]}}});
        if (within != 2) return;
        triangle(v, {{{v[0], v[2]}, {v[0], v[3]}, {v[1], v[3]}}});
        triangle(v, {{{v[0], v[2]}, {v[1], v[3]}, {v[1], v[2]}}});
    }

    struct Edge {
        std::int64_t in;
        std::int64_t out;
    };
    /// Turned so that v[0] (inside) lies behind it and v[3] (outside) before it.
    void triangle(const std::array<std::int64_t, 4>& v, const std::array<Edge, 3>& edges) {
        std::array<Point, 3> middle;  // decides as well as the true vertices, and never degenerate
        for (std::size_t k = 0; k < 3; ++k)
            middle[k] = 0.5 * (place_of(edges[k].in) + place_of(edges[k].out));
        const Point normal = (middle[1] - middle[0]).cross(middle[2] - middle[0]);
        const bool turned = normal.dot(place_of(v[3]) - place_of(v[0])) < 0;
        mesh_.triangles.push_back(
            {vertex(edges[0]), vertex(edges[turned ? 2 : 1]), vertex(edges[turned ? 1 : 2])});
    }

    std::int32_t vertex(const Edge& edge) {
        const std::int64_t key = std::min(edge.in, edge.out) * 8 + direction(edge);
        const auto [at, fresh] =
            on_edge_.try_emplace(key, static_cast<std::int32_t>(mesh_.vertices.size()));
        if (fresh) mesh_.vertices.push_back(crossing(place_of(edge.in), place_of(edge.out)));
        return at->second;
    }

    /// 1 to 7: which of x, y and z the edge runs along.
    [[nodiscard]] int direction(const Edge& edge) const {
        const Point along = place_of(edge.out) - place_of(edge.in);
        int bits = 0;
        for (int d = 0; d < 3; ++d) bits |= (std::abs(along[d]) > step_ / 2) << d;
        return bits;
    }

    [[nodiscard]] Point crossing(Point in, Point out) const {
        for (int halving = 0; halving < 8; ++halving) {
            const Point middle = 0.5 * (in + out);
            (inside_(middle) ? in : out) = middle;
        }
        return 0.5 * (in + out);
    }

    [[nodiscard]] Point place_of(std::int64_t i) const {
        return place(static_cast<int>(i % count_[0]), static_cast<int>(i / count_[0] % count_[1]),
                     static_cast<int>(i / count_[0] / count_[1]));
    }

    const std::function<bool(const Point&)>& inside_;
    Point low_;
    double step_ = 0;
    std::array<int, 3> count_{};
    std::vector<char> is_in_;
    std::unordered_map<std::int64_t, std::int32_t> on_edge_;
    Mesh mesh_;
};

}  // namespace

Mesh enclose(const Box& box, int cells, const std::function<bool(const Point&)>& inside) {
    return Marching(box, cells, inside).run();
}

Mesh fill_by_winding(const Mesh& mesh, int cells) {
    const MeshDistance distance(mesh, InsideRule::winding);
    Mesh filled =
        enclose(bounding_box(mesh), cells, [&](const Point& p) { return distance.inside(p); });
    if (filled.triangles.empty())
        throw lod::Error(lod::ErrorKind::input_refused,
                         "filled by winding number, on a grid of " + std::to_string(cells) +
                             " cells, the surface encloses nothing: it is too thin or too open, or "
                             "its two sides cancel each other; close it, and keep its outer side "
                             "only");
    return filled;
}

}  // namespace lod3d
