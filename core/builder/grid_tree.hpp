#pragma once

/// \file
/// The simplest builder: a quadtree or octree of balls. The one to read first before writing
/// another.

#include <cmath>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/builder/grow.hpp"

namespace lod {

namespace detail {

template <int Dim, PieceOf<Dim> Piece>
class GridGrower {
  public:
    GridGrower(int depth, double spare, const std::function<void(double)>& progress)
        : depth_(depth), spare_(spare), progress_(progress) {}

    std::vector<TreeNode<Dim>> run(const Piece& whole, const Vector<Dim>& centre, double half) {
        nodes_.push_back({ball(centre, half), mean_normal<Dim>(whole), {}});
        divide(0, whole, half, depth_, 1);
        return std::move(nodes_);
    }

  private:
    static constexpr int parts = 1 << Dim;

    [[nodiscard]] Sphere<Dim> ball(const Vector<Dim>& centre, double half) const {
        return {centre, half * std::sqrt(static_cast<double>(Dim)) + spare_};
    }

    /// `share`: of the whole work that lies in this node.
    void divide(std::size_t node, const Piece& content, double half, int levels_left,
                double share) {
        check_interrupted();
        if (levels_left == 0) return report(share);
        std::vector<Sphere<Dim>> balls;
        for (int part = 0; part < parts; ++part) {
            Vector<Dim> centre = nodes_[node].sphere.centre;
            for (int d = 0; d < Dim; ++d) centre[d] += (part >> d & 1) != 0 ? half / 2 : -half / 2;
            balls.push_back(ball(centre, half / 2));
        }
        const auto contents = split<Dim>(content, std::span<const Sphere<Dim>>(balls));
        for (std::size_t i = 0; i < balls.size(); ++i) {
            if (contents[i].vertices().empty()) {
                report(share / parts);
                continue;
            }
            const std::size_t child = nodes_.size();
            nodes_[node].children.push_back(static_cast<int>(child));
            nodes_.push_back({balls[i], mean_normal<Dim>(contents[i]), {}});
            divide(child, contents[i], half / 2, levels_left - 1, share / parts);
        }
    }

    void report(double share) {
        done_ += share;
        if (progress_) progress_((std::min)(1.0, done_));
    }

    int depth_;
    double spare_;
    const std::function<void(double)>& progress_;
    double done_ = 0;
    std::vector<TreeNode<Dim>> nodes_;
};

}  // namespace detail

/// The classical quadtree or octree of balls: the cube about the shape is halved along every axis
/// again and again, and each cube that holds some of the shape gets the ball through its corners.
/// The shape's content of the cubes is what the nodes own: on a grid, equal balls have the grid's
/// planes as their power diagram, so that the certificate holds. Requires a depth within
/// check_grow_settings.
template <int Dim, PieceOf<Dim> Piece>
[[nodiscard]] SphereTree<Dim> grow_grid_tree(const Piece& whole, int depth,
                                             const std::function<void(double)>& progress = {}) {
    Vector<Dim> low = whole.vertices().front();
    Vector<Dim> high = low;
    for (const Vector<Dim>& p : whole.vertices()) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vector<Dim> centre = 0.5 * (low + high);
    const double half = (high - centre).cwiseMax(centre - low).maxCoeff();
    const double reach = half * std::sqrt(static_cast<double>(Dim));
    const double spare = 2 * rounding_bound<Dim>({centre, reach});
    detail::GridGrower<Dim, Piece> grower(depth, spare, progress);
    return lay_out<Dim>(grower.run(whole, centre, half));
}

}  // namespace lod
