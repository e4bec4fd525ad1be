#pragma once

/// \file
/// Figures of contacts: ever more of them, and how one comes from two nodes.

#include "lodlab/core/contact/contact.hpp"
#include "lodlab/viz/draw/draw_scene.hpp"

namespace viz {

/// What contacts_by_level shows.
struct ContactsChoice {
    std::vector<int> levels{};  ///< empty: up to six, and none with more than 128 contacts
    lod::PointModel model = lod::PointModel::radius_ratio;
};

/// One face contact as ever more sphere contacts (the paper's figure 3): one panel a level, with
/// the nodes that intersect, the contact point of each pair and its normal, by the paper's model
/// (lod::ContactModel::centre_line).
template <int Dim>
[[nodiscard]] Figure contacts_by_level(const Actor<Dim>& a, const Actor<Dim>& b,
                                       const std::vector<lod::Front>& fronts,
                                       const ContactsChoice& choice = {},
                                       const typename DrawTraits<Dim>::Viewpoint& viewpoint = {});

/// How the contact point and normal of two overlapping nodes are found (the paper's figure 4): the
/// centre line, the point that divides it by the radii (eq. 5) and, beside it, the point on the
/// plane of intersection. Throws lod::Error (input refused) where the nodes are apart or share
/// their centre.
[[nodiscard]] Figure contact_construction(const lod::Sphere<2>& a, const lod::Sphere<2>& b);

}  // namespace viz
