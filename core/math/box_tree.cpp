#include "lodlab/core/math/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace lod {

template <int Dim>
void BoxTree<Dim>::build(std::span<const Box<Dim>> boxes) {
    chosen_.resize(boxes.size());
    std::iota(chosen_.begin(), chosen_.end(), std::size_t{0});
    nodes_.clear();
    nodes_.reserve(2 * boxes.size());
    if (!chosen_.empty()) build(boxes, chosen_);
    rank_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) rank_[chosen_[i]] = i;
}

/// Halves the boxes by their centres along the axis on which these spread widest.
template <int Dim>
void BoxTree<Dim>::build(std::span<const Box<Dim>> boxes, std::span<std::size_t> chosen) {
    const std::size_t place = nodes_.size();
    Node& node = nodes_.emplace_back();
    Box<Dim> centres;
    for (const std::size_t i : chosen) {
        node.box.hold(boxes[i]);
        centres.hold(boxes[i].centre());
    }
    if (chosen.size() == 1) {
        node.number = chosen.front();
        return;
    }
    int axis = 0;
    for (int d = 1; d < Dim; ++d)
        if (centres.size()[d] > centres.size()[axis]) axis = d;
    const std::size_t half = chosen.size() / 2;
    std::nth_element(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(half),
                     chosen.end(), [&](std::size_t i, std::size_t k) {
                         const double at_i = boxes[i].centre()[axis];
                         const double at_k = boxes[k].centre()[axis];
                         return at_i < at_k || (at_i == at_k && i < k);
                     });
    build(boxes, chosen.first(half));
    nodes_[place].second = nodes_.size();
    build(boxes, chosen.subspan(half));
}

/// From the root down to its leaf, by the halves in which build() laid them out.
template <int Dim>
void BoxTree<Dim>::grow(std::size_t number, const Box<Dim>& box) {
    std::size_t place = 0;
    std::size_t rank = rank_[number];
    for (std::size_t count = rank_.size(); count > 1;) {
        Node& node = nodes_[place];
        node.box.hold(box);
        ++steps_;
        const std::size_t half = count / 2;
        const bool is_first = rank < half;
        place = is_first ? place + 1 : node.second;
        count = is_first ? half : count - half;
        if (!is_first) rank -= half;
    }
    nodes_[place].box.hold(box);
    ++steps_;
}

template <int Dim>
std::vector<Box<Dim>> boxes_of(std::span<const Sphere<Dim>> balls) {
    std::vector<Box<Dim>> boxes;
    boxes.reserve(balls.size());
    for (const Sphere<Dim>& ball : balls) {
        const double far = ball.centre.cwiseAbs().maxCoeff() + ball.radius;
        const Vector<Dim> half = Vector<Dim>::Constant(ball.radius + 1e-15 * far);
        boxes.emplace_back(ball.centre - half, ball.centre + half);
    }
    return boxes;
}

#define LOD_INSTANTIATE(Dim)     \
    template class BoxTree<Dim>; \
    template std::vector<Box<Dim>> boxes_of(std::span<const Sphere<Dim>>);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
