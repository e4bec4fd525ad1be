#pragma once

/// \file
/// When two bodies would touch if the nodes of one level were their shapes; the paper's figure 5
/// shows why not to ask.

#include "lodlab/core/exact/time_of_impact.hpp"

namespace lod {

/// The moment at which two bodies would touch if the nodes of a level were their shapes: where
/// backtracking at that level would put them. "It would be highly infeasible to perform
/// backtracking at every level of detail" (section 4.2): above the leaves this is often a time of
/// contact of bodies that never touch (figure 5). The bodies of the result have their own exact
/// shapes again, and its `distance` is that of the nodes.
/// Requires: trees of both bodies. Throws Error as time_of_impact does.
template <int Dim>
[[nodiscard]] TimeOfImpact<Dim> level_impact(const Body<Dim>& a, const Body<Dim>& b, int level,
                                             const ImpactSettings& settings = {});

/// Two bodies where their true shapes are nearest to each other.
template <int Dim>
struct NearestApproach {
    double time = 0;  ///< [s]
    Body<Dim> a;
    Body<Dim> b;
    Separation<Dim> gap;
};

/// The nearest of `looks` moments spread evenly over the horizon of two freely moving bodies, both
/// ends included. Requires: exact shapes, looks >= 2.
template <int Dim>
[[nodiscard]] NearestApproach<Dim> nearest_approach(const Body<Dim>& a, const Body<Dim>& b,
                                                    const ImpactSettings& settings, int looks);

}  // namespace lod
