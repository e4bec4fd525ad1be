#include "lodlab/core/contact/hull_contact.hpp"

#include <cmath>

#include "lodlab/core/builder/fit_hull.hpp"
#include "lodlab/core/builder/hollows.hpp"
#include "lodlab/core/contact/hulls_apart.hpp"
#include "lodlab/core/math/convex_cell.hpp"
#include "lodlab/core/math/trigonometry.hpp"
#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"

using namespace lod;
using namespace lodtest;

namespace {

/// The hull of points whose convex hull's faces are not known.
template <int Dim>
Hull<Dim> hull_of(const std::vector<Vector<Dim>>& points,
                  const std::vector<Vector<Dim>>& normals = {}) {
    return fit_hull<Dim>(points, points, normals, 1e-12);
}

/// The corners of a box about the origin.
template <int Dim>
std::vector<Vector<Dim>> box_corners(const Vector<Dim>& half) {
    std::vector<Vector<Dim>> corners;
    for (int corner = 0; corner < 1 << Dim; ++corner) {
        corners.push_back(half);
        for (int axis = 0; axis < Dim; ++axis)
            if ((corner >> axis & 1) != 0) corners.back()[axis] = -half[axis];
    }
    return corners;
}

template <int Dim>
NodeHulls<Dim> only(const Hull<Dim>& hull) {
    NodeHulls<Dim> hulls;
    hulls.add(hull);
    return hulls;
}

template <int Dim>
PosedHull<Dim> posed(const NodeHulls<Dim>& hulls, const Vector<Dim>& position, double angle = 0) {
    PosedHull<Dim> hull;
    const auto turned = Space<Dim>::turned(Space<Dim>::unturned(), planar_spin<Dim>(angle));
    hull.pose(hulls.of(0), Space<Dim>::rotation(turned), position);
    return hull;
}

template <int Dim>
std::vector<Vector<Dim>> cloud(Random& random, int count) {
    std::vector<Vector<Dim>> points;
    for (int i = 0; i < count; ++i) points.push_back(random_vector<Dim>(random, 1));
    return points;
}

/// No motion.
template <int Dim>
PairMotion<Dim> still(const Vector<Dim>& between) {
    PairMotion<Dim> motion{};
    motion.centre_a.setZero();
    motion.centre_b = between;
    motion.velocity_a.setZero();
    motion.velocity_b.setZero();
    motion.spin_a.setZero();
    motion.spin_b.setZero();
    return motion;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the hull of a box is the box", "[hull]", ((int Dim), Dim), 2, 3) {
    Vector<Dim> half;
    for (int axis = 0; axis < Dim; ++axis) half[axis] = 0.5 + axis;
    const Hull<Dim> hull = hull_of<Dim>(box_corners<Dim>(half));
    CHECK(hull.corners.size() == 1u << Dim);
    CHECK(hull.faces.size() == 2u * Dim);
    const NodeHulls<Dim> hulls = only(hull);
    CHECK(hulls.of(0).is_closed());
    for (const double offset : hulls.of(0).offsets) CHECK(offset >= 0.5);
    for (const Vector<Dim>& corner : hull.corners) CHECK((corner.cwiseAbs() - half).norm() <= 2e-7);
}

TEMPLATE_TEST_CASE_SIG("a hull holds its points, with few faces, and its surface is closed",
                       "[hull]", ((int Dim), Dim), 2, 3) {
    Random random(501);
    for (int trial = 0; trial < 300; ++trial) {
        auto points = cloud<Dim>(random, 1 + random.below(60));
        if (trial % 5 == 0)  // flat
            for (Vector<Dim>& p : points) p[0] = 0.25;
        std::vector<Vector<Dim>> normals;
        for (int i = random.below(40); i > 0; --i) normals.push_back(random_unit<Dim>(random));
        const NodeHulls<Dim> hulls = only(fit_hull<Dim>(points, points, normals, 1e-9));
        const HullView<Dim> hull = hulls.of(0);
        CHECK(hull.normals.size() <= static_cast<std::size_t>(most_hull_faces<Dim>));
        CHECK(hull.corners.size() <= static_cast<std::size_t>(most_hull_corners<Dim>));
        CHECK(hull.is_closed());
        for (std::size_t face = 0; face < hull.normals.size(); ++face) {
            CHECK(support<Dim>(points, hull.normals[face]) <= hull.offsets[face] - 5e-10);
            CHECK(support<Dim>(hull.corners, hull.normals[face]) <= hull.offsets[face] + 1e-9);
        }
    }
}

TEST_CASE("a polygon of up to sixteen sides is its own hull", "[hull]") {
    for (int sides = 3; sides <= most_hull_faces<2>; ++sides) {
        std::vector<Vector<2>> points;
        std::vector<Vector<2>> normals;
        for (int i = 0; i < sides; ++i) {
            const SineCosine corner = sine_cosine(0.1 + 2 * 3.14159265358979 * i / sides);
            const SineCosine middle = sine_cosine(0.1 + 2 * 3.14159265358979 * (i + 0.5) / sides);
            points.push_back({corner.cosine, corner.sine});
            normals.push_back({middle.cosine, middle.sine});
        }
        const Hull<2> hull = hull_of<2>(points, normals);
        CHECK(hull.faces.size() == static_cast<std::size_t>(sides));
        for (const Vector<2>& corner : hull.corners) CHECK(std::abs(corner.norm() - 1) <= 2e-7);
    }
}

TEMPLATE_TEST_CASE_SIG("two boxes meet on their faces, where worked by hand", "[hull]",
                       ((int Dim), Dim), 2, 3) {
    const NodeHulls<Dim> cube = only(hull_of<Dim>(box_corners<Dim>(Vector<Dim>::Constant(0.5))));
    // B stands 0.9 to the right and 0.3 up: they overlap by 0.1, from y = -0.2 to 0.5.
    const Vector<Dim> between = planar<Dim>(0.9, 0.3);
    const auto found = meet(posed(cube, Vector<Dim>(Vector<Dim>::Zero())), posed(cube, between),
                            still<Dim>(between), 0);
    REQUIRE(found.has_value());
    CHECK((found->normal - planar<Dim>(1, 0)).norm() <= 1e-15);
    REQUIRE(found->count == Manifold<Dim>::most_points);
    for (std::size_t i = 0; i < found->count; ++i) {
        CHECK(std::abs(found->depths[i] - 0.1) <= 2e-7);
        CHECK(std::abs(found->points[i][0] - 0.45) <= 2e-7);
        const double y = found->points[i][1];
        CHECK(std::min(std::abs(y + 0.2), std::abs(y - 0.5)) <= 2e-7);
    }
    CHECK_FALSE(meet(posed(cube, Vector<Dim>(Vector<Dim>::Zero())),
                     posed(cube, planar<Dim>(1.001, 0)), still<Dim>(planar<Dim>(1.001, 0)), 1e-9)
                    .has_value());
}

TEMPLATE_TEST_CASE_SIG("hulls that touch within rounding touch where they are near each other", "",
                       ((int Dim), Dim), 2, 3) {
    // A small box before the middle of a wide one: the corners of the wide face are far away.
    Vector<Dim> wide = Vector<Dim>::Constant(10);
    wide[0] = 0.5;
    const NodeHulls<Dim> wall = only(hull_of<Dim>(box_corners<Dim>(wide)));
    const NodeHulls<Dim> small = only(hull_of<Dim>(box_corners<Dim>(Vector<Dim>::Constant(0.1))));
    for (const double gap : {0.0, 2e-7, 5e-7, 8e-7})
        for (double angle = 0; angle < 6; angle += 0.1) {
            CAPTURE(gap, angle);
            const Matrix<Dim> turn = Space<Dim>::rotation(
                Space<Dim>::turned(Space<Dim>::unturned(), planar_spin<Dim>(angle)));
            const Vector<Dim> between = turn * ((0.6 + gap) * Vector<Dim>::Unit(0));
            const auto found = meet(posed(small, Vector<Dim>(Vector<Dim>::Zero()), angle),
                                    posed(wall, between, angle), still<Dim>(between), 1e-6);
            REQUIRE(found);
            for (std::size_t k = 0; k < found->count; ++k)
                CHECK((found->points[k] - turn * (0.1 * Vector<Dim>::Unit(0))).norm() <= 0.2);
        }
}

TEMPLATE_TEST_CASE_SIG("a corner that stands on a face is one contact", "[hull]", ((int Dim), Dim),
                       2, 3) {
    const NodeHulls<Dim> cube = only(hull_of<Dim>(box_corners<Dim>(Vector<Dim>::Constant(0.5))));
    const double quarter_turn = 0.5 * 1.5707963267948966;
    const Vector<Dim> between = planar<Dim>(0.2, 0.5 + std::sqrt(0.5) - 0.01);
    const auto found = meet(posed(cube, Vector<Dim>(Vector<Dim>::Zero())),
                            posed(cube, between, quarter_turn), still<Dim>(between), 0);
    REQUIRE(found.has_value());
    CHECK((found->normal - planar<Dim>(0, 1)).norm() <= 1e-12);
    CHECK(found->count == (Dim == 2 ? 1 : 2));  // in space an edge of the cube
    for (std::size_t i = 0; i < found->count; ++i) {
        CHECK(std::abs(found->points[i][0] - 0.2) <= 2e-7);
        CHECK(std::abs(found->depths[i] - 0.01) <= 2e-7);
    }
}

TEST_CASE("edges that cross meet in one point, where worked by hand", "[hull]") {
    const NodeHulls<3> cube = only(hull_of<3>(box_corners<3>(Vector<3>::Constant(0.5))));
    const double quarter_turn = 0.5 * 1.5707963267948966;
    // A's upper edge lies along x, B's lower edge along y, each sqrt(1/2) from its cube's middle.
    const auto turned = [&](const Vector<3>& axis) {
        return Space<3>::rotation(Space<3>::turned(Space<3>::unturned(), quarter_turn * axis));
    };
    const auto at_height = [&](double gap) {
        PosedHull<3> a;
        PosedHull<3> b;
        const Vector<3> between = {0.1, 0.2, 2 * std::sqrt(0.5) + gap};
        a.pose(cube.of(0), turned({1, 0, 0}), Vector<3>::Zero());
        b.pose(cube.of(0), turned({0, 1, 0}), between);
        return meet(a, b, still<3>(between), 1e-9);
    };
    const auto found = at_height(-0.01);
    REQUIRE(found.has_value());
    CHECK((found->normal - Vector<3>(0, 0, 1)).norm() <= 1e-12);
    REQUIRE(found->count == 1);
    CHECK((found->points[0] - Vector<3>(0.1, 0, std::sqrt(0.5) - 0.005)).norm() <= 3e-7);
    CHECK(std::abs(found->depths[0] - 0.01) <= 3e-7);
    // No face tells these two apart: they overlap along every face's normal.
    CHECK_FALSE(at_height(0.001).has_value());
}

TEMPLATE_TEST_CASE_SIG("the face that was crossed last is the one they met at", "[hull]",
                       ((int Dim), Dim), 2, 3) {
    const NodeHulls<Dim> cube = only(hull_of<Dim>(box_corners<Dim>(Vector<Dim>::Constant(0.5))));
    // B came down by 0.7 in the last frame: it is now nearer to A's right side than to its top.
    const Vector<Dim> between = planar<Dim>(0.6, 0.4);
    PairMotion<Dim> motion = still<Dim>(between);
    motion.velocity_b = planar<Dim>(0, -70);
    const auto a = posed(cube, Vector<Dim>(Vector<Dim>::Zero()));
    const auto b = posed(cube, between);
    CHECK((meet(a, b, motion, 0)->normal - planar<Dim>(1, 0)).norm() <= 1e-15);
    motion.time_step = 0.01;
    CHECK((meet(a, b, motion, 0)->normal - planar<Dim>(0, 1)).norm() <= 1e-15);
}

TEMPLATE_TEST_CASE_SIG("hulls are proved apart where they share no point, and only there", "[hull]",
                       ((int Dim), Dim), 2, 3) {
    Random random(502);
    int apart = 0;
    int told_along_lines = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto points_a = cloud<Dim>(random, 4 + random.below(12));
        const auto points_b = cloud<Dim>(random, 4 + random.below(12));
        const NodeHulls<Dim> a = only(hull_of<Dim>(points_a));
        const NodeHulls<Dim> b = only(hull_of<Dim>(points_b));
        const Vector<Dim> between = random_vector<Dim>(random, 2.5);
        const auto found = meet(posed(a, Vector<Dim>(Vector<Dim>::Zero())), posed(b, between),
                                still<Dim>(between), 1e-12);
        apart += !found;
        const bool along_lines = hulls_apart<Dim>(
            a.corners_of(0), b.corners_of(0), {Matrix<Dim>::Identity(), between}, between, 1e-12);
        if (found) CHECK_FALSE(along_lines);
        told_along_lines += along_lines;
        // What both half-space intersections hold, by cutting one with the other.
        ConvexCell<Dim> both(Box<Dim>(Vector<Dim>::Constant(-5), Vector<Dim>::Constant(5)));
        for (std::size_t i = 0; i < a.of(0).normals.size(); ++i)
            both.clip({a.of(0).normals[i], a.of(0).offsets[i], true});
        for (std::size_t i = 0; i < b.of(0).normals.size(); ++i)
            both.clip(
                {b.of(0).normals[i], b.of(0).offsets[i] + b.of(0).normals[i].dot(between), true});
        if (!both.empty()) CHECK(found.has_value());
        if (found) {
            CHECK(std::abs(found->normal.norm() - 1) <= 1e-12);
            CHECK(found->count >= 1);
            CHECK_FALSE(both.empty());
        }
    }
    CHECK(apart > 50);
    CHECK(apart < 450);
    CHECK(told_along_lines >= 0.7 * apart);
}

TEMPLATE_TEST_CASE_SIG("hulls are told apart along lines by more than the slack, however they turn",
                       "[hull]", ((int Dim), Dim), 2, 3) {
    Vector<Dim> half = Vector<Dim>::Constant(1);
    half[1] = 2;
    const NodeHulls<Dim> box = only(hull_of<Dim>(box_corners<Dim>(half)));
    const auto corners = box.corners_of(0);
    // A quarter turn about z makes B's box reach 2 along x; with A's 1 they touch at 3.
    const Matrix<Dim> turn = Space<Dim>::rotation(
        Space<Dim>::turned(Space<Dim>::unturned(), planar_spin<Dim>(full_turn / 4)));
    const auto apart = [&](double between, double slack) {
        const Vector<Dim> shift = between * Vector<Dim>::Unit(0);
        return hulls_apart<Dim>(corners, corners, {turn, shift}, shift, slack);
    };
    CHECK(apart(3.01, 1e-12));
    CHECK(apart(3.01, 0.0099));
    CHECK_FALSE(apart(3.01, 0.0101));
    CHECK_FALSE(apart(2.99, 1e-12));
    NodeHulls<Dim> border;
    border.add_half_space(Vector<Dim>::Unit(0));
    const Vector<Dim> far = 100 * Vector<Dim>::Unit(0);
    CHECK_FALSE(hulls_apart<Dim>(border.corners_of(0), corners, {turn, far}, far, 1e-12));
}
