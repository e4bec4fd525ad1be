#include "lodlab/lod3d/solid/generators.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod3d {
namespace {

constexpr double turn = 2 * std::numbers::pi;

using Values = std::span<const double>;

std::int32_t add_vertex(Mesh& mesh, const Point& p) {
    mesh.vertices.push_back(p);
    return static_cast<std::int32_t>(mesh.vertices.size()) - 1;
}

/// Corners anticlockwise seen from outside.
void add_quad(Mesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// Point (radius, angle, height) about the z axis.
Point round_z(double radius, double angle, double height) {
    const lod::SineCosine of = lod::sine_cosine(angle);
    return {radius * of.cosine, radius * of.sine, height};
}

/// The cells of a grid that `is_in` accepts, as one solid; its faces are the grid's.
template <typename IsIn>
Mesh blocks(const std::vector<double>& xs, const std::vector<double>& ys,
            const std::vector<double>& zs, const IsIn& is_in) {
    const std::array<const std::vector<double>*, 3> at{&xs, &ys, &zs};
    const auto filled = [&](std::array<int, 3> cell) {
        for (std::size_t d = 0; d < 3; ++d)
            if (cell[d] < 0 || cell[d] + 1 >= static_cast<int>(at[d]->size())) return false;
        return is_in(cell[0], cell[1], cell[2]);
    };
    Mesh mesh;
    std::map<std::array<int, 3>, std::int32_t> number;
    const auto vertex = [&](const std::array<int, 3>& i) {
        const auto [found, fresh] = number.try_emplace(i, 0);
        if (fresh)
            found->second = add_vertex(
                mesh, {xs[static_cast<std::size_t>(i[0])], ys[static_cast<std::size_t>(i[1])],
                       zs[static_cast<std::size_t>(i[2])]});
        return found->second;
    };
    const auto add_face = [&](std::array<int, 3> cell, std::size_t axis, int side) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        std::array<std::array<int, 3>, 4> corner;
        for (auto& c : corner) c = cell, c[axis] += side;
        ++corner[side ? 1 : 3][u];
        ++corner[2][u];
        ++corner[2][v];
        ++corner[side ? 3 : 1][v];
        // One after the other: the order of arguments is the compiler's.
        std::array<std::int32_t, 4> ends{};
        for (std::size_t k = 0; k < 4; ++k) ends[k] = vertex(corner[k]);
        add_quad(mesh, ends[0], ends[1], ends[2], ends[3]);
    };
    for (int x = 0; x + 1 < static_cast<int>(xs.size()); ++x)
        for (int y = 0; y + 1 < static_cast<int>(ys.size()); ++y)
            for (int z = 0; z + 1 < static_cast<int>(zs.size()); ++z) {
                const std::array<int, 3> cell{x, y, z};
                if (!filled(cell)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (int side : {0, 1}) {
                        std::array<int, 3> beside = cell;
                        beside[axis] += side ? 1 : -1;
                        if (!filled(beside)) add_face(cell, axis, side);
                    }
            }
    return mesh;
}

Mesh solid_box(Values v) {
    return blocks({-v[0] / 2, v[0] / 2}, {-v[1] / 2, v[1] / 2}, {-v[2] / 2, v[2] / 2},
                  [](int, int, int) { return true; });
}

Mesh solid_l(Values v) {
    const double arm = v[0];
    return blocks({0, arm, 1}, {0, arm, 1}, {-arm / 2, arm / 2},
                  [](int x, int y, int) { return x == 0 || y == 0; });
}

Mesh solid_cross(Values v) {
    const std::vector<double> at{-0.5, -v[0] / 2, v[0] / 2, 0.5};
    return blocks(at, at, at, [](int x, int y, int z) {
        return (x == 1) + (y == 1) + (z == 1) >= 2;  // the bars along the three axes
    });
}

Mesh solid_tetrahedron(Values) {
    const double h = 0.5;
    return {{{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// A round of `count` vertices; next_to(i) wraps.
struct Round {
    std::int32_t first = 0;
    std::int32_t count = 0;
    [[nodiscard]] std::int32_t at(std::int32_t i) const { return first + i % count; }
};

/// Quads between two rounds; `upper` lies where a right-handed turn through `lower` points.
void join(Mesh& mesh, const Round& lower, const Round& upper) {
    for (std::int32_t i = 0; i < lower.count; ++i)
        add_quad(mesh, lower.at(i), lower.at(i + 1), upper.at(i + 1), upper.at(i));
}

/// Triangles from a round to one vertex.
void close_round(Mesh& mesh, const Round& round, std::int32_t tip) {
    for (std::int32_t i = 0; i < round.count; ++i)
        mesh.triangles.push_back({round.at(i), round.at(i + 1), tip});
}

Round add_round(Mesh& mesh, const std::vector<Point>& points) {
    const Round round{static_cast<std::int32_t>(mesh.vertices.size()),
                      static_cast<std::int32_t>(points.size())};
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
    return round;
}

Mesh solid_rod(Values v) {
    constexpr int sides = 48;
    const auto round_at = [&](double height) {
        std::vector<Point> points;
        for (int i = 0; i < sides; ++i) {
            const Point p = round_z(v[1], turn * i / sides, height);
            points.emplace_back(p.z(), p.x(), p.y());  // along x
        }
        return points;
    };
    Mesh mesh;
    const Round low = add_round(mesh, round_at(-v[0] / 2));
    const Round high = add_round(mesh, round_at(v[0] / 2));
    join(mesh, low, high);
    close_round(mesh, high, add_vertex(mesh, {v[0] / 2, 0, 0}));
    close_round(mesh, low, add_vertex(mesh, {-v[0] / 2, 0, 0}));
    for (auto t = mesh.triangles.end() - sides; t != mesh.triangles.end(); ++t)
        std::swap((*t)[0], (*t)[1]);  // the low end looks the other way
    return mesh;
}

/// An icosahedron whose triangles are cut in four `rounds` times, on the unit sphere.
Mesh unit_ball(int rounds) {
    const double g = std::numbers::phi;
    Mesh mesh{{{-1, g, 0},
               {1, g, 0},
               {-1, -g, 0},
               {1, -g, 0},
               {0, -1, g},
               {0, 1, g},
               {0, -1, -g},
               {0, 1, -g},
               {g, 0, -1},
               {g, 0, 1},
               {-g, 0, -1},
               {-g, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (Point& p : mesh.vertices) p.normalize();
    for (int round = 0; round < rounds; ++round) {
        std::map<std::array<std::int32_t, 2>, std::int32_t> middles;
        const auto middle = [&](std::int32_t i, std::int32_t j) {
            const auto [found, fresh] = middles.try_emplace({std::min(i, j), std::max(i, j)}, 0);
            if (fresh)
                found->second = add_vertex(mesh, (mesh.vertices[static_cast<std::size_t>(i)] +
                                                  mesh.vertices[static_cast<std::size_t>(j)])
                                                     .normalized());
            return found->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::int32_t ab = middle(a, b);
            const std::int32_t bc = middle(b, c);
            const std::int32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

Mesh solid_ball(Values v) {
    Mesh mesh = unit_ball(static_cast<int>(v[0]));
    for (Point& p : mesh.vertices) p *= 0.5;
    return mesh;
}

/// A ball whose radius carries waves of random directions; it stays star-shaped.
Mesh solid_blob(Values v) {
    constexpr int waves = 12;
    lod::Random random(static_cast<std::uint64_t>(v[0]));
    std::array<Point, waves> direction;
    std::array<double, waves> phase;
    for (std::size_t k = 0; k < waves; ++k) {
        Point p;  // uniform in the ball, so that long and short waves both come
        do
            for (int d = 0; d < 3; ++d) p[d] = random.next(-1, 1);
        while (p.squaredNorm() > 1);
        direction[k] = 5 * p;
        phase[k] = random.next(0, turn);
    }
    Mesh mesh = unit_ball(4);
    for (Point& p : mesh.vertices) {
        double height = 0;
        for (std::size_t k = 0; k < waves; ++k)
            height += lod::sine_cosine(direction[k].dot(p) + phase[k]).sine;
        p *= std::max(1 + 0.18 * height, 0.3);
    }
    const Box box = bounding_box(mesh);
    const double size = (box.high - box.low).maxCoeff();
    for (Point& p : mesh.vertices) p /= size;
    return mesh;
}

/// A tube around a closed curve: centre(s) and an `up` across it, both over s in [0, 1).
template <typename Curve>
Mesh tube(double radius, int along, int around, const Curve& curve) {
    Mesh mesh;
    std::vector<Round> rounds;
    for (int i = 0; i < along; ++i) {
        const double s = static_cast<double>(i) / along;
        const auto [centre, up] = curve(s);
        const double h = 1e-4;
        const Point ahead = (curve(s + h).first - curve(s - h).first).normalized();
        const Point across = (up - up.dot(ahead) * ahead).normalized();
        const Point beside = ahead.cross(across);
        std::vector<Point> points;
        for (int k = 0; k < around; ++k) {
            const lod::SineCosine of = lod::sine_cosine(turn * k / around);
            points.push_back(centre + radius * (of.cosine * across + of.sine * beside));
        }
        rounds.push_back(add_round(mesh, points));
    }
    for (std::size_t i = 0; i < rounds.size(); ++i)
        join(mesh, rounds[i], rounds[(i + 1) % rounds.size()]);
    return mesh;
}

Mesh solid_ring(Values v) {
    const double minor = v[0];
    return tube(minor, static_cast<int>(v[1]), static_cast<int>(v[1]) / 2, [&](double s) {
        return std::pair(round_z(0.5 - minor, turn * s, 0), Point(0, 0, 1));
    });
}

Mesh solid_knot(Values v) {
    if (std::gcd(static_cast<int>(v[0]), static_cast<int>(v[1])) != 1)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the knot's P and Q share a factor, so its tube would run into itself");
    const double thickness = v[2];
    const double outer = 0.5 - thickness;
    return tube(thickness, 240, 16, [&](double s) {
        const lod::SineCosine small = lod::sine_cosine(v[1] * turn * s);
        const double wide = outer * 2 / 3;
        const double narrow = outer / 3;
        const Point centre =
            round_z(wide + narrow * small.cosine, v[0] * turn * s, narrow * small.sine);
        const Point up = round_z(small.cosine, v[0] * turn * s, small.sine);
        return std::pair(centre, up);
    });
}

/// Radius of a gear's outline at a share 0..1 of one tooth: land, flank, gap, flank.
double gear_radius(double share, double depth) {
    const double low = 0.5 * (1 - depth);
    if (share < 0.3) return 0.5;
    if (share < 0.5) return 0.5 + (low - 0.5) * (share - 0.3) / 0.2;
    if (share < 0.8) return low;
    return low + (0.5 - low) * (share - 0.8) / 0.2;
}

Mesh solid_gear(Values v) {
    constexpr int steps = 10;  // of a tooth; corners of the outline fall on steps
    const int count = steps * static_cast<int>(v[0]);
    const double half = v[3] / 2;
    const double bore = 0.5 * v[2];
    if (v[2] >= 1 - v[1])
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the gear's BORE reaches its teeth; give BORE below 1 - DEPTH");
    const auto round_at = [&](double height, bool outer) {
        std::vector<Point> points;
        for (int i = 0; i < count; ++i) {
            const double share = static_cast<double>(i % steps) / steps;
            points.push_back(
                round_z(outer ? gear_radius(share, v[1]) : bore, turn * i / count, height));
        }
        return points;
    };
    Mesh mesh;
    const Round low = add_round(mesh, round_at(-half, true));
    const Round high = add_round(mesh, round_at(half, true));
    join(mesh, low, high);
    if (bore > 0) {
        const Round inner_low = add_round(mesh, round_at(-half, false));
        const Round inner_high = add_round(mesh, round_at(half, false));
        join(mesh, high, inner_high);
        join(mesh, inner_high, inner_low);
        join(mesh, inner_low, low);
        return mesh;
    }
    close_round(mesh, high, add_vertex(mesh, {0, 0, half}));
    close_round(mesh, low, add_vertex(mesh, {0, 0, -half}));
    for (auto t = mesh.triangles.end() - count; t != mesh.triangles.end(); ++t)
        std::swap((*t)[0], (*t)[1]);
    return mesh;
}

}  // namespace

std::span<const Generator> generators() {
    static const std::vector<lod::Generator<Mesh>> all = {
        {"box",
         "a box",
         {{"WIDTH", "along x, m", 1, 1e-6, 1e6},
          {"HEIGHT", "along y, m", 0.5, 1e-6, 1e6},
          {"DEPTH", "along z, m", 0.5, 1e-6, 1e6}},
         solid_box},
        {"rod",
         "a round bar along x",
         {{"LENGTH", "m", 1, 1e-6, 1e6}, {"RADIUS", "m", 0.05, 1e-6, 1e6}},
         solid_rod},
        {"L",
         "two arms at a right angle",
         {{"ARM", "width of an arm, share of the whole", 0.3, 0.01, 0.99}},
         solid_l},
        {"cross",
         "three bars at right angles",
         {{"BAR", "width of a bar, share of its length", 0.25, 0.01, 0.99}},
         solid_cross},
        {"tetrahedron", "a regular tetrahedron in a cube", {}, solid_tetrahedron},
        {"ball",
         "a round ball",
         {{"ROUNDS", "how often 20 triangles are cut in four", 4, 0, 7, true}},
         solid_ball},
        {"ring",
         "a torus",
         {{"TUBE", "radius of the tube, m", 0.12, 0.01, 0.24},
          {"SIDES", "around the whole ring", 96, 6, 2000, true}},
         solid_ring},
        {"gear",
         "a toothed wheel",
         {{"TEETH", "number of teeth", 9, 3, 200, true},
          {"DEPTH", "of a tooth, share of the radius", 0.25, 0.01, 0.9},
          {"BORE", "radius of the hole, share of the radius; 0: none", 0, 0, 0.9},
          {"WIDTH", "thickness, m", 0.2, 1e-3, 1e3}},
         solid_gear},
        {"knot",
         "a tube tied in a torus knot",
         {{"P", "turns about the axis", 2, 1, 9, true},
          {"Q", "turns about the core", 3, 1, 9, true},
          {"TUBE", "radius of the tube, m", 0.06, 0.005, 0.08}},
         solid_knot},
        {"blob",
         "a rounded random body",
         {{"SEED", "same seed, same body", 1, 0, 4e9, true}},
         solid_blob},
    };
    return all;
}

bool names_generator(std::string_view spec) {
    return lod::find_generator(generators(), spec) != nullptr;
}

Solid generate(std::string_view spec) {
    return make_solid(std::string(spec), lod::make_from_spec(generators(), spec));
}

}  // namespace lod3d
