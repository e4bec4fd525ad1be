#include "lodlab/lod3d/solid/solid.hpp"

#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "tests/catch.hpp"

using namespace lod3d;

namespace {

Mesh made(std::string_view spec) {
    return lod::make_from_spec(generators(), spec);
}

void append(Mesh& mesh, const Mesh& other, const Point& by, double scale = 1) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Point& p : other.vertices) mesh.vertices.push_back(scale * p + by);
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

std::string refusal(Mesh mesh, const SolidOptions& options = {}) {
    try {
        static_cast<void>(make_solid("it", std::move(mesh), options));
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a solid stands on its centre of mass", "[solid]") {
    Mesh box = made("box:2,1,1");
    for (Point& p : box.vertices) p += Point(10, 20, 30);
    const Solid solid = make_solid("it", box);
    CHECK(solid.centroid.isApprox(Point(10, 20, 30), 1e-14));
    CHECK(integrate(solid.mesh).centroid.norm() < 1e-14);
    CHECK(solid.volume == Approx(2));
    CHECK(solid.second_moment(0, 0) == Approx(2.0 / 12 * 2));
    CHECK(solid.mended.empty());
}

TEST_CASE("numbers that are none are refused and counted", "[solid]") {
    Mesh nan = made("box");
    nan.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    nan.vertices[5].x() = 1e300;
    CHECK_THAT(refusal(nan), lodtest::contains("it: 2 of 8 vertices are not finite"));
    Mesh astray = made("box");
    astray.triangles[2][1] = 8;
    astray.triangles[4][0] = -1;
    CHECK_THAT(refusal(astray), lodtest::contains("2 vertex numbers are out of range"));
    CHECK_THAT(refusal({}), lodtest::contains("no triangles"));
}

TEST_CASE("meshes without volume are refused, each with its reason", "[solid]") {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    CHECK_THAT(refusal(one), lodtest::contains("3 edges with one triangle only"));
    const Mesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
    CHECK_THAT(refusal(point), lodtest::contains("two equal corners"));
    Mesh flat = made("box");
    for (Point& p : flat.vertices) p.z() = 0;
    CHECK(refusal(flat) != "accepted");
    Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};  // both sides of one
    CHECK_THAT(refusal(sheet), lodtest::contains("its faces are doubled"));
}

TEST_CASE("an open mesh is refused with its edges, or filled when asked", "[solid]") {
    Mesh open = made("ball:3");
    const double volume = integrate(open).volume;
    open.triangles.erase(open.triangles.begin() + 100, open.triangles.begin() + 103);
    CHECK_THAT(refusal(open),
               lodtest::contains("edges with one triangle only") && lodtest::contains("fill"));
    const Solid filled = make_solid("it", open, {.fill = true, .fill_cells = 48});
    CHECK(filled.approximate);
    CHECK(filled.volume == Approx(volume).epsilon(0.01));
    CHECK(find_bad_edges(filled.mesh).none());
    CHECK_FALSE(filled.mended.empty());
}

TEST_CASE("zero-area triangles in a closed mesh do no harm", "[solid]") {
    // A point on an edge of the box, joined by a sliver to the neighbour that does not know of it.
    Mesh box = made("box:1,1,1");
    const Triangle t = box.triangles[0];
    const auto middle = static_cast<std::int32_t>(box.vertices.size());
    box.vertices.push_back(0.5 * (box.corner(0, 0) + box.corner(0, 1)));
    box.triangles[0] = {middle, t[1], t[2]};
    box.triangles.push_back({t[0], middle, t[2]});
    box.triangles.push_back({t[0], t[1], middle});  // the sliver
    const Solid solid = make_solid("it", box);
    CHECK(solid.volume == Approx(1).epsilon(1e-14));
    CHECK(MeshDistance(solid.mesh).inside(Point(0.49, 0.49, 0.49)));
}

TEST_CASE("an inside-out mesh is turned, and that is said", "[solid]") {
    Mesh knot = made("knot");
    const double volume = integrate(knot).volume;
    flip(knot);
    const Solid solid = make_solid("it", knot);
    CHECK(solid.volume == Approx(volume).epsilon(1e-12));
    REQUIRE(solid.mended.size() == 1);
    CHECK_THAT(solid.mended[0], lodtest::contains("inside-out"));
}

TEST_CASE("two parts side by side make one exact solid, even if one is inside-out", "[solid]") {
    Mesh two = made("box:1,1,1");
    Mesh other = made("box:1,1,1");
    flip(other);
    append(two, other, {3, 0, 0});
    const Solid solid = make_solid("it", two);
    CHECK(solid.volume == Approx(2).epsilon(1e-14));
    CHECK(solid.centroid.isApprox(Point(1.5, 0, 0), 1e-14));
    // Two cubes: about x 2/6, about y and z 2 (1/6 + 1.5^2).
    CHECK(solid.second_moment(0, 0) == Approx(2.0 / 6).epsilon(1e-13));
    CHECK(solid.second_moment(1, 1) == Approx(2 * (1.0 / 6 + 2.25)).epsilon(1e-13));
    CHECK_FALSE(solid.approximate);
}

TEST_CASE("a shell that faces its hull is a cavity, also when all is inside-out", "[solid]") {
    Mesh hollow = made("box:1,1,1");
    Mesh inner = made("box:1,1,1");
    flip(inner);
    append(hollow, inner, Point::Zero(), 0.5);
    CHECK(make_solid("it", hollow).volume == Approx(1 - 0.125).epsilon(1e-14));
    flip(hollow);
    const Solid turned = make_solid("it", hollow);
    CHECK(turned.volume == Approx(1 - 0.125).epsilon(1e-14));
    CHECK_FALSE(MeshDistance(turned.mesh).inside(Point::Zero()));
    CHECK(MeshDistance(turned.mesh).inside(Point(0.4, 0, 0)));
}

TEST_CASE("a shell that does not face its hull adds nothing, also when all is inside-out",
          "[solid]") {
    for (const bool turned : {false, true}) {
        CAPTURE(turned);
        Mesh full = made("box:1,1,1");
        append(full, made("box:1,1,1"), {0.1, 0, 0}, 0.5);
        append(full, made("box:1,1,1"), {3, 0, 0});
        if (turned) flip(full);
        const Solid solid = make_solid("it", full);
        CHECK(solid.volume == Approx(2).epsilon(1e-14));
        CHECK(solid.centroid.isApprox(Point(1.5, 0, 0), 1e-14));
        CHECK_FALSE(solid.approximate);
        REQUIRE(solid.mended.size() == (turned ? 2 : 1));
        CHECK_THAT(solid.mended.back(), lodtest::contains("dropped 1 part of 3"));
        if (turned) CHECK_THAT(solid.mended[0], lodtest::contains("turned 3 parts of 3"));
    }
}

TEST_CASE("a surface that crosses itself is said to, with the place", "[solid]") {
    // A prism over a bow tie: its loops enclose 3/8 m^2 and 27/8 m^2, turned against each other.
    const auto prism = [](const std::vector<lod::Vector<2>>& base) {
        Mesh mesh;
        const auto n = static_cast<std::int32_t>(base.size());
        for (const double z : {0.0, 4.0})
            for (const auto& p : base) mesh.vertices.push_back(Point(p.x(), p.y(), z));
        for (std::int32_t i = 0; i < n; ++i) {
            const std::int32_t j = (i + 1) % n;
            mesh.triangles.push_back({i, j, j + n});
            mesh.triangles.push_back({i, j + n, i + n});
            if (i + 2 >= n) continue;
            mesh.triangles.push_back({0, i + 2, i + 1});
            mesh.triangles.push_back({n, n + i + 1, n + i + 2});
        }
        return mesh;
    };
    const Solid tie = make_solid("it", prism({{0, 0}, {3, 3}, {3, 0}, {0, 1}}));
    CHECK(tie.volume == Approx(4 * (27.0 - 3) / 8).epsilon(1e-12));
    CHECK_THAT(tie.mended.back(), lodtest::contains("crosses itself") &&
                                      lodtest::contains("is taken from the volume"));
    // Twice around a square: a star's way.
    const Solid twice = make_solid(
        "it",
        prism({{0, 0}, {2, 0}, {2, 2}, {0, 2.1}, {0.2, 0.2}, {1.8, 0.2}, {1.8, 1.8}, {0.1, 1.8}}));
    CHECK_THAT(twice.mended.back(), lodtest::contains("counts twice"));
    CHECK(make_solid("it", made("knot")).mended.empty());
}

TEST_CASE("a part that bounds nothing beside one that does is dropped if flat, else refused",
          "[solid]") {
    Mesh sheet{{{9, 0, 0}, {9, 1, 0}, {9, 1, 1}, {9, 0, 1}},
               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};  // by the other diagonal behind
    Mesh beside = made("box:1,1,1");
    append(beside, sheet, Point::Zero());
    const Solid solid = make_solid("it", beside);
    CHECK(solid.volume == Approx(1).epsilon(1e-14));
    CHECK_FALSE(solid.approximate);
    REQUIRE(solid.mended.size() == 1);
    CHECK_THAT(solid.mended[0], lodtest::contains("dropped 1 part of 2, flat"));

    for (const double thin : {1e-3, 1e-6}) {  // a wire is neither
        CAPTURE(thin);
        Mesh wired = made("box:1,1,1");
        Mesh wire = made("box:1,1,1");
        for (Point& p : wire.vertices) p = Point(p.x(), thin * p.y(), thin * p.z());
        append(wired, wire, {2, 0.3, 0.7});
        CHECK(make_solid("it", wired).volume == Approx(1 + thin * thin).epsilon(1e-12));
        CHECK(make_solid("it", wired).mended.empty());
    }

    // Sides of a box cut by one diagonal from without, and by the other from within.
    Mesh doubled;
    for (int corner = 0; corner < 8; ++corner)
        doubled.vertices.push_back(Point(corner & 1, corner >> 1 & 1, corner >> 2));
    for (const std::array<int, 4>& q : {std::array{0, 2, 3, 1},
                                        {4, 5, 7, 6},
                                        {0, 1, 5, 4},
                                        {2, 6, 7, 3},
                                        {0, 4, 6, 2},
                                        {1, 3, 7, 5}})
        for (const Triangle& t : {Triangle{q[0], q[1], q[2]}, Triangle{q[0], q[2], q[3]},
                                  Triangle{q[0], q[3], q[1]}, Triangle{q[1], q[3], q[2]}})
            doubled.triangles.push_back(t);
    append(doubled, made("box:1,1,1"), {5, 0, 0});
    for (const bool fill : {false, true})
        CHECK_THAT(
            refusal(doubled, {.fill = fill}),
            lodtest::contains("it: one of its 2 parts, which holds (0, 0, 0), bounds no volume") &&
                lodtest::contains("doubled"));
}

TEST_CASE("a cavity that touches the hull from within, by a face or three, stays exact",
          "[solid]") {
    for (const Point& at : {Point(0.25, 0, 0), Point(0.25, -0.25, 0), Point(0.25, 0.25, -0.25)}) {
        CAPTURE(at);
        Mesh hollow = made("box:1,1,1");
        Mesh inner = made("box:1,1,1");
        flip(inner);
        append(hollow, inner, at, 0.5);
        const Solid solid = make_solid("it", hollow);
        CHECK(solid.volume == Approx(1 - 0.125).epsilon(1e-14));
        CHECK_FALSE(solid.approximate);
        const MeshDistance distance(solid.mesh, solid.inside_rule);
        CHECK_FALSE(distance.inside(at - solid.centroid));
        CHECK(distance.inside(Point(-0.4, 0.1, 0.1) - solid.centroid));
    }
}

TEST_CASE("a plate may be as thin as its numbers, and none is filled unasked", "[solid]") {
    for (const double thickness : {1e-3, 4e-7, 1e-9})
        for (const bool turned : {false, true}) {
            CAPTURE(thickness, turned);
            Mesh plate = made("box:2,3,1");
            for (Point& p : plate.vertices) p.z() *= thickness;
            if (turned) flip(plate);
            const Solid solid = make_solid("it", plate);
            CHECK(solid.volume == Approx(6 * thickness).epsilon(1e-9));
            CHECK_FALSE(solid.approximate);
            CHECK(solid.mended.size() == (turned ? 1 : 0));
        }
}

TEST_CASE("a double-sided part beside another counts once", "[solid]") {
    Mesh two = made("box:1,1,1");
    for (const Triangle& t : made("box:1,1,1").triangles)
        two.triangles.push_back({t[0], t[2], t[1]});
    append(two, made("box:1,1,1"), {3, 0, 0});
    Mesh sheet{{{9, 0, 0}, {9, 1, 0}, {9, 0, 1}}, {{0, 1, 2}, {0, 2, 1}}};
    append(two, sheet, Point::Zero());
    const Solid solid = make_solid("it", two);
    CHECK(solid.volume == Approx(2).epsilon(1e-14));
    CHECK(solid.centroid.isApprox(Point(1.5, 0, 0), 1e-14));
    CHECK_FALSE(solid.approximate);
    REQUIRE(solid.mended.size() == 2);
    CHECK_THAT(solid.mended[0], lodtest::contains("dropped 2 triangles that lie back to back"));
    CHECK_THAT(solid.mended[1], lodtest::contains("dropped 12 triangles that doubled others"));
}

TEST_CASE("overlapping parts count once, and the integrals are marked", "[solid]") {
    Mesh two = made("box:1,1,1");
    append(two, made("box:1,1,1"), {0.5, 0.1, 0});
    const Solid solid = make_solid("it", two);
    CHECK(solid.approximate);
    CHECK(solid.volume == Approx(2 - 0.5 * 0.9).epsilon(0.02));
    CHECK(solid.inside_rule == InsideRule::winding);
    const MeshDistance distance(solid.mesh, solid.inside_rule);
    CHECK(distance.inside(Point::Zero()));  // behind a hidden face
}

TEST_CASE("parts that only touch, by corner, edge or face, keep their exact integrals", "[solid]") {
    const lod::Matrix<3> turn = lod::Space<3>::rotation(
        lod::Space<3>::turned(lod::Space<3>::unturned(), lod::Vector<3>(0.3, -0.7, 0.4)));
    for (const bool turned : {false, true})
        for (const Point& by : {Point(1, 1, 1), Point(1, 1, 0), Point(1, 1, 0.3), Point(1, 0, 0),
                                Point(1, 0.2, 0.3), Point(0.75, 0, 0), Point(0.75, 0.1, 0.2),
                                Point(0.75, 0.75, 0.75), Point(0.75, 0.75, 0)}) {
            CAPTURE(by, turned);
            Mesh two = made("box:1,1,1");
            const double scale = by[0] == 1 ? 1 : 0.5;
            append(two, made("box:1,1,1"), by, scale);
            if (turned)
                for (Point& p : two.vertices) p = turn * p;
            const Solid solid = make_solid("it", two);
            CHECK_FALSE(solid.approximate);
            CHECK(solid.volume == Approx(1 + scale * scale * scale).epsilon(1e-12));
            const MeshDistance distance(solid.mesh, solid.inside_rule);
            const Point inner =
                turned ? Point(turn * Point(0.45, 0.1, 0.1)) : Point(0.45, 0.1, 0.1);
            CHECK(distance.inside(inner - solid.centroid));
        }
}

TEST_CASE("parts that share a space are told from those that touch", "[solid]") {
    for (const Point& by :
         {Point(0.5, 0, 0), Point(0.5, 0.5, 0), Point(0.5, 0.5, 0.5), Point(0.999, 0, 0),
          Point(0.999, 0.2, 0.999), Point(0.25, 0.25, 0.25)}) {
        CAPTURE(by);
        Mesh two = made("box:1,1,1");
        const double scale = by[0] == 0.25 ? 0.5 : 1;  // inside, with three faces in common
        append(two, made("box:1,1,1"), by, scale);
        CHECK(make_solid("it", two).approximate);
    }
    Mesh through = made("box:1,1,1");  // a bar through a box: no corner of either lies in the other
    append(through, made("box:3,0.2,0.2"), Point::Zero());
    CHECK(make_solid("it", through).approximate);
    Mesh thin = made("box:1,1,0.0001");  // too thin for a grid
    append(thin, made("box:0.0001,1,1"), Point::Zero());
    CHECK_THAT(refusal(thin), lodtest::contains("its parts cross each other, so it was filled"));
}
