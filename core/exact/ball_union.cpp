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

}  // namespace

template <int Dim>
BallUnion<Dim>::BallUnion(std::vector<Sphere<Dim>> balls) : balls_(std::move(balls)) {
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
    return std::any_of(balls_.begin(), balls_.end(), [&](const Sphere<Dim>& ball) {
        return (p - ball.centre).squaredNorm() <= ball.radius * ball.radius;
    });
}

template <int Dim>
void BallUnion<Dim>::visit_pairs(const ExactShape<Dim>& b, const Placement<Dim>& b_in_a,
                                 PartVisitor<Dim>& visitor) const {
    const auto* other = dynamic_cast<const BallUnion*>(&b);
    if (!other)
        throw Error(ErrorKind::input_refused,
                    "exact shapes of two kinds cannot meet; give both bodies outlines, both "
                    "meshes, or both unions of balls");
    for (const Sphere<Dim>& ball_a : balls_)
        for (const Sphere<Dim>& ball_b : other->balls_) {
            const Vector<Dim> centre = b_in_a.carry(ball_b.centre);
            const Vector<Dim> way = centre - ball_a.centre;
            const double length = way.norm();
            PartPair<Dim> pair;
            pair.a = part_of(ball_a);
            pair.b = part_of<Dim>({centre, ball_b.radius});
            pair.distance = std::max(0.0, length - ball_a.radius - ball_b.radius);
            const Vector<Dim> n =
                length > 0 ? Vector<Dim>(way / length) : Vector<Dim>(Vector<Dim>::Unit(0));
            if (pair.distance > 0 && visitor.skips(pair.a, pair.b, n, pair.distance)) continue;
            pair.nearest = {ball_a.centre + ball_a.radius * n, centre - ball_b.radius * n};
            pair.add_direction(n);
            if (pair.distance <= visitor.feet_within) pair.feet[pair.feet_count++] = pair.nearest;
            visitor.visit(pair);
        }
}

template class BallUnion<2>;
template class BallUnion<3>;

}  // namespace lod
