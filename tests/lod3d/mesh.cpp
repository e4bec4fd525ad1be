#include "lodlab/lod3d/mesh/mesh.hpp"

#include <numbers>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"
#include "tests/lod3d/random_pose.hpp"

using namespace lod3d;

namespace {

constexpr double pi = std::numbers::pi;

Mesh made(std::string_view spec) {
    return lod::make_from_spec(generators(), spec);
}

Mesh moved(Mesh mesh, const lod::Matrix<3>& rotation, const Point& by) {
    for (Point& p : mesh.vertices) p = rotation * p + by;
    return mesh;
}

}  // namespace

TEST_CASE("a box has the integrals of a box, wherever it stands", "[mesh]") {
    // V = abc, I = V/12 diag(b^2 + c^2, c^2 + a^2, a^2 + b^2)
    const Point at(5, -7, 11);
    const Integrals of = integrate(moved(made("box:2,3,4"), lod::Matrix<3>::Identity(), at));
    CHECK(of.volume == Approx(24).epsilon(1e-14));
    CHECK(of.centroid.isApprox(at, 1e-14));
    const lod::Matrix<3> expected = Point(2 * 25, 2 * 20, 2 * 13).asDiagonal();
    CHECK((of.inertia - expected).cwiseAbs().maxCoeff() < 1e-11);
}

TEST_CASE("a corner tetrahedron has the integrals of calculus", "[mesh]") {
    // Corners 0, e1, e2, e3: V = 1/6, centroid 1/4, about the origin int x^2 = 1/60, int xy =
    // 1/120.
    const Mesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
    const Integrals of = integrate(corner);
    CHECK(of.volume == Approx(1.0 / 6).epsilon(1e-14));
    CHECK(of.centroid.isApprox(Point::Constant(0.25), 1e-14));
    const double diagonal = 2 * (1.0 / 60 - 1.0 / 96);  // int y^2 + z^2, shifted to the centroid
    const double beside = -(1.0 / 120 - 1.0 / 96);
    lod::Matrix<3> expected = lod::Matrix<3>::Constant(beside);
    for (int i = 0; i < 3; ++i) expected(i, i) = diagonal;
    CHECK((of.inertia - expected).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("finer balls come nearer to the ball's integrals, by the square of the edge", "[mesh]") {
    const double volume = pi / 6;  // radius 1/2
    const double inertia = 0.4 * volume * 0.25;
    double last_volume_error = 1;
    double last_inertia_error = 1;
    for (const char* spec : {"ball:2", "ball:3", "ball:4", "ball:5"}) {
        const Integrals of = integrate(made(spec));
        const double volume_error = 1 - of.volume / volume;
        const double inertia_error = 1 - of.inertia(0, 0) / inertia;
        CHECK(volume_error > 0);  // inscribed
        if (last_volume_error < 1) {
            CHECK(last_volume_error / volume_error == Approx(4).epsilon(0.05));
            CHECK(last_inertia_error / inertia_error == Approx(4).epsilon(0.05));
        }
        last_volume_error = volume_error;
        last_inertia_error = inertia_error;
    }
    CHECK(last_volume_error < 2e-3);
}

TEST_CASE("finer rings come nearer to the torus's integrals", "[mesh]") {
    // Radii R and r: V = 2 pi^2 R r^2, I about the axis V (R^2 + 3 r^2 / 4), across V (R^2/2 + 5
    // r^2/8)
    const double r = 0.12;
    const double R = 0.5 - r;
    const double volume = 2 * pi * pi * R * r * r;
    double last = 1;
    for (const char* spec : {"ring:0.12,40", "ring:0.12,80", "ring:0.12,160", "ring:0.12,320"}) {
        const Integrals of = integrate(made(spec));
        const double error = 1 - of.volume / volume;
        if (last < 1) CHECK(last / error == Approx(4).epsilon(0.05));
        last = error;
        CHECK(of.inertia(2, 2) / of.volume == Approx(R * R + 0.75 * r * r).epsilon(3 * error));
        CHECK(of.inertia(0, 0) / of.volume == Approx(R * R / 2 + 0.625 * r * r).epsilon(3 * error));
    }
    CHECK(last < 1e-3);
}

TEST_CASE("the inertia turns with the mesh as R I R^T", "[mesh]") {
    lod::Random random(3);
    const Mesh blob = made("blob:5");
    const Integrals before = integrate(blob);
    for (int i = 0; i < 20; ++i) {
        const lod::Matrix<3> R = random_rotation(random);
        const Integrals after = integrate(moved(blob, R, {1, 2, 3}));
        CHECK(after.volume == Approx(before.volume).epsilon(1e-12));
        CHECK((after.centroid - (R * before.centroid + Point(1, 2, 3))).norm() < 1e-13);
        CHECK((after.inertia - R * before.inertia * R.transpose()).norm() <
              1e-12 * before.inertia.norm());
    }
}

TEST_CASE("an inside-out mesh has the negative volume", "[mesh]") {
    Mesh gear = made("gear");
    const double volume = integrate(gear).volume;
    CHECK(volume > 0);
    flip(gear);
    CHECK(integrate(gear).volume == Approx(-volume).epsilon(1e-14));
}

TEST_CASE("a mesh that is split has its parts' triangles, and each vertex once a part", "[mesh]") {
    Mesh two = made("tetrahedron");
    two.vertices.push_back({9, 9, 9});  // used by none
    const Mesh ring = made("ring");
    const auto first = static_cast<std::int32_t>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), ring.vertices.begin(), ring.vertices.end());
    for (Triangle t : ring.triangles) {
        for (std::int32_t& v : t) v += first;
        two.triangles.push_back(t);
    }
    const Parts parts = find_parts(two);
    REQUIRE(parts.count == 2);
    const std::vector<Mesh> split_two = split(two, parts);
    REQUIRE(split_two.size() == 2);
    CHECK(split_two[0].vertices.size() == 4);
    CHECK(split_two[1].vertices.size() == ring.vertices.size());
    for (std::size_t part = 0, whole = 0; part < 2; ++part)
        for (std::size_t t = 0; t < split_two[part].triangles.size(); ++t, ++whole)
            for (int k = 0; k < 3; ++k) CHECK(split_two[part].corner(t, k) == two.corner(whole, k));
}

TEST_CASE("welding joins a soup of triangles", "[mesh]") {
    const Mesh ring = made("ring");
    Mesh soup;
    for (std::size_t t = 0; t < ring.triangles.size(); ++t) {
        const auto first = static_cast<std::int32_t>(soup.vertices.size());
        for (int k = 0; k < 3; ++k) soup.vertices.push_back(ring.corner(t, k));
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    CHECK(find_bad_edges(soup).open == static_cast<int>(soup.vertices.size()));
    weld(soup);
    CHECK(soup.vertices.size() == ring.vertices.size());
    CHECK(find_bad_edges(soup).none());
    CHECK(integrate(soup).volume == Approx(integrate(ring).volume).epsilon(1e-12));
}

TEST_CASE("welding drops collapsed, repeated and unused things, and says how many", "[mesh]") {
    Mesh mesh = made("tetrahedron");
    mesh.vertices.push_back({0.5, 0.5, 0.5});  // a twin of vertex 0
    mesh.vertices.push_back({9, 9, 9});        // used by none
    mesh.triangles.push_back({0, 4, 1});       // collapses
    mesh.triangles.push_back({1, 2, 4});       // repeats {0, 1, 2}
    const Welded welded = weld(mesh);
    CHECK(welded.vertices == 2);
    CHECK(welded.collapsed == 1);
    CHECK(welded.duplicates == 1);
    CHECK(mesh.triangles.size() == 4);
    CHECK(find_bad_edges(mesh).none());
}

TEST_CASE("bad edges are counted by their kind", "[mesh]") {
    Mesh open = made("box");
    open.triangles.pop_back();
    CHECK(find_bad_edges(open).open == 3);
    Mesh reversed = made("box");
    std::swap(reversed.triangles[0][1], reversed.triangles[0][2]);
    CHECK(find_bad_edges(reversed).reversed == 3);
    Mesh crowded = made("tetrahedron");  // a fin on one of its edges
    crowded.vertices.push_back({2, 0, 0});
    crowded.triangles.push_back({0, 1, 4});
    CHECK(find_bad_edges(crowded).crowded == 1);
    CHECK(find_bad_edges(crowded).open == 2);
}

TEST_CASE("triangles turned at random are made to agree again", "[mesh]") {
    lod::Random random(11);
    Mesh knot = made("knot");
    const double volume = integrate(knot).volume;
    for (Triangle& t : knot.triangles)
        if (random.next() < 0.3) std::swap(t[1], t[2]);
    CHECK(find_bad_edges(knot).reversed > 100);
    orient(knot);
    CHECK(find_bad_edges(knot).none());
    CHECK(std::abs(integrate(knot).volume) == Approx(volume).epsilon(1e-12));
}

TEST_CASE("a one-sided surface keeps edges that disagree", "[mesh]") {
    Mesh strip;  // a Moebius strip
    constexpr int steps = 12;
    for (int i = 0; i < steps; ++i) {
        const double angle = 2 * pi * i / steps;
        const Point out(std::cos(angle), std::sin(angle), 0);
        const Point across = std::cos(angle / 2) * out + std::sin(angle / 2) * Point(0, 0, 1);
        strip.vertices.push_back(out + 0.3 * across);
        strip.vertices.push_back(out - 0.3 * across);
    }
    for (std::int32_t i = 0; i < steps; ++i) {
        std::int32_t next = 2 * ((i + 1) % steps);
        std::int32_t next_other = next + 1;
        if (i + 1 == steps) std::swap(next, next_other);
        strip.triangles.push_back({2 * i, 2 * i + 1, next});
        strip.triangles.push_back({2 * i + 1, next_other, next});
    }
    orient(strip);
    CHECK(find_bad_edges(strip).reversed > 0);
}

TEST_CASE("parts are told apart by shared edges", "[mesh]") {
    Mesh two = made("box");
    const Mesh other = made("ball:1");
    const auto first = static_cast<std::int32_t>(two.vertices.size());
    for (const Point& p : other.vertices) two.vertices.push_back(p + Point(3, 0, 0));
    for (const Triangle& t : other.triangles)
        two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Parts parts = find_parts(two);
    CHECK(parts.count == 2);
    CHECK(parts.of_triangle.front() == 0);
    CHECK(parts.of_triangle.back() == 1);
}
