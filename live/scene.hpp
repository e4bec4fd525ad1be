#pragma once

/// \file
/// A scene of the plane that a page can hold: bodies with their trees, how frames go, what is
/// shown; as text and back, to the same bits.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/frame/frame.hpp"
#include "lodlab/viz/draw/scene_view.hpp"

namespace live {

/// How far pictures and findings go.
enum class Told {
    answers,  ///< contacts, normals, impulses and velocities, too
    verdicts  ///< which nodes meet, and what follows for the bodies
};
/// Their words in scenes.
[[nodiscard]] constexpr std::array<std::string_view, 2> names_of(Told) {
    return {"answers", "verdicts"};
}
static_assert(names_of(Told{}).size() == static_cast<std::size_t>(Told::verdicts) + 1);

/// All that a page needs to run a scene without the files that it came from.
struct Scene {
    std::string name;
    std::string title;  ///< a sentence; the name where it is empty
    viz::Box view;      ///< what pictures show at least [m]
    lod::FrameSettings settings;
    std::optional<std::uint64_t> budget;  ///< node tests a frame; nothing: to the deepest level
    double pair_cost = 0;  ///< of a node pair, its contact and response, in node tests
    Told told = Told::answers;
    /// Outline, tree, mass and state of each. Bodies with one tree share its outline and its exact
    /// shape.
    std::vector<viz::Actor<2>> actors;
};

/// The scene as JSON, without loss.
///
///     {"lodlab": "live scene", "version": 1, "name", "title", "view": [low x, low y, high x, high
///     y],
///      "settings": as in traces, "fixation": [x, y, z], "budget": node tests or null, "pair_cost",
///      "told": a word of Told,
///      "shapes": [{"rings": [[x, y, x, y, ...]], "tree": io/tree_json.hpp}
///                 or {"rings", "half_space": [normal x, normal y]}],
///      "bodies": [{"name", "shape": its place in the list, "inverse_mass", "inertia",
///                  "inverse_inertia", "restitution", "position", "angle", "velocity", "spin"}]}
[[nodiscard]] std::string scene_text(const Scene& scene);

/// Reads what scene_text wrote, to the same bits. Throws lod::Error (input refused) where the text
/// is no such scene.
[[nodiscard]] Scene scene_from(std::string_view text);

}  // namespace live
