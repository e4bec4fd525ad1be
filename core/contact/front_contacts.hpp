#pragma once

/// \file
/// From the overlapping nodes of a pair of bodies to its contacts: the stage between traversal and
/// response.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/contact/hull_contact.hpp"
#include "lodlab/core/contact/hulls_apart.hpp"
#include "lodlab/core/tree/traversal.hpp"

namespace lod {

/// Places where two bodies touch, at most: of more, the deepest are kept.
inline constexpr std::size_t most_patches = 8;

/// Contacts of one front and the node pairs behind them.
template <int Dim>
struct PatchContact {
    Contact<Dim> contact;
    Range nodes;  ///< into FrontModel::node_pairs: those of its patch
};
/// What the contact model makes of a front.
template <int Dim>
struct FrontModel {
    std::vector<NodePair> node_pairs;  ///< that nothing proved apart, patch by patch
    std::vector<PatchContact<Dim>> contacts;
};

/// A front and the trees that its nodes are of, as they stand.
template <int Dim>
struct PosedFront {
    const PosedTree<Dim>& a;
    const PosedTree<Dim>& b;
    std::span<const NodePair> pairs;
};

/// Models the contacts of a front.
///
/// A *patch* is a place where the bodies touch. With ContactModel::hull it is two nodes whose hulls
/// meet: those of a pair of the front, or higher ones where a node's piece is part of a convex one
/// (NodeHulls::best); each gives a manifold (meet), none where all of it parts. Pairs whose hulls
/// are apart leave the front. Two nodes that are round (NodeHulls::is_round) touch as their balls
/// do. Where a body has no hulls, node normals stand for them.
///
/// With ContactModel::node_normal, pairs that share a node belong to one patch: the nodes of two
/// covered bodies overlap without a break wherever the bodies do. For model_surface_contact a node
/// stands for its body's whole side of the patch: the mean over the patch's nodes of that body of
/// their mean normals (nodes without surface left out). Where a corner has sunk into a face, one
/// small node knows one side of the corner only, and that as flat as the face; together the
/// corner's nodes are no more coherent than the corner is.
///
/// With ContactModel::centre_line each pair of the front is a patch of its own, as in the paper.
///
/// Keeps its storage: a warm call allocates nothing.
template <int Dim>
class FrontContacts {
  public:
    /// Replaces `found`. Requires: `motion` has its origin in A's centre of mass.
    void model(const PosedFront<Dim>& front, const ContactChoice& choice,
               const PairMotion<Dim>& motion, FrontModel<Dim>& found);

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
    /// Pairs of the front for which the same two hulls speak, as a list through next_.
    struct Spoken {
        NodePair best;
        std::int32_t first = 0;
        std::int32_t last = 0;
    };
    /// A place of the hash table of groups.
    struct Slot {
        std::uint64_t filled_for = 0;  ///< the front whose group it names
        std::int32_t group = 0;
    };
    struct Touch {
        Manifold<Dim> manifold;
        Range nodes;
    };

    void group_by_hulls(const PosedFront<Dim>& front);
    [[nodiscard]] std::int32_t group_of(const NodePair& best, std::size_t mask);
    void model_hulls(const PosedFront<Dim>& front, const PairMotion<Dim>& motion,
                     FrontModel<Dim>& found);
    [[nodiscard]] std::optional<Manifold<Dim>> meet_nodes(const PosedFront<Dim>& front,
                                                          const Placement<Dim>& b_in_a,
                                                          const NodePair& nodes,
                                                          const PairMotion<Dim>& motion);
    void keep_deepest();
    void model_balls(const PosedFront<Dim>& front, const ContactChoice& choice,
                     const Vector<Dim>& fallback, FrontModel<Dim>& found);
    void find_patches(const PosedFront<Dim>& front);
    [[nodiscard]] std::int32_t patch_of(std::int32_t pair);
    void join(std::vector<std::int32_t>& first_pair, std::int32_t node, std::int32_t pair);

    std::vector<Spoken> spoken_;
    std::vector<std::int32_t> next_;  ///< of each pair: the next of its group, or -1
    std::vector<Slot> slots_;
    std::uint64_t front_number_ = 0;
    std::vector<Touch> touches_;
    PosedHull<Dim> hull_a_;
    std::int32_t posed_a_ = -1;  ///< the node that hull_a_ is of
    PosedHull<Dim> hull_b_;
    std::int32_t posed_b_ = -1;
    std::vector<std::int32_t> first_a_;  ///< of each node of A: the first pair that has it, or -1
    std::vector<std::int32_t> first_b_;
    std::vector<std::int32_t> joined_;  ///< union-find over pairs; a patch is named by its root
    std::vector<Patch> patches_;        ///< of each root
};

/// Whether the contacts of two bodies are those of their nodes' hulls.
template <int Dim>
[[nodiscard]] bool touches_by_hulls(const ContactChoice& choice, const SphereTree<Dim>& a,
                                    const SphereTree<Dim>& b) {
    return choice.contact_model == ContactModel::hull && a.has_hulls() && b.has_hulls();
}

/// The contact of two bodies as that of their root balls, or of one and a half-space: where there
/// is no time for hulls. Nothing where rounding alone makes them meet.
template <int Dim>
[[nodiscard]] std::optional<Contact<Dim>> root_contact(const PosedTree<Dim>& a,
                                                       const PosedTree<Dim>& b);

/// The contacts of two bodies' front, for pictures, lessons and oracles. `time_step` is the frame's
/// (see meet); 0: as the bodies stand, wherever they come from.
template <int Dim>
[[nodiscard]] std::vector<Contact<Dim>> contacts_of_front(const Body<Dim>& a, const Body<Dim>& b,
                                                          const Front& front,
                                                          const ContactChoice& choice,
                                                          double time_step = 0);

extern template class FrontContacts<2>;
extern template class FrontContacts<3>;

}  // namespace lod
