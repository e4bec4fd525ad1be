#include "lod2d/quadtree.hpp"

#include <cmath>

namespace lod2d {
namespace {

using Disc = lod::Sphere<2>;

class Quadtree {
  public:
    Quadtree(const QuadtreeConfig& config, double spare) : config_(config), spare_(spare) {}

    std::vector<lod::TreeNode<2>> run(const PolygonPiece& whole, const Point& centre, double half) {
        nodes_.push_back({circle(centre, half), lod::mean_normal<2>(whole), {}});
        divide(0, whole, half, config_.depth, 1);
        return std::move(nodes_);
    }

  private:
    [[nodiscard]] Disc circle(const Point& centre, double half) const {
        return {centre, half * std::sqrt(2.0) + spare_};
    }

    /// `share`: of the whole work that lies in this node.
    void divide(std::size_t node, const PolygonPiece& content, double half, int levels_left,
                double share) {
        lod::check_interrupted();
        if (levels_left == 0) return report(share);
        std::vector<Disc> quarters;
        for (const double dy : {-half / 2, half / 2})
            for (const double dx : {-half / 2, half / 2})
                quarters.push_back(circle(nodes_[node].sphere.centre + Point(dx, dy), half / 2));
        const auto contents = lod::split<2>(content, std::span<const Disc>(quarters));
        for (std::size_t i = 0; i < quarters.size(); ++i) {
            if (contents[i].vertices().empty()) {
                report(share / 4);
                continue;
            }
            const std::size_t child = nodes_.size();
            nodes_[node].children.push_back(static_cast<int>(child));
            nodes_.push_back({quarters[i], lod::mean_normal<2>(contents[i]), {}});
            divide(child, contents[i], half / 2, levels_left - 1, share / 4);
        }
    }

    void report(double share) {
        done_ += share;
        if (config_.progress) config_.progress(std::min(1.0, done_));
    }

    const QuadtreeConfig& config_;
    double spare_;
    double done_ = 0;
    std::vector<lod::TreeNode<2>> nodes_;
};

}  // namespace

lod::SphereTree<2> build_quadtree(const PolygonPiece& whole, const QuadtreeConfig& config) {
    lod::GrowSettings limits;
    limits.depth = config.depth;
    lod::check_grow_settings(limits);
    Box box;
    for (const Point& p : whole.vertices()) box.extend(p);
    const Point centre = box.center();
    const double half = (box.max() - centre).cwiseMax(centre - box.min()).maxCoeff();
    const double spare = lod::rounding_bound<2>({centre, half * std::sqrt(2.0)}) * 2;
    return lod::lay_out<2>(Quadtree(config, spare).run(whole, centre, half));
}

}  // namespace lod2d
