#pragma once

#include <optional>
#include <span>

#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/response/response.hpp"

namespace lod {

/// A collision that was found ahead.
template <int Dim>
struct Event {
    double time = 0;                   ///< from now [s]
    std::vector<Impact<Dim>> impacts;  ///< every approaching contact of that moment
};

/// Event-driven motion of a few bodies: moves all of them freely to the first moment at which any
/// two of them collide, or for settings.horizon seconds if none do within it, and then returns
/// nothing. The response is the caller's: Resolver, with the event's impacts. Every pair is
/// searched anew, so the time grows with the square of the number of bodies: this is a reference,
/// not a way to simulate crowds.
/// Throws Error (limit exceeded) when bodies overlap or when a search reaches its cap; and as
/// time_of_impact does.
template <int Dim>
std::optional<Event<Dim>> advance_to_event(std::span<Body<Dim>> bodies,
                                           const ImpactSettings& settings = {});

}  // namespace lod
