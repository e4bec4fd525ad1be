#pragma once

/// \file
/// What a page draws and tells of a stage: a figure as data, and numbers.

#include <string>

#include "lodlab/live/stage.hpp"
#include "lodlab/viz/figure/figure.hpp"

namespace live {

/// The stage as it stands, or a frame of it as of one of its events (Stage::event): the bodies,
/// what the event is about in full, what came before it pale, nothing that comes after. As it
/// stands: bodies, the nodes of each near pair's last level, a line for each pair of nodes that
/// meet, contacts with their normals, and the impulses of the last moments. Its caption is the
/// finding, in a sentence.
[[nodiscard]] viz::Figure picture(const Stage& stage);

/// Numbers of the stage for controls and machines, as JSON:
///
///     {"frame", "time", "hash": of the state, "level": asked for, "levels": of the deepest tree,
///      "tests", "dropped": tests of levels that were not finished, "by_level": tests of each,
///      "event": that the picture stands at, or null, "budget": or null, "reserved": by node pairs,
///      "left", "interrupted", "contacts", "contact": the deepest one, with v_c, K, e and j of
///      equation (1): {"a", "b", "normal", "closing", "K", "e", "j"}, or null, "energy", "pairs":
///      [{"a", "b", "level", "verdict", "tests", "contacts", "gap": or null, "stands_out"}],
///      "bodies": [{"name", "x", "y", "angle", "reach": radius of its root circle, "fixed": whether
///                  it is a half-space}]}
[[nodiscard]] std::string report(const Stage& stage);

/// What the next frame does (Stage::apart), as JSON:
///
///     {"events": [{"name", "kind", "a", "b": body numbers, "pair": their names, "short": the
///     sentence without places,
///                  "sentence"}]}
[[nodiscard]] std::string events_report(Stage& stage);

}  // namespace live
