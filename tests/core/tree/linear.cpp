#include "lodlab/core/math/linear.hpp"

#include <type_traits>

#include "lodlab/core/base/lanes.hpp"
#include "lodlab/core/math/box.hpp"
#include "lodlab/core/math/eigen.hpp"
#include "lodlab/core/math/solvers.hpp"
#include "lodlab/core/tree/body.hpp"
#include "tests/catch.hpp"
#include "tests/random.hpp"

using namespace lod;

namespace {

// Neither flags nor Eigen's macros have a say in these.
static_assert(sizeof(Vector<2>) == 16 && sizeof(Vector<3>) == 24 && sizeof(Matrix<3>) == 72);
static_assert(sizeof(Quaternion) == 32 && alignof(Quaternion) == alignof(double));
static_assert(alignof(Vector<2>) == alignof(double) && alignof(Body<3>) == alignof(double));
static_assert(std::is_trivially_copyable_v<Matrix<3>> && std::is_standard_layout_v<Matrix<3>>);
static_assert(sizeof(Lanes<8>) == 32 && alignof(Lanes<8>) == 16);

template <int Rows, int Cols>
FixedMatrix<Rows, Cols> random_matrix(lodtest::Random& random) {
    FixedMatrix<Rows, Cols> m;
    for (double& number : m) number = random.in(-2, 2);
    return m;
}

Quaternion random_turn(lodtest::Random& random) {
    return Quaternion::of_coeffs(random_matrix<4, 1>(random)).normalized();
}

constexpr double rounding = 1e-14;

}  // namespace

TEST_CASE("numbers are read row by row, as they are written down", "[linear]") {
    const Matrix<2> m(1, 2, 3, 4);
    CHECK(m(0, 1) == 2);
    CHECK(m(1, 0) == 3);
    CHECK(m.transpose() == Matrix<2>(1, 3, 2, 4));
    CHECK(m * Vector<2>(1, 10) == Vector<2>(21, 43));
    CHECK(m.col(1) == Vector<2>(2, 4));
    CHECK(Vector<3>(1, 2, 3).asDiagonal().trace() == 6);
}

TEST_CASE("products agree with Eigen's", "[linear]") {
    lodtest::Random random(41);
    for (int trial = 0; trial < 500; ++trial) {
        const auto a = random_matrix<3, 3>(random);
        const auto b = random_matrix<3, 3>(random);
        const auto u = random_matrix<3, 1>(random);
        const auto v = random_matrix<3, 1>(random);
        CHECK((to_eigen(a * b) - to_eigen(a) * to_eigen(b)).norm() < rounding);
        CHECK((to_eigen(a * u) - to_eigen(a) * to_eigen(u)).norm() < rounding);
        CHECK((to_eigen(u * v.transpose()) - to_eigen(u) * to_eigen(v).transpose()).norm() <
              rounding);
        CHECK((to_eigen(u.cross(v)) - to_eigen(u).cross(to_eigen(v))).norm() < rounding);
        CHECK(u.dot(v) == Approx(to_eigen(u).dot(to_eigen(v))).margin(rounding));
        CHECK(std::abs(u.unitOrthogonal().dot(u)) < rounding);
        CHECK(from_eigen(to_eigen(a)) == a);
    }
}

TEST_CASE("quaternions multiply and turn as Eigen's", "[linear]") {
    lodtest::Random random(42);
    for (int trial = 0; trial < 500; ++trial) {
        const Quaternion p = random_turn(random);
        const Quaternion q = random_turn(random);
        const Quaternion product = p * q;
        const Eigen::Quaterniond expected = to_eigen(p) * to_eigen(q);
        CHECK((to_eigen(product).coeffs() - expected.coeffs()).norm() < rounding);
        CHECK((to_eigen(p.toRotationMatrix()) - to_eigen(p).toRotationMatrix()).norm() < rounding);
        CHECK(from_eigen(to_eigen(q)) == q);
        const Quaternion whole = q * q.conjugate();
        CHECK((whole.coeffs() - Quaternion::Identity().coeffs()).norm() < rounding);
    }
}

TEST_CASE("a stable norm neither overflows nor vanishes", "[linear]") {
    for (const double scale : {1e-320, 1e-300, 1e-160, 1.0, 1e160, 1e300}) {
        CAPTURE(scale);
        const Vector<3> v(3 * scale, 0, -4 * scale);
        CHECK(v.stableNorm() == Approx(5 * scale).epsilon(scale < 1e-310 ? 1e-3 : 1e-14));
        if (scale > 1e-310) CHECK(v.stableNormalized().isApprox(Vector<3>(0.6, 0, -0.8)));
    }
    CHECK(Vector<2>::Zero().stableNorm() == 0);
    CHECK(Vector<2>::Zero().stableNormalized() == Vector<2>::Zero());
    CHECK(std::isinf(Vector<2>(std::numeric_limits<double>::infinity(), 1).stableNorm()));
}

TEST_CASE("a box holds what it was given, and an empty one nothing", "[linear]") {
    Box<2> box;
    CHECK(box.is_empty());
    box.hold(Vector<2>(1, 2));
    CHECK_FALSE(box.is_empty());
    box.hold(Vector<2>(-1, 5));
    CHECK(box.holds({0, 3}));
    CHECK_FALSE(box.holds({0, 5.5}));
    CHECK(box.squared_distance(Vector<2>(4, 1)) == 10);
    CHECK(box.squared_distance(Vector<2>(0, 3)) == 0);
    CHECK(box.meets({{1, 5}, {2, 6}}));  // in a corner
    CHECK(box.squared_distance(Box<2>({4, 9}, {5, 10})) == 25);
}

TEST_CASE("lanes round each number as one number alone is rounded", "[linear]") {
    lodtest::Random random(43);
    for (int trial = 0; trial < 1000; ++trial) {
        Lanes<8> a = Lanes<8>::all(0);
        Lanes<8> b = Lanes<8>::all(0);
        for (std::size_t i = 0; i < 8; ++i) {
            a.set(i, static_cast<float>(random.in(0, 3)));
            b.set(i, static_cast<float>(random.in(0, 3)));
        }
        const Lanes<8> root = square_root(a);
        const Lanes<8> share = a / b;
        for (std::size_t i = 0; i < 8; ++i) {
            CHECK(root[i] == static_cast<float>(std::sqrt(static_cast<double>(a[i]))));
            CHECK(share[i] == a[i] / b[i]);
            CHECK(lower(a, b)[i] == std::min(a[i], b[i]));
            CHECK(upper(a, b)[i] == std::max(a[i], b[i]));
        }
        const float pairs[] = {a[0] + a[4], a[1] + a[5], a[2] + a[6], a[3] + a[7]};
        CHECK(a.sum() == (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]));
    }
}

TEST_CASE("small systems are solved", "[linear]") {
    CHECK(is_positive_definite(Matrix<3>::Identity()));
    CHECK_FALSE(is_positive_definite(Vector<3>(1, -1, 1).asDiagonal()));
    CHECK_FALSE(is_positive_definite(Matrix<3>::Constant(std::nan(""))));
    const Matrix<3> spread = Vector<3>(1, 5, 2).asDiagonal();
    CHECK((inverse(spread) * spread - Matrix<3>::Identity()).isZero(1e-15));
    CHECK(std::abs(principal_axis<3>(spread).y()) == Approx(1));
    const Vector<2> arms[] = {{2, 0}, {0, 2}};
    CHECK(equidistant<2>(arms, 2)->isApprox({1, 1}));
    const Vector<2> parallel[] = {{2, 0}, {4, 0}};
    CHECK_FALSE(equidistant<2>(parallel, 2));
}
