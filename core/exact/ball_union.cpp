#include "lodlab/core/exact/ball_union.hpp"

#include <algorithm>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/math/bit_hash.hpp"

namespace lod {
namespace {

template <int Dim>
std::vector<Sphere<Dim>> level_balls(const SphereTree<Dim>& tree, int level) {
    std::vector<Sphere<Dim>> balls;
    for (int node : tree.level_nodes(level)) balls.push_back(tree.sphere(node));
    return balls;
}

template <int Dim>
ConvexPart<Dim> part_of(const Sphere<Dim>& ball) {
    ConvexPart<Dim> part;
    part.corner[0] = ball.centre;
    part.count = 1;
    part.radius = ball.radius;
    return part;
}

/// Where two balls are nearest to each other.
template <int Dim>
PartPair<Dim> nearest_points(const Sphere<Dim>& a, const Sphere<Dim>& b, double feet_within) {
    const Vector<Dim> way = b.centre - a.centre;
    const double length = way.norm();
    const Vector<Dim> n = length > 0 ? Vector<Dim>(way / length) : Vector<Dim>::Unit(0);
    PartPair<Dim> pair;
    pair.a = part_of(a);
    pair.b = part_of(b);
    pair.distance = std::max(0.0, length - a.radius - b.radius);
    pair.nearest = {a.centre + a.radius * n, b.centre - b.radius * n};
    pair.add_direction(n);
    if (pair.distance <= feet_within) pair.feet[pair.feet_count++] = pair.nearest;
    return pair;
}

/// Passes on only those pairs of balls that the visitor does not skip.
template <int Dim>
class BallVisitor final : public PartVisitor<Dim> {
  public:
    explicit BallVisitor(PartVisitor<Dim>& visitor) : visitor_(visitor) {
        this->feet_within = visitor.feet_within;
    }
    bool skips(const ConvexPart<Dim>& a, const ConvexPart<Dim>& b, const Vector<Dim>& direction,
               double gap) const override {
        return visitor_.skips(a, b, direction, gap);
    }
    void visit(const PartPair<Dim>& pair) override {
        if (pair.distance > 0 && skips(pair.a, pair.b, pair.direction[0], pair.distance)) return;
        visitor_.visit(pair);
    }
    bool is_done() const override { return visitor_.is_done(); }

  private:
    PartVisitor<Dim>& visitor_;
};

}  // namespace

template <int Dim>
BallUnion<Dim>::BallUnion(std::vector<Sphere<Dim>> balls)
    : balls_(std::move(balls)), tree_(boxes_of<Dim>(balls_)) {
    if (balls_.empty())
        throw Error(ErrorKind::input_refused, "a union of no balls is no shape; give it one");
    BitHash hash;
    for (const Sphere<Dim>& ball : balls_) {
        hash.add(ball.centre);
        hash.add(ball.radius);
        centres_.push_back(ball.centre);
        radius_ = std::max(radius_, ball.centre.norm() + ball.radius);
    }
    hash_ = hash.value();
}

template <int Dim>
BallUnion<Dim>::BallUnion(const SphereTree<Dim>& tree, int level)
    : BallUnion(level_balls(tree, level)) {}

template <int Dim>
bool BallUnion<Dim>::holds(const Vector<Dim>& p) const {
    return tree_.any_meeting({p, p}, [&](std::size_t i) {
        return (p - balls_[i].centre).squaredNorm() <= balls_[i].radius * balls_[i].radius;
    });
}

template <int Dim>
BoxNode<Dim> BallUnion<Dim>::box_node(std::int32_t i) const {
    const auto& node = tree_.nodes()[static_cast<std::size_t>(i)];
    const auto number = static_cast<std::int32_t>(node.number);
    return {node.box.low, node.box.high, static_cast<std::int32_t>(node.second), number,
            number + 1};
}

template <int Dim>
void BallUnion<Dim>::visit_pairs(const ExactShape<Dim>& b, const Placement<Dim>& b_in_a,
                                 PartVisitor<Dim>& visitor) const {
    BallVisitor<Dim> passing(visitor);
    walk_pairs<Dim>(*this, of_kind<BallUnion>(b, "a union of balls"), b_in_a, nearest_points<Dim>,
                    passing);
}

template class BallUnion<2>;
template class BallUnion<3>;

}  // namespace lod
