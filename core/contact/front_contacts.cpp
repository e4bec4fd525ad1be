#include "lodlab/core/contact/front_contacts.hpp"

#include <algorithm>
#include <utility>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// A node with the mean normal of its side of a patch.
template <int Dim, class Side>
SurfaceNode<Dim> node_of(const Sphere<Dim>& ball, const Side& side) {
    return {ball, side.nodes > 0 ? Vector<Dim>(side.normal / side.nodes) : side.normal};
}

/// The contact of a node's ball and a half-space.
template <int Dim>
std::optional<Contact<Dim>> border_contact(const PosedTree<Dim>& a, const PosedTree<Dim>& b,
                                           const NodePair& nodes, PointModel point_model) {
    return a.is_half_space()
               ? model_border_contact(b.sphere(nodes.b), a.half_space(), true, point_model)
               : model_border_contact(a.sphere(nodes.a), b.half_space(), false, point_model);
}

/// Two nodes whose balls fit better than their hulls touch as balls do.
template <int Dim>
std::optional<Manifold<Dim>> meet_balls(const PosedTree<Dim>& a, const PosedTree<Dim>& b,
                                        const NodePair& nodes, const PairMotion<Dim>& motion) {
    const auto contact =
        a.is_half_space() || b.is_half_space()
            ? border_contact(a, b, nodes, PointModel::plane_of_intersection)
            : model_contact<Dim>(a.sphere(nodes.a), b.sphere(nodes.b), PointModel::radius_ratio,
                                 motion.centre_b - motion.centre_a);
    if (!contact) return std::nullopt;
    Manifold<Dim> manifold;
    manifold.normal = contact->normal;
    manifold.points[0] = contact->point - a.position();
    manifold.depths[0] = contact->depth;
    manifold.count = 1;
    return manifold;
}

}  // namespace

template <int Dim>
std::int32_t FrontContacts<Dim>::patch_of(std::int32_t pair) {
    while (joined_[at(pair)] != pair) {
        joined_[at(pair)] = joined_[at(joined_[at(pair)])];
        pair = joined_[at(pair)];
    }
    return pair;
}

/// Joins a pair to the first pair that has the same node.
template <int Dim>
void FrontContacts<Dim>::join(std::vector<std::int32_t>& first_pair, std::int32_t node,
                              std::int32_t pair) {
    std::int32_t& first = first_pair[at(node)];
    if (first < 0) first = pair;
    joined_[at(patch_of(pair))] = patch_of(first);
}

template <int Dim>
void FrontContacts<Dim>::find_patches(const PosedFront<Dim>& front) {
    const PosedTree<Dim>& a = front.a;
    const PosedTree<Dim>& b = front.b;
    const std::span<const NodePair> pairs = front.pairs;
    const auto count = static_cast<std::int32_t>(pairs.size());
    if (first_a_.size() < at(a.tree().size())) first_a_.resize(at(a.tree().size()), -1);
    if (first_b_.size() < at(b.tree().size())) first_b_.resize(at(b.tree().size()), -1);
    joined_.resize(pairs.size());
    for (std::int32_t i = 0; i < count; ++i) joined_[at(i)] = i;
    for (std::int32_t i = 0; i < count; ++i) {
        join(first_a_, pairs[at(i)].a, i);
        join(first_b_, pairs[at(i)].b, i);
    }
    refill(patches_, pairs.size(), Patch{});
    const auto add = [](const Vector<Dim>& mean_normal, Side& side) {
        if (mean_normal.isZero(0)) return;
        side.normal += mean_normal;
        ++side.nodes;
    };
    for (std::int32_t i = 0; i < count; ++i) {
        const NodePair& nodes = pairs[at(i)];
        Patch& patch = patches_[at(patch_of(i))];
        // Each node once, at its first pair; which leaves the lists as they were.
        if (std::exchange(first_a_[at(nodes.a)], -1) >= 0) add(a.mean_normal(nodes.a), patch.a);
        if (std::exchange(first_b_[at(nodes.b)], -1) >= 0) add(b.mean_normal(nodes.b), patch.b);
    }
}

template <int Dim>
std::optional<Manifold<Dim>> FrontContacts<Dim>::meet_nodes(const PosedFront<Dim>& front,
                                                            const Placement<Dim>& b_in_a,
                                                            const NodePair& nodes,
                                                            const PairMotion<Dim>& motion) {
    const auto& [a, b, pairs] = front;
    const NodeHulls<Dim>& hulls_a = a.tree().hulls;
    const NodeHulls<Dim>& hulls_b = b.tree().hulls;
    const bool round_a = hulls_a.is_round(nodes.a) || a.is_half_space();
    const bool round_b = hulls_b.is_round(nodes.b) || b.is_half_space();
    if (round_a && round_b) return meet_balls(a, b, nodes, motion);
    // Twice for the sums of products that a half-space takes (PosedTree::rounding).
    const double slack = 2 * (a.rounding() + b.rounding());
    const Vector<Dim> centres =
        b_in_a.carry(b.tree().sphere(nodes.b).centre) - a.tree().sphere(nodes.a).centre;
    if (hulls_apart<Dim>(hulls_a.corners_of(nodes.a), hulls_b.corners_of(nodes.b), b_in_a, centres,
                         slack))
        return std::nullopt;
    if (std::exchange(posed_a_, nodes.a) != nodes.a)
        hull_a_.pose(hulls_a.of(nodes.a), a.rotation(), motion.centre_a);
    if (std::exchange(posed_b_, nodes.b) != nodes.b)
        hull_b_.pose(hulls_b.of(nodes.b), b.rotation(), motion.centre_b);
    return meet(hull_a_, hull_b_, motion, slack);
}

/// The group of two hulls, a new one where there is none.
template <int Dim>
std::int32_t FrontContacts<Dim>::group_of(const NodePair& best, std::size_t mask) {
    // Two odd constants that spread neighbouring numbers over all bits (those of Random).
    std::uint64_t place = static_cast<std::uint64_t>(best.a) * 0x9e3779b97f4a7c15u +
                          static_cast<std::uint64_t>(best.b) * 0xbf58476d1ce4e5b9u;
    place ^= place >> 29;
    for (;; ++place) {
        Slot& slot = slots_[place & mask];
        if (slot.filled_for != front_number_) {
            slot = {front_number_, static_cast<std::int32_t>(spoken_.size())};
            spoken_.push_back({best, -1, -1});
            return slot.group;
        }
        if (spoken_[at(slot.group)].best == best) return slot.group;
    }
}

/// Pairs in their order, groups in that of their nodes.
template <int Dim>
void FrontContacts<Dim>::group_by_hulls(const PosedFront<Dim>& front) {
    const NodeHulls<Dim>& hulls_a = front.a.tree().hulls;
    const NodeHulls<Dim>& hulls_b = front.b.tree().hulls;
    std::size_t room = 16;
    while (room < 2 * front.pairs.size()) room *= 2;
    if (slots_.size() < room) slots_.resize(room);
    if (next_.size() < front.pairs.size()) next_.resize(front.pairs.size());
    ++front_number_;
    spoken_.clear();
    NodePair last{-1, -1};  // neighbours often share a group
    std::int32_t group = 0;
    const auto count = static_cast<std::int32_t>(front.pairs.size());
    for (std::int32_t pair = 0; pair < count; ++pair) {
        const auto& [a, b] = front.pairs[at(pair)];
        const NodePair best{hulls_a.best(a), hulls_b.best(b)};
        if (!(best == last)) group = group_of(best, room - 1);
        last = best;
        Spoken& spoken = spoken_[at(group)];
        (spoken.last < 0 ? spoken.first : next_[at(spoken.last)]) = pair;
        spoken.last = pair;
        next_[at(pair)] = -1;
    }
    if (spoken_.size() < 2) return;
    std::sort(spoken_.begin(), spoken_.end(), [](const Spoken& x, const Spoken& y) {
        return x.best.a != y.best.a ? x.best.a < y.best.a : x.best.b < y.best.b;
    });
}

/// Every pair of nodes whose hulls meet is a patch.
template <int Dim>
void FrontContacts<Dim>::model_hulls(const PosedFront<Dim>& front, const PairMotion<Dim>& motion,
                                     FrontModel<Dim>& found) {
    const PosedTree<Dim>& a = front.a;
    group_by_hulls(front);
    touches_.clear();
    posed_a_ = -1;
    posed_b_ = -1;
    found.node_pairs.resize(front.pairs.size());
    std::int32_t kept = 0;
    const Placement<Dim> b_in_a = seen_from(a.placement(), front.b.placement());
    for (const Spoken& group : spoken_) {
        const auto manifold = meet_nodes(front, b_in_a, group.best, motion);
        if (!manifold) continue;
        const std::int32_t first = kept;
        for (std::int32_t i = group.first; i >= 0; i = next_[at(i)])
            found.node_pairs[at(kept++)] = front.pairs[at(i)];
        if (!manifold->parts(motion)) touches_.push_back({*manifold, {first, kept - first}});
    }
    found.node_pairs.resize(at(kept));
    keep_deepest();
    for (const auto& [manifold, nodes] : touches_)
        for (std::size_t k = 0; k < manifold.count; ++k)
            found.contacts.push_back(
                {{a.position() + manifold.points[k], manifold.normal, manifold.depths[k]}, nodes});
}

/// Of more than most_patches the deepest, in their order; ties go to the first.
template <int Dim>
void FrontContacts<Dim>::keep_deepest() {
    if (touches_.size() <= most_patches) return;
    std::sort(touches_.begin(), touches_.end(), [](const Touch& x, const Touch& y) {
        const double depth_x = x.manifold.depth();
        const double depth_y = y.manifold.depth();
        return depth_x != depth_y ? depth_x > depth_y : x.nodes.first < y.nodes.first;
    });
    touches_.resize(most_patches);
    std::sort(touches_.begin(), touches_.end(),
              [](const Touch& x, const Touch& y) { return x.nodes.first < y.nodes.first; });
}

template <int Dim>
void FrontContacts<Dim>::model_balls(const PosedFront<Dim>& front, const ContactChoice& choice,
                                     const Vector<Dim>& fallback, FrontModel<Dim>& found) {
    const PosedTree<Dim>& a = front.a;
    const PosedTree<Dim>& b = front.b;
    const std::span<const NodePair> pairs = front.pairs;
    const bool by_border = a.is_half_space() || b.is_half_space();
    const bool by_surface = choice.contact_model != ContactModel::centre_line && !by_border;
    if (by_surface) find_patches(front);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Sphere<Dim> ball_a = a.sphere(pairs[i].a);
        const Sphere<Dim> ball_b = b.sphere(pairs[i].b);
        std::optional<Contact<Dim>> contact;
        if (by_border) {
            contact = border_contact(a, b, pairs[i], choice.point_model);
        } else if (by_surface) {
            const Patch& patch = patches_[at(patch_of(static_cast<std::int32_t>(i)))];
            contact = model_surface_contact<Dim>(node_of(ball_a, patch.a), node_of(ball_b, patch.b),
                                                 choice.point_model, fallback);
        } else {
            contact = model_contact<Dim>(ball_a, ball_b, choice.point_model, fallback);
        }
        if (!contact) continue;
        const Range nodes{static_cast<std::int32_t>(found.node_pairs.size()), 1};
        found.node_pairs.push_back(pairs[i]);
        found.contacts.push_back({*contact, nodes});
    }
}

template <int Dim>
void FrontContacts<Dim>::model(const PosedFront<Dim>& front, const ContactChoice& choice,
                               const PairMotion<Dim>& motion, FrontModel<Dim>& found) {
    found.node_pairs.clear();
    found.contacts.clear();
    if (touches_by_hulls(choice, front.a.tree(), front.b.tree()))
        model_hulls(front, motion, found);
    else
        model_balls(front, choice, motion.centre_b - motion.centre_a, found);
}

template <int Dim>
std::vector<Contact<Dim>> contacts_of_front(const Body<Dim>& a, const Body<Dim>& b,
                                            const Front& front, const ContactChoice& choice,
                                            double time_step) {
    PosedTree<Dim> world_a;
    PosedTree<Dim> world_b;
    world_a.pose(a);
    world_b.pose(b);
    FrontModel<Dim> found;
    FrontContacts<Dim>().model({world_a, world_b, front.pairs}, choice,
                               pair_motion(a, b, time_step), found);
    std::vector<Contact<Dim>> contacts;
    for (const PatchContact<Dim>& entry : found.contacts) contacts.push_back(entry.contact);
    return contacts;
}

template <int Dim>
std::optional<Contact<Dim>> root_contact(const PosedTree<Dim>& a, const PosedTree<Dim>& b) {
    if (a.is_half_space())
        return model_border_contact(b.root(), a.half_space(), true,
                                    PointModel::plane_of_intersection);
    if (b.is_half_space())
        return model_border_contact(a.root(), b.half_space(), false,
                                    PointModel::plane_of_intersection);
    return model_contact<Dim>(a.root(), b.root(), PointModel::radius_ratio,
                              b.position() - a.position());
}

#define LOD_INSTANTIATE(Dim)                                                  \
    template class FrontContacts<Dim>;                                        \
    template std::optional<Contact<Dim>> root_contact(const PosedTree<Dim>&,  \
                                                      const PosedTree<Dim>&); \
    template std::vector<Contact<Dim>> contacts_of_front(                     \
        const Body<Dim>&, const Body<Dim>&, const Front&, const ContactChoice&, double);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
