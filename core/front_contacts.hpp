#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/contact.hpp"
#include "lodlab/core/traversal.hpp"

namespace lod {

/// A contact and the two nodes behind it.
template <int Dim>
struct NodeContact {
    NodePair nodes;
    Contact<Dim> contact;
};

/// Models the contacts of a front, one for each of its node pairs.
///
/// With ContactModel::node_normal, pairs that share a node belong to one *patch*, a place where the
/// bodies touch: the nodes of two covered bodies overlap without a break wherever the bodies do.
/// For model_surface_contact a node stands for its body's whole side of the patch: the mean over
/// the patch's nodes of that body of their mean normals (nodes without surface left out). Where a
/// corner has sunk into a face, one small node knows one side of the corner only, and that as flat
/// as the face; together the corner's nodes are no more coherent than the corner is.
///
/// Keeps its storage: a warm call allocates nothing. Time is linear in the node pairs.
template <int Dim>
class FrontContacts {
  public:
    /// Writes the contacts in the order of the pairs, without those that meet only within the
    /// rounding of the distance test. `fallback` is model_contact's.
    /// Requires: the nodes of all pairs were carried.
    void model(const PosedTree<Dim>& a, const PosedTree<Dim>& b, std::span<const NodePair> pairs,
               ContactModel contact_model, PointModel point_model, const Vector<Dim>& fallback,
               std::vector<NodeContact<Dim>>& contacts);

  private:
    /// One body's side of a patch.
    struct Side {
        Vector<Dim> normal = Vector<Dim>::Zero();  ///< sum of mean normals, world frame
        double nodes = 0;                          ///< that have a surface
    };
    struct Patch {
        Side a;
        Side b;
    };

    void find_patches(const PosedTree<Dim>& a, const PosedTree<Dim>& b,
                      std::span<const NodePair> pairs);
    [[nodiscard]] std::int32_t patch_of(std::int32_t pair);
    void join(std::vector<std::int32_t>& first_pair, std::int32_t node, std::int32_t pair);

    std::vector<std::int32_t> first_a_;  ///< of each node of A: the first pair that has it, or -1
    std::vector<std::int32_t> first_b_;
    std::vector<std::int32_t> joined_;  ///< union-find over pairs; a patch is named by its root
    std::vector<Patch> patches_;        ///< of each root
};

/// The contacts of two bodies' front, for pictures, lessons and oracles.
template <int Dim>
[[nodiscard]] std::vector<Contact<Dim>> contacts_of_front(
    const Body<Dim>& a, const Body<Dim>& b, const Front& front, ContactModel contact_model,
    PointModel point_model = PointModel::radius_ratio);

extern template class FrontContacts<2>;
extern template class FrontContacts<3>;

}  // namespace lod
