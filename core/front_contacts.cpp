#include "lodlab/core/front_contacts.hpp"

#include <algorithm>
#include <utility>

namespace lod {
namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

/// The contact of two nodes, each with the mean normal of its side of their patch.
template <int Dim, class Side>
std::optional<Contact<Dim>> patch_contact(const Sphere<Dim>& a, const Side& side_a,
                                          const Sphere<Dim>& b, const Side& side_b,
                                          PointModel point_model, const Vector<Dim>& fallback) {
    const auto mean = [](const Side& side) -> Vector<Dim> {
        return side.nodes > 0 ? Vector<Dim>(side.normal / side.nodes) : side.normal;
    };
    return model_surface_contact<Dim>({a, mean(side_a)}, {b, mean(side_b)}, point_model, fallback);
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
void FrontContacts<Dim>::find_patches(const PosedTree<Dim>& a, const PosedTree<Dim>& b,
                                      std::span<const NodePair> pairs) {
    const auto count = static_cast<std::int32_t>(pairs.size());
    if (first_a_.size() < at(a.tree().size())) first_a_.resize(at(a.tree().size()), -1);
    if (first_b_.size() < at(b.tree().size())) first_b_.resize(at(b.tree().size()), -1);
    joined_.resize(pairs.size());
    for (std::int32_t i = 0; i < count; ++i) joined_[at(i)] = i;
    for (std::int32_t i = 0; i < count; ++i) {
        join(first_a_, pairs[at(i)].a, i);
        join(first_b_, pairs[at(i)].b, i);
    }
    patches_.assign(pairs.size(), {});
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
void FrontContacts<Dim>::model(const PosedTree<Dim>& a, const PosedTree<Dim>& b,
                               std::span<const NodePair> pairs, ContactModel contact_model,
                               PointModel point_model, const Vector<Dim>& fallback,
                               std::vector<NodeContact<Dim>>& contacts) {
    contacts.clear();
    const bool by_surface = contact_model == ContactModel::node_normal;
    if (by_surface) find_patches(a, b, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Sphere<Dim> ball_a = a.sphere(pairs[i].a);
        const Sphere<Dim> ball_b = b.sphere(pairs[i].b);
        std::optional<Contact<Dim>> contact;
        if (by_surface) {
            const Patch& patch = patches_[at(patch_of(static_cast<std::int32_t>(i)))];
            contact = patch_contact<Dim>(ball_a, patch.a, ball_b, patch.b, point_model, fallback);
        } else {
            contact = model_contact<Dim>(ball_a, ball_b, point_model, fallback);
        }
        if (contact) contacts.push_back({pairs[i], *contact});
    }
}

template <int Dim>
std::vector<Contact<Dim>> contacts_of_front(const Body<Dim>& a, const Body<Dim>& b,
                                            const Front& front, ContactModel contact_model,
                                            PointModel point_model) {
    PosedTree<Dim> world_a;
    PosedTree<Dim> world_b;
    world_a.pose(a);
    world_b.pose(b);
    for (const NodePair& nodes : front.pairs) {
        if (nodes.a > 0) world_a.carry_children(a.tree->parent[at(nodes.a)]);
        if (nodes.b > 0) world_b.carry_children(b.tree->parent[at(nodes.b)]);
    }
    std::vector<NodeContact<Dim>> modelled;
    FrontContacts<Dim>().model(world_a, world_b, front.pairs, contact_model, point_model,
                               b.position - a.position, modelled);
    std::vector<Contact<Dim>> contacts;
    for (const NodeContact<Dim>& entry : modelled) contacts.push_back(entry.contact);
    return contacts;
}

#define LOD_INSTANTIATE(Dim)                                                                 \
    template class FrontContacts<Dim>;                                                       \
    template std::vector<Contact<Dim>> contacts_of_front(const Body<Dim>&, const Body<Dim>&, \
                                                         const Front&, ContactModel, PointModel);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
