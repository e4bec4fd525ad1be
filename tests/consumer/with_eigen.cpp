// A program that computes with Eigen under settings of its own, beside lodlab: dynamic and aligned
// Eigen types on the heap, frames in the plane and in space, a mass and an inertia by Eigen's
// solvers.
#include <Eigen/Dense>
#include <cstdio>
#include <lodlab/core/frame/frame.hpp>
#include <lodlab/core/frame/state_hash.hpp>
#include <lodlab/core/math/eigen.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>
#include <lodlab/lod3d/builder/build_tree.hpp>
#include <lodlab/lod3d/solid/generators.hpp>
#include <vector>

template <int Dim>
unsigned long long end_of(const lod::SphereTree<Dim>& tree, const lod::Inertia<Dim>& inertia) {
    std::vector<lod::Body<Dim>> bodies(3);
    double place = -1.2;
    for (lod::Body<Dim>& body : bodies) {
        lod::set_mass<Dim>(body, 2, inertia);
        body.tree = std::make_shared<lod::SphereTree<Dim>>(tree);
        body.position[0] = place;
        body.velocity[0] = -place;
        body.spin = lod::Spin<Dim>::Constant(0.7);
        place += 1.25;
    }
    lod::FrameStorage<Dim> storage;
    for (int frame = 0; frame < 300; ++frame) {
        lod::Budget budget = lod::Budget::node_tests(400);
        lod::advance<Dim>(bodies, {}, budget, storage);
    }
    return lod::state_hash<Dim>(bodies);
}

int main() {
    // The program's own use of Eigen: its allocator, its packets, its decompositions.
    std::vector<Eigen::MatrixXd> matrices;
    for (int n = 1; n < 40; ++n) {
        Eigen::MatrixXd m(n, n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) m(i, j) = 1.0 / (1 + i + j) + (i == j);
        matrices.push_back(m);
    }
    bool solved = true;
    for (const Eigen::MatrixXd& m : matrices) {
        const Eigen::VectorXd ones = Eigen::VectorXd::Ones(m.rows());
        solved = solved && (m.fullPivLu().solve(m * ones) - ones).norm() < 1e-9 &&
                 m.llt().info() == Eigen::Success;
    }
    const Eigen::Matrix3d spread = Eigen::Vector3d(0.4, 0.5, 0.6).asDiagonal();
    solved =
        solved && Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).info() == Eigen::Success;
    const lod::Inertia<3> inertia = lod::from_eigen(spread);
    const Eigen::Vector3d there_and_back = lod::to_eigen(lod::from_eigen(Eigen::Vector3d(1, 2, 3)));

    const lod2d::Shape star = lod2d::generate("star:5");
    const auto flat = lod2d::build_tree(star, {.depth = 3});
    const auto deep =
        lod3d::build_tree(lod3d::generate("box"), {.builder = lod3d::Builder::octree, .depth = 2});
    std::printf("Eigen %s, (%g, %g, %g)\n", solved ? "solved all" : "FAILED", there_and_back.x(),
                there_and_back.y(), there_and_back.z());
    std::printf("plane %016llx\n", end_of<2>(flat, lod::Inertia<2>::Constant(0.3)));
    std::printf("space %016llx\n", end_of<3>(deep, inertia));
    return solved ? 0 : 1;
}
